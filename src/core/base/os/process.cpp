// Processes, signals, standard input and loaded libraries by the calls of POSIX and Linux.

#include "core/base/os/process.h"

#include <dlfcn.h>
#include <fcntl.h>
#include <link.h>
#include <poll.h>
#include <pthread.h>
#include <signal.h>
#include <spawn.h>
#ifdef __linux__
#include <sys/mman.h>
#endif
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <thread>
#include <utility>
#include <vector>

extern char** environ;

namespace taxel::os {
namespace {

int status_of(int status) {
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace

int process_id() {
  return ::getpid();
}

bool has_process(int id) {
  return ::kill(id, 0) == 0 || errno != ESRCH;
}

void end_process(int status) {
  ::_exit(status);
}

bool is_terminal_stderr() {
  return ::isatty(STDERR_FILENO) == 1;
}

void prepare_process() {
  for (const int number : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(number, F_GETFD) >= 0) continue;
    static_cast<void>(::open("/dev/null", number == STDIN_FILENO ? O_WRONLY : O_RDONLY));  // takes the lowest number
  }
  ::signal(SIGXFSZ, SIG_IGN);
}

std::string variable(const char* name) {
  const char* const value = std::getenv(name);
  return value != nullptr ? value : "";
}

void prefer_huge_pages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes) {
#ifdef __linux__
  ::madvise(memory, bytes, MADV_HUGEPAGE);  // no harm if it is refused
#endif
}

ChildProcess::~ChildProcess() {
  if (id_ == 0) return;
  ::kill(id_, SIGTERM);
  int status = 0;
  ::waitpid(id_, &status, 0);
}

bool ChildProcess::start(std::vector<std::string> arguments, const std::filesystem::path& errors,
                         const std::filesystem::path& output) {
  std::vector<char*> pointers;
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  constexpr int kNew = O_WRONLY | O_CREAT | O_TRUNC, kReadAndWrite = 0666;
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, 0, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&files, 1, output.empty() ? "/dev/null" : output.c_str(), kNew, kReadAndWrite);
  posix_spawn_file_actions_addopen(&files, 2, errors.c_str(), kNew, kReadAndWrite);
  pid_t id = 0;
  const int failed = ::posix_spawnp(&id, pointers[0], &files, nullptr, pointers.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  id_ = failed == 0 ? id : 0;
  return failed == 0;
}

std::optional<int> ChildProcess::ended() {
  int status = 0;
  if (::waitpid(id_, &status, WNOHANG) == 0) return std::nullopt;
  id_ = 0;
  return status_of(status);
}

int ChildProcess::wait() {
  int status = 0;
  while (::waitpid(id_, &status, 0) < 0 && errno == EINTR) {
  }
  id_ = 0;
  return status_of(status);
}

namespace {

constexpr std::array kSignals{SIGINT, SIGTERM, SIGHUP};

bool is_ignored(int number) {
  struct sigaction action {};
  return ::sigaction(number, nullptr, &action) != 0 || action.sa_handler == SIG_IGN;
}

}  // namespace

void receive_end_signals(std::function<void(int)> receive) {
  sigset_t signals;
  sigemptyset(&signals);
  for (const int number : kSignals)
    if (!is_ignored(number)) sigaddset(&signals, number);
  ::pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  std::thread([signals, receive = std::move(receive)] {
    int number = 0;
    while (::sigwait(&signals, &number) == 0) receive(number);
  }).detach();
}

void record_end_signals(void (*record)(int)) {
  struct sigaction action {};
  action.sa_handler = record;
  action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
  sigemptyset(&action.sa_mask);
  for (const int number : kSignals)
    if (!is_ignored(number)) ::sigaction(number, &action, nullptr);
}

const char* signal_name(int number) {
  return number == SIGINT ? "SIGINT" : number == SIGHUP ? "SIGHUP" : "SIGTERM";
}

namespace {

constexpr int kWaitMilliseconds = 100;
constexpr std::size_t kPartBytes = std::size_t{1} << 16U;

}  // namespace

/// Adds the bytes that are there to the buffer.
StandardInput::Result StandardInput::take_more() {
  pollfd input{STDIN_FILENO, POLLIN, 0};
  if (::poll(&input, 1, kWaitMilliseconds) <= 0) return Result::waiting;
  std::vector<char> part(kPartBytes);
  const ssize_t count = ::read(STDIN_FILENO, part.data(), part.size());
  if (count < 0 && (errno == EINTR || errno == EAGAIN)) return Result::waiting;
  if (count <= 0) return Result::ended;
  buffer_.append(part.data(), static_cast<std::size_t>(count));
  return Result::done;
}

StandardInput::Result StandardInput::take_line(std::string& line) {
  for (;;) {
    const std::size_t end = buffer_.find('\n', searched_);
    if (end != std::string::npos) {
      line = buffer_.substr(0, end);
      buffer_.erase(0, end + 1);
      searched_ = 0;
      return Result::done;
    }
    searched_ = buffer_.size();
    if (const Result result = take_more(); result != Result::done) return result;
  }
}

StandardInput::Result StandardInput::take_bytes(std::string& bytes, std::size_t size) {
  while (buffer_.size() < size)
    if (const Result result = take_more(); result != Result::done) return result;
  bytes = buffer_.substr(0, size);
  buffer_.erase(0, size);
  searched_ = 0;
  return Result::done;
}

namespace {

int add_name(dl_phdr_info* info, std::size_t, void* names) {
  if (info->dlpi_name != nullptr) static_cast<std::vector<std::string>*>(names)->emplace_back(info->dlpi_name);
  return 0;
}

}  // namespace

std::vector<LoadedLibrary> loaded_libraries(const std::string& prefix) {
  std::vector<std::string> names;
  ::dl_iterate_phdr(add_name, &names);
  std::vector<LoadedLibrary> found;
  for (const std::string& name : names) {
    if (name.compare(name.rfind('/') + 1, prefix.size(), prefix) != 0) continue;  // npos + 1 is 0
    void* handle = ::dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NOLOAD);
    const bool is_listed = std::any_of(found.begin(), found.end(), [&](const auto& l) { return l.handle == handle; });
    if (handle != nullptr && !is_listed) found.push_back({name, handle});
  }
  return found;
}

void* find_function(const LoadedLibrary& library, const char* name) {
  return ::dlsym(library.handle, name);
}

std::string file_of_function(void* address) {
  Dl_info info{};
  return ::dladdr(address, &info) != 0 && info.dli_fname != nullptr ? info.dli_fname : "";
}

}  // namespace taxel::os
