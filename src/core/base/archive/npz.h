// NumPy arrays in a zip of .npy files, read and written, and the zip archive below, each of whose members
// is checked whole before its content is used. Equal values give equal bytes.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

struct zip;

namespace taxel {

/// A zip archive in memory. A member is unpacked when it is requested; others are never unpacked.
///
/// An archive of 1 MB may announce members of 1 GB. The requested members may unpack to kFreeBytes and kMaxRatio times
/// the archive's size, together; the announced size is compared before memory is taken for it.
class ZipArchive {
 public:
  static constexpr std::uint64_t kFreeBytes = std::uint64_t{128} << 20;
  static constexpr std::uint64_t kMaxRatio = 32;

  /// Throws Error if the file cannot be read, or is not a consistent zip archive.
  explicit ZipArchive(const std::filesystem::path& path);
  /// The same of bytes in memory; `file` names them in messages. The requested members may unpack to `free_bytes` in
  /// place of kFreeBytes.
  ZipArchive(std::string file, std::string bytes, std::uint64_t free_bytes = kFreeBytes);
  [[nodiscard]] const std::string& file() const { return file_; }
  [[nodiscard]] bool has(const std::string& name) const { return members_.contains(name); }
  /// Returns a member's bytes. Throws Error if there is no such member, its announced size is above the limit, or its
  /// content differs from its checksum (CRC-32).
  [[nodiscard]] std::string read(const std::string& name) const;

 private:
  struct Member {
    std::uint64_t index = 0, size = 0;
  };
  void list_members();

  std::string file_;
  std::shared_ptr<const std::string> bytes_;
  std::uint64_t free_bytes_ = kFreeBytes;
  std::shared_ptr<zip> archive_;  ///< reads `bytes_`
  std::map<std::string, Member> members_;
  mutable std::map<std::string, std::uint64_t> unpacked_;  ///< sizes of the members that were read
};

/// Collects arrays, then builds the archive. Format: NPY 1.0, little endian, C order (NumPy enhancement proposal 1).
/// Texts are UTF-8 in the arguments and UCS-4 (`<U`) in the file. Members have a fixed date, so two archives of the
/// same arrays are equal.
class NpzWriter {
 public:
  using Shape = std::vector<std::size_t>;
  enum class Packing {
    stored,   ///< for programs that map arrays into memory
    deflated  ///< several times smaller if most numbers are 0
  };
  void add(const std::string& name, const Shape& shape, std::span<const double> values);
  void add(const std::string& name, const Shape& shape, std::span<const float> values);
  void add(const std::string& name, const Shape& shape, std::span<const std::int64_t> values);
  void add(const std::string& name, const std::vector<std::string>& texts);  ///< array with one dimension
  void add(const std::string& name, const std::string& text);                ///< array without dimensions
  /// Adds a member that is not an array, under its whole name. NumPy returns its bytes.
  void add_file(const std::string& name, std::string bytes) { members_.emplace_back(name, std::move(bytes)); }
  /// Returns the bytes of the archive. Throws Error if libzip fails.
  [[nodiscard]] std::string bytes(Packing packing = Packing::stored) const;

 private:
  std::vector<std::pair<std::string, std::string>> members_;  ///< file names and bytes
};

/// Reader of an archive written by NpzWriter or NumPy. An array is unpacked when it is read, within the limits of
/// ZipArchive. Every reading function throws Error naming file and array if the array does not exist, has another type,
/// or does not match its checksum.
class NpzReader {
 public:
  using Shape = NpzWriter::Shape;
  /// Throws Error if the file cannot be read or is not a zip archive.
  explicit NpzReader(const std::filesystem::path& path) : archive_(path) {}
  explicit NpzReader(ZipArchive archive) : archive_(std::move(archive)) {}
  [[nodiscard]] bool has(const std::string& name) const { return archive_.has(name + ".npy"); }
  [[nodiscard]] Shape shape(const std::string& name) const { return at(name).shape; }
  /// Size in an expected shape that allows a dimension of any size.
  static constexpr std::size_t kAny = static_cast<std::size_t>(-1);
  /// Values of 64 or 32 bits.
  [[nodiscard]] std::vector<double> doubles(const std::string& name, const Shape& shape) const;
  [[nodiscard]] std::vector<std::int64_t> integers(const std::string& name, const Shape& shape) const;
  /// UTF-8, at most one dimension. Throws Error as all reading functions do.
  [[nodiscard]] std::vector<std::string> texts(const std::string& name) const;
  /// Exactly one text. Throws Error for another number of them.
  [[nodiscard]] std::string text(const std::string& name) const;
  [[nodiscard]] const std::string& file() const { return archive_.file(); }

 private:
  struct Array {
    std::string type;  ///< type in the notation of NPY, such as "<f8"
    Shape shape;
    std::string data;
    std::size_t count = 1;
  };
  [[nodiscard]] Array at(const std::string& name) const;
  template <class T>
  [[nodiscard]] std::vector<T> numbers(const std::string& name, const Array& array, const std::string& type,
                                       const Shape& shape) const;

  ZipArchive archive_;
};

/// Returns the bytes of a member that is not an array, by its whole name; empty if there is no such member. Throws
/// Error if the archive cannot be read.
std::string read_archive_member(const std::filesystem::path& path, const std::string& name);

}  // namespace taxel
