// Loaded before the program: from the 50th time on that somebody asks for the time of day, it is a day earlier.
#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>
#include <ctime>

extern "C" int clock_gettime(clockid_t clock, timespec* time) noexcept {
  static std::atomic<int> asked = 0;
  constexpr int kSetBackAfter = 50, kDay = 86400;
  const auto status = static_cast<int>(::syscall(SYS_clock_gettime, clock, time));
  if (clock == CLOCK_REALTIME && ++asked > kSetBackAfter) time->tv_sec -= kDay;
  return status;
}
