// This process, others, and programs that this one starts.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace taxel::os {

[[nodiscard]] int process_id();             ///< id of this process
[[nodiscard]] bool has_process(int id);     ///< true if a process with this id runs on this machine
[[noreturn]] void end_process(int status);  ///< ends this process at once, without destructors
[[nodiscard]] bool is_terminal_stderr();    ///< true if somebody reads the messages in a terminal

/// Prepares a program's own process before it opens a file. Standard files that are closed get numbers that fail to be
/// read and written, so that no other file gets the number of stdout and messages in its content. A limit of the size
/// of files (`ulimit -f`) becomes an error of writing, after which temporary files are removed, instead of a signal.
void prepare_process();

/// A program that runs at the same time as this one. It is ended with the object.
class ChildProcess {
 public:
  ChildProcess() = default;
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Starts a program, which is found in PATH, without a shell. The first argument is its name. It reads
  /// nothing; its errors go to the file `errors`, and its output to the file `output`, or nowhere if the name is empty.
  /// Returns false if there is no such program.
  [[nodiscard]] bool start(std::vector<std::string> arguments, const std::filesystem::path& errors,
                           const std::filesystem::path& output = {});
  [[nodiscard]] bool runs() const { return id_ != 0; }  ///< true from start() until ended() has returned a status
  /// Returns the exit status of a program that has ended, or -1 if a signal ended it. Returns nothing while it runs.
  std::optional<int> ended();
  /// Waits for the end of the program, and returns its status as ended() does.
  int wait();

 private:
  int id_ = 0;
};

}  // namespace taxel::os
