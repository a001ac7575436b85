#include "core/base/output_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "core/base/error.h"
#include "core/base/files.h"

namespace taxel {
namespace fs = std::filesystem;
namespace {

/// Returns the highest folder above (or at) `path` that does not exist yet, or an empty path if all exist.
fs::path first_missing(const fs::path& path) {
  std::error_code ec;
  fs::path missing;
  for (fs::path at = path; !at.empty() && !fs::exists(at, ec); at = at.parent_path()) missing = at;
  return missing;
}

}  // namespace

OutputFolder::OutputFolder(const fs::path& folder) : folder_(fs::absolute(folder).lexically_normal()) {
  if (folder_.filename().empty()) folder_ = folder_.parent_path();
  made_ = std::make_unique<UnfinishedFolder>(first_missing(folder_));
  try {
    make_folder(folder_);
    staging_ = std::make_unique<TemporaryPath>(folder_, ".taxel-", os::Open::create_folder);
    if (const int why = staging_->file().error(); why != 0)
      throw Error(folder.string(), fmt::format("cannot be written: {}", os::error_text(why)));
  } catch (const Error& e) {
    throw Error(folder.string(), e.message());
  }
}

OutputFolder::~OutputFolder() = default;

void OutputFolder::write(const std::string& name, std::string_view bytes) {
  fill([&](const fs::path& folder) { write_file_atomically(folder / name, bytes); });
}

void OutputFolder::fill(const std::function<void(const fs::path&)>& fill) {
  const std::string staging = staging_->path().string();
  try {
    fill(staging_->path());
  } catch (const Error& e) {
    if (!e.file().starts_with(staging)) throw;
    throw Error(folder_.string() + e.file().substr(staging.size()), e.where(), e.message());
  }
}

std::vector<std::string> OutputFolder::collected() const {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(staging_->path()))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

void OutputFolder::check_targets(const std::vector<std::string>& names) const {
  std::error_code ec;
  const auto refuse = [&](const std::string& name, const char* why) {
    throw Error((folder_ / name).string(), fmt::format("{}; no file was written", why));
  };
  for (const std::string& name : names) {
    const bool is_folder = fs::is_directory(folder_ / name, ec);
    const bool needs_folder = fs::is_directory(staging_->path() / name, ec);
    if (is_folder && !needs_folder) refuse(name, "is a folder, a file is needed");
    if (!is_folder && needs_folder && fs::exists(folder_ / name, ec)) refuse(name, "is a file, a folder is needed");
  }
  for (const std::string& name : left_out_)
    if (fs::is_directory(folder_ / name, ec)) refuse(name, "is a folder, a file of this name would be removed");
}

std::vector<std::string> OutputFolder::commit() {
  const auto lock = lock_temporary_paths();  // a signal waits until all files are in place
  const std::vector<std::string> names = collected();
  check_targets(names);
  made_->keep();
  for (const std::string& name : names) {
    std::error_code ec;
    if (fs::is_directory(staging_->path() / name, ec)) fs::remove_all(folder_ / name, ec);
    fs::rename(staging_->path() / name, folder_ / name, ec);
    if (ec) throw Error((folder_ / name).string(), fmt::format("cannot be written: {}", ec.message()));
  }
  for (const std::string& name : left_out_) {
    std::error_code ec;
    fs::remove(folder_ / name, ec);
    if (ec) throw Error((folder_ / name).string(), fmt::format("cannot be removed: {}", ec.message()));
  }
  left_out_.clear();
  return names;
}

}  // namespace taxel
