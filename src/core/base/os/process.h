// This process and others: programs that it starts, signals that ask it to end, bytes of its standard input, shared
// libraries that it has loaded, and its memory.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
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

/// Returns a variable of the environment, empty if it is not set.
[[nodiscard]] std::string variable(const char* name);

/// Asks for pages of 2 MiB, which need one page fault instead of 512. Does nothing on systems without them.
void prefer_huge_pages(void* memory, std::size_t bytes);

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

// Signals that ask a program to end: SIGINT, SIGTERM and SIGHUP. A signal that the parent process ignores, as nohup
// does with SIGHUP, stays ignored.

/// Starts a thread that calls `receive` with the number of each such signal. Call this before any other thread starts.
void receive_end_signals(std::function<void(int)> receive);

/// Calls `record` with the number of the first signal of each kind, at any place of the program, so that it may only
/// set atomic variables. A second signal of the same kind ends the program at once.
void record_end_signals(void (*record)(int));

/// Returns the name of a signal for messages, such as "SIGTERM".
[[nodiscard]] const char* signal_name(int number);

/// A buffered reader of the standard input. A process has at most one, and uses no other reader of it.
class StandardInput {
 public:
  enum class Result { done, waiting, ended };

  /// Takes the next line, without its newline, or returns `waiting` if none has come within a tenth of a second.
  /// Returns `ended` at the end of the input; the bytes of a last line without a newline are lost.
  Result take_line(std::string& line);
  /// Takes the next `size` bytes as take_line() takes a line.
  Result take_bytes(std::string& bytes, std::size_t size);

 private:
  Result take_more();

  std::string buffer_;
  std::size_t searched_ = 0;  // bytes of the buffer that have no newline
};

/// A shared library in this process. It stays loaded from now on.
struct LoadedLibrary {
  std::string file;        ///< path from which it was loaded
  void* handle = nullptr;  ///< handle for find_function()
};

/// Returns the libraries of this process whose file names begin with `prefix`, in the order of their loading. Loads
/// nothing.
std::vector<LoadedLibrary> loaded_libraries(const std::string& prefix);

/// Returns the address of a function of a library, or null if the library has no function of this name.
void* find_function(const LoadedLibrary& library, const char* name);

/// Returns the file of the library or program that has a function at this address; empty if unknown.
std::string file_of_function(void* address);

}  // namespace taxel::os
