#include "core/base/disk_cache.h"

#include <algorithm>
#include <chrono>
#include <system_error>
#include <vector>

#include "core/base/error.h"
#include "core/base/files.h"

namespace taxel {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kMagic = "taxel cache 1\n";
constexpr const char* kExtension = ".cached";
constexpr std::size_t kHash = 64;  // characters of a hash

/// Returns the beginning of a file: its format, and a hash of key and value.
std::string head_of(const std::string& key, std::string_view value) {
  return std::string(kMagic) + sha256_hex(key + "\n" + sha256_hex(value)) + "\n";
}

/// A value as a file.
struct CachedFile {
  fs::path path;
  std::uint64_t bytes = 0;
  fs::file_time_type used;
};

/// Returns true if a file has the name of a value.
bool is_value(const fs::path& path) {
  const std::string stem = path.stem().string();
  return path.extension() == kExtension && stem.size() == kHash &&
         stem.find_first_not_of("0123456789abcdef") == std::string::npos;
}

/// Returns the values of a folder. Other processes may remove some meanwhile: these are left out.
std::vector<CachedFile> values_in(const fs::path& folder) {
  std::vector<CachedFile> files;
  std::error_code failure;
  for (fs::directory_iterator entry(folder, failure), end; !failure && entry != end; entry.increment(failure)) {
    std::error_code gone;
    if (!is_value(entry->path()) || !entry->is_regular_file(gone)) continue;
    CachedFile file{entry->path(), entry->file_size(gone), {}};
    if (gone) continue;
    file.used = entry->last_write_time(gone);
    if (!gone) files.push_back(std::move(file));
  }
  return files;
}

DiskCache::Content sum_of(const std::vector<CachedFile>& files) {
  DiskCache::Content sum;
  for (const CachedFile& file : files) ++sum.values, sum.bytes += file.bytes;
  return sum;
}

}  // namespace

fs::path DiskCache::file_of(const std::string& key) const {
  return folder_ / (sha256_hex(key) + kExtension);
}

std::optional<std::string> DiskCache::find(const std::string& key) const {
  const fs::path file = file_of(key);
  std::error_code ignored;
  if (!fs::exists(file, ignored)) return std::nullopt;
  try {
    std::string bytes = read_file(file);
    const std::size_t head = kMagic.size() + kHash + 1;
    if (bytes.size() < head || bytes.compare(0, head, head_of(key, std::string_view(bytes).substr(head))) != 0) {
      fs::remove(file, ignored);
      return std::nullopt;
    }
    fs::last_write_time(file, fs::file_time_type::clock::now(), ignored);
    bytes.erase(0, head);
    return bytes;
  } catch (const Error&) {
    return std::nullopt;  // another process has removed it, or it cannot be read
  }
}

void DiskCache::keep(const std::string& key, std::string_view value) const {
  if (value.size() > max_bytes_) return;
  try {
    make_folder(folder_);
    write_file_atomically(file_of(key), head_of(key, value) + std::string(value));
  } catch (const Error&) {
    return;  // no place for a cache
  }
  remove_oldest();
}

void DiskCache::remove_oldest() const {
  std::vector<CachedFile> files = values_in(folder_);
  std::uint64_t left = sum_of(files).bytes;
  if (left <= max_bytes_) return;
  std::sort(files.begin(), files.end(), [](const CachedFile& a, const CachedFile& b) { return a.used < b.used; });
  std::error_code ignored;
  for (const CachedFile& file : files) {
    if (left <= max_bytes_) break;
    fs::remove(file.path, ignored);
    left -= file.bytes;
  }
}

DiskCache::Content DiskCache::content() const {
  return sum_of(values_in(folder_));
}

DiskCache::Content DiskCache::clear() const {
  Content removed;
  std::error_code failure;
  for (const CachedFile& file : values_in(folder_))
    if (fs::remove(file.path, failure)) ++removed.values, removed.bytes += file.bytes;
  return removed;
}

}  // namespace taxel
