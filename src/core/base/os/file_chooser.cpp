#include "core/base/os/file_chooser.h"

#include <portable_file_dialogs.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <utility>

namespace taxel::os {
namespace {

/// Returns names and patterns in turn, as the library takes them.
std::vector<std::string> names_and_patterns(const std::vector<FileFilter>& filters) {
  std::vector<std::string> texts;
  for (const FileFilter& filter : filters) texts.insert(texts.end(), {filter.name, filter.patterns});
  return texts;
}

/// The running program. The library's public types hide the exit status, by which Cancel differs from an error.
class ChooserProgram final : public pfd::internal::file_dialog {
 public:
  explicit ChooserProgram(const FileQuestion& question)
      : file_dialog(question.saves ? type::save : type::open, question.title, question.start,
                    names_and_patterns(question.filters)) {}

  /// Returns the exit status of the program, which has ended, and its output.
  [[nodiscard]] std::pair<int, std::string> result() const {
    int status = -1;
    std::string output = m_async->result(&status);
    return {status, std::move(output)};
  }
};

/// Returns the reply of a program that has ended. All of them print a path with status 0 and cancel with status 1. A
/// signal that ends a program counts as status 0, without a path.
FileReply reply_of(int status, std::string output) {
  constexpr int kCancelled = 1;
  if (status == kCancelled) return {FileReply::Kind::cancelled, "", ""};
  if (output.ends_with('\n')) output.pop_back();
  while (output.size() > 1 && output.back() == '/') output.pop_back();
  if (status != 0) return {FileReply::Kind::failed, "", "exit status " + std::to_string(status)};
  if (!output.starts_with('/')) return {FileReply::Kind::failed, "", "no path was returned"};
  return {FileReply::Kind::chosen, std::move(output), ""};
}

/// Returns whether a program that this one has started has ended and its status is not read yet, or no program runs.
bool has_ended_program() {
  siginfo_t ended{};
  return ::waitid(P_ALL, 0, &ended, WEXITED | WNOHANG | WNOWAIT) != 0 || ended.si_pid != 0;
}

class ProgramChooser final : public FileChooser {
 public:
  ProgramChooser() = default;
  ~ProgramChooser() override { end(); }
  ProgramChooser(const ProgramChooser&) = delete;
  ProgramChooser& operator=(const ProgramChooser&) = delete;

  void open(const FileQuestion& question) override { program_ = std::make_unique<ChooserProgram>(question); }

  std::optional<FileReply> poll() override {
    // The library reads the output before the status, and loses output that is written between the two. After the end
    // of the program the output is complete: the first call reads it, and the second one reads the status.
    if (!program_ || !has_ended_program() || !(program_->ready(0) || program_->ready(0))) return std::nullopt;
    auto [status, output] = program_->result();
    program_.reset();
    return reply_of(status, std::move(output));
  }

  void close() override { end(); }

 private:
  /// Ends the program, because the library's destructor would wait for the user. Only a program that runs is killed:
  /// the library's process id of a program that it could not start means all processes to kill().
  void end() {
    if (program_ && !program_->ready(0)) program_->kill();
    program_.reset();
  }

  std::unique_ptr<ChooserProgram> program_;
};

}  // namespace

bool has_file_chooser() {
  const char* const path = std::getenv("PATH");
  std::istringstream folders(path != nullptr ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');) {
    for (const char* const name : std::array{"zenity", "kdialog", "qarma", "matedialog"}) {
      const std::filesystem::path program = std::filesystem::path(folder) / name;
      std::error_code ignored;
      if (std::filesystem::is_regular_file(program, ignored) && ::access(program.c_str(), X_OK) == 0) return true;
    }
  }
  return false;
}

std::unique_ptr<FileChooser> make_file_chooser() {
  return std::make_unique<ProgramChooser>();
}

}  // namespace taxel::os
