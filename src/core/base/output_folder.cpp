#include "core/base/output_folder.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <system_error>

#include "core/base/error.h"
#include "core/base/files.h"

namespace taxel {
namespace fs = std::filesystem;
namespace {

/// The highest folder above (or at) `path` that does not exist yet; empty where all do.
fs::path first_missing(const fs::path& path) {
  std::error_code ec;
  fs::path missing;
  for (fs::path at = path; !at.empty() && !fs::exists(at, ec); at = at.parent_path()) missing = at;
  return missing;
}

}  // namespace

OutputFolder::OutputFolder(const fs::path& folder) : folder_(fs::absolute(folder).lexically_normal()) {
  if (folder_.filename().empty()) folder_ = folder_.parent_path();
  topmost_made_ = first_missing(folder_);
  staging_ = folder_ / fmt::format(".taxel-{}.part", ::getpid());
  try {
    make_folder(folder_);
    make_folder(staging_);
  } catch (const Error& e) {
    std::error_code ec;
    if (!topmost_made_.empty()) fs::remove_all(topmost_made_, ec);
    throw Error(folder.string(), e.message());
  }
}

OutputFolder::~OutputFolder() {
  std::error_code ec;
  fs::remove_all(staging_, ec);
  if (!committed_ && !topmost_made_.empty()) fs::remove_all(topmost_made_, ec);
}

void OutputFolder::write(const std::string& name, std::string_view bytes) {
  write_file_atomically(staging_ / name, bytes);
}

std::vector<std::string> OutputFolder::commit() {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(staging_)) {
    names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  for (const std::string& name : names) {
    std::error_code ec;
    if (fs::is_directory(staging_ / name, ec)) fs::remove_all(folder_ / name, ec);
    fs::rename(staging_ / name, folder_ / name, ec);
    if (ec) throw Error((folder_ / name).string(), fmt::format("cannot be written: {}", ec.message()));
  }
  for (const std::string& name : left_out_) {
    std::error_code ec;
    fs::remove(folder_ / name, ec);
    if (ec) throw Error((folder_ / name).string(), fmt::format("cannot be removed: {}", ec.message()));
  }
  committed_ = true;
  return names;
}

}  // namespace taxel
