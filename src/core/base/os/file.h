// Files below the level of the standard library: opened without waiting, locked, and written through to the disk.
// Errors are numbers as in errno, 0 without an error.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace taxel::os {

enum class Open {
  read,          ///< reads a file, without waiting for the writer of a pipe
  replace,       ///< replaces the content of a file; created if missing
  append,        ///< writes at the end of a file for this user only; created if missing, never a link
  hold,          ///< locks a file for this user only; created if missing
  check,         ///< looks at a file or folder to lock it, never a link
  folder,        ///< a folder, to write its entries to the disk
  create_folder  ///< creates a folder and opens it
};

enum class Kind { unknown, file, folder, other };

/// An open file or folder. A moved-from object is not open.
class File {
 public:
  File() = default;
  /// Opens a path; error() is set if this fails. The file is closed in programs that this one starts.
  File(const std::filesystem::path& path, Open how);
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
  [[nodiscard]] int read_all(std::string& bytes, std::uint64_t max_bytes) const;  ///< stops after more than `max_bytes`
  /// Reads `size` bytes from `offset`, or fewer at the end of the file, without moving the place of other calls.
  [[nodiscard]] int read_at(std::string& bytes, std::uint64_t offset, std::size_t size) const;
  [[nodiscard]] int write(std::string_view bytes) const;  ///< writes all bytes
  /// Passes all bytes to the system in one call, so that a killed process has written all of them or none.
  [[nodiscard]] int write_at_once(std::string_view bytes) const;
  [[nodiscard]] int clear() const;  ///< removes the content
  [[nodiscard]] int sync() const;   ///< waits until all written bytes are on the disk

 private:
  int number_ = -1, error_ = 0;
};

[[nodiscard]] std::string error_text(int error);
[[nodiscard]] bool is_missing(int error);   ///< a file or a folder above it does not exist
[[nodiscard]] bool has_no_file(int error);  ///< the path is a socket, which cannot be opened as a file

}  // namespace taxel::os
