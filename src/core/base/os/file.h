// Files below the level of the standard library: opened without waiting, locked, and written through to the disk. The
// folders of the user. Errors are numbers as in errno, 0 without an error.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace taxel::os {

enum class Open {
  read,            ///< reads a file, without waiting for the writer of a pipe
  create,          ///< a new file with the rights of the umask; the name must be free
  create_private,  ///< a new file for this user only; the name must be free
  write,           ///< writes into something that exists, without waiting for readers
  append,          ///< writes at the end of a file for this user only; created if missing, never a link
  hold,            ///< locks a file for this user only; created if missing, never a link
  check,           ///< looks at a file or folder to lock it, never a link
  folder,          ///< a folder, to write its entries to the disk
  create_folder    ///< creates a folder for this user only and opens it
};

/// `disk` is a device with blocks, `other` a terminal or another device, a pipe or a socket.
enum class Kind { unknown, file, folder, disk, other };

/// The kind, rights and identity of a file.
struct Status {
  Kind kind = Kind::unknown;
  unsigned rights = 0;            ///< bits of the mode without the kind
  unsigned owner = 0, group = 0;  ///< ids of the user and the group
  std::uint64_t links = 0;        ///< number of names that the file has
  std::uint64_t device = 0, inode = 0;
};

/// An open file or folder. A moved-from object is not open.
class File {
 public:
  File() = default;
  /// Opens a path; error() is set if this fails. The file is closed in programs that this one starts.
  File(const std::filesystem::path& path, Open how);
  /// Takes an open descriptor, or one below 0, which is no file.
  static File of_number(int number) {
    File file;
    file.number_ = number;
    return file;
  }
  ~File() { close(); }
  File(File&& other) noexcept;
  File& operator=(File&& other) noexcept;
  File(const File&) = delete;
  File& operator=(const File&) = delete;

  [[nodiscard]] bool is_open() const { return number_ >= 0; }
  [[nodiscard]] int error() const { return error_; }  ///< error of opening, or 0
  void close();

  /// Locks the file against other processes, until it is closed. Returns false if another process has locked it.
  [[nodiscard]] bool try_lock() const;
  [[nodiscard]] Kind kind() const;           ///< `unknown` if the system does not say
  [[nodiscard]] std::uint64_t size() const;  ///< [bytes]
  /// Gives the file the owner, group and rights of another. Returns false if this user may not.
  [[nodiscard]] bool take_rights(const Status& from) const;
  [[nodiscard]] int read_all(std::string& bytes, std::uint64_t max_bytes) const;  ///< stops after more than `max_bytes`
  /// Reads `size` bytes from `offset`, or fewer at the end of the file, without moving the place of other calls.
  [[nodiscard]] int read_at(std::string& bytes, std::uint64_t offset, std::size_t size) const;
  [[nodiscard]] int write(std::string_view bytes) const;  ///< writes all bytes
  /// Passes all bytes to the system in one call, so that a killed process has written all of them or none.
  [[nodiscard]] int write_at_once(std::string_view bytes) const;
  [[nodiscard]] int cut(std::uint64_t size) const;      ///< removes all bytes after `size`
  [[nodiscard]] int reserve(std::uint64_t size) const;  ///< makes room on the disk for `size` bytes
  [[nodiscard]] int sync() const;                       ///< waits until all written bytes are on the disk

 private:
  int number_ = -1, error_ = 0;
};

/// Describes the file or folder at a path, behind links.
[[nodiscard]] int look_at(const std::filesystem::path& path, Status& out);
[[nodiscard]] bool can_write(const std::filesystem::path& path);
/// Returns whether a file has an access control list, which says more than its rights.
[[nodiscard]] bool has_access_list(const std::filesystem::path& path);
/// Returns the standard output or error of this process if it is the file that `status` describes, else a closed file.
[[nodiscard]] File standard_output_of(const Status& status);
/// Creates a folder and its parents, with the rights of the umask, and calls on_made() with each that this call has
/// made, from the top. Other processes may make and remove the same parents meanwhile. Does nothing if there is
/// something of this name.
[[nodiscard]] int create_folders(const std::filesystem::path& path,
                                 const std::function<void(const std::filesystem::path&)>& on_made);
void remove_empty_folder(const std::filesystem::path& path);  ///< does nothing if the folder has an entry

[[nodiscard]] std::string error_text(int error);
[[nodiscard]] bool is_missing(int error);   ///< a file or a folder above it does not exist
[[nodiscard]] bool has_no_file(int error);  ///< a socket, which cannot be opened, or a pipe that nobody reads
[[nodiscard]] bool is_taken(int error);     ///< there is something of this name already

// Folders of the user, where the XDG Base Directory Specification has them.

/// Returns $XDG_CONFIG_HOME, or ~/.config if the variable is not set: for settings.
[[nodiscard]] std::filesystem::path config_folder();
/// Returns $XDG_STATE_HOME, or ~/.local/state if the variable is not set: for files that the next start needs.
[[nodiscard]] std::filesystem::path state_folder();
/// Returns $XDG_CACHE_HOME, or ~/.cache if the variable is not set: for files that may be removed at any time.
[[nodiscard]] std::filesystem::path cache_folder();

}  // namespace taxel::os
