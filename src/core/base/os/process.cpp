#include "core/base/os/process.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>

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

}  // namespace taxel::os
