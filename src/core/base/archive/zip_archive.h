// The members of a zip archive, each checked whole before its content is used.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>

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
  /// The same of bytes in memory; `file` names them in messages.
  ZipArchive(std::string file, std::string bytes);
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
  std::shared_ptr<zip> archive_;  ///< reads `bytes_`
  std::map<std::string, Member> members_;
  mutable std::map<std::string, std::uint64_t> unpacked_;  ///< sizes of the members that were read
};

}  // namespace taxel
