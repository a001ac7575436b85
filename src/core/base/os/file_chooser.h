// The desktop's own file dialog, which another program displays: zenity, kdialog, qarma or matedialog.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace taxel::os {

/// A choice of the files that a dialog lists.
struct FileFilter {
  std::string name;      ///< name for the user
  std::string patterns;  ///< patterns of file names, such as "*.csv *.tsv"
};

/// A request for one file.
struct FileQuestion {
  bool saves = false;               ///< asks for the name of a file to write, otherwise for an existing file
  std::string title;                ///< title of the dialog
  std::string start;                ///< folder, or path of the proposed file
  std::vector<FileFilter> filters;  ///< choices of listed files, the active one first
};

/// The user's reply, or the reason why there is none.
struct FileReply {
  enum class Kind { chosen, cancelled, failed };
  Kind kind = Kind::cancelled;
  std::string path;     ///< absolute path if a file was chosen
  std::string problem;  ///< reason if the dialog failed
};

/// A dialog of the desktop that asks for one file at a time. Closing the dialog ends its program.
class FileChooser {
 public:
  FileChooser() = default;
  virtual ~FileChooser() = default;
  FileChooser(const FileChooser&) = delete;
  FileChooser& operator=(const FileChooser&) = delete;

  /// Opens the dialog. No other dialog of this object may be open. If the dialog cannot be opened, poll() says why.
  virtual void open(const FileQuestion& question) = 0;
  /// Returns the reply to the last question once, and nothing before the user has replied. Does not wait.
  virtual std::optional<FileReply> poll() = 0;
  /// Closes the dialog, if it is open, without a reply.
  virtual void close() = 0;
};

/// Returns whether PATH has a program that can display the dialog.
[[nodiscard]] bool has_file_chooser();

/// Returns the desktop's dialog. The first open() takes about 0.1 s, in which the programs are searched.
[[nodiscard]] std::unique_ptr<FileChooser> make_file_chooser();

}  // namespace taxel::os
