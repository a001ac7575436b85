// A cache on disk: values by key in one folder, which all processes of a user share.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace taxel {

/// Each value is a file whose name is the hash of its key. A value is written to a temporary file that is then renamed,
/// so that other processes find all of it or nothing. The file starts with a hash of key and value: a damaged file
/// counts as absent. The values take at most `max_bytes`: those that were not used for the longest time are removed.
///
/// Nothing here fails because of the disk: a value that cannot be kept is computed again. May be used from any thread.
class DiskCache {
 public:
  DiskCache(std::filesystem::path folder, std::uint64_t max_bytes)
      : folder_(std::move(folder)), max_bytes_(max_bytes) {}

  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  [[nodiscard]] std::uint64_t max_bytes() const { return max_bytes_; }

  /// Returns the value of a key, and marks it as used now. Removes its file if it is damaged.
  [[nodiscard]] std::optional<std::string> find(const std::string& key) const;
  /// Keeps a value, if it is not larger than the bound, and removes others until all are within the bound.
  void keep(const std::string& key, std::string_view value) const;

  /// Number and size of the values.
  struct Content {
    std::size_t values = 0;
    std::uint64_t bytes = 0;
  };
  [[nodiscard]] Content content() const;
  /// Removes all values, and nothing else that the folder may have. Returns the removed ones.
  [[nodiscard]] Content clear() const;

 private:
  [[nodiscard]] std::filesystem::path file_of(const std::string& key) const;
  void remove_oldest() const;

  std::filesystem::path folder_;
  std::uint64_t max_bytes_;
};

}  // namespace taxel
