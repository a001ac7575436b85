// A library that is loaded before the program. While the file edited.json is in its folder, the time of day is a day
// earlier.
#include <sys/syscall.h>
#include <unistd.h>

#include <ctime>

extern "C" int clock_gettime(clockid_t clock, timespec* time) noexcept {
  constexpr int kDay = 86400;
  const auto status = static_cast<int>(::syscall(SYS_clock_gettime, clock, time));
  if (clock == CLOCK_REALTIME && ::access("edited.json", F_OK) == 0) time->tv_sec -= kDay;
  return status;
}
