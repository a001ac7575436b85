#include "core/base/output/output_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <system_error>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/base/output/target_file.h"

namespace taxel {
namespace fs = std::filesystem;

OutputFolder::OutputFolder(const fs::path& folder) : folder_(fs::absolute(folder).lexically_normal()) {
  if (folder_.filename().empty()) folder_ = folder_.parent_path();
  constexpr int kMostTries = 100;  // another process may remove an empty parent that it has made
  int why = 0;
  for (int i = 0; i < kMostTries && (i == 0 || os::is_missing(why)); ++i) {
    try {
      made_.make(folder_);
    } catch (const Error& e) {
      throw Error(folder.string(), e.message());
    }
    staging_ = std::make_unique<TemporaryPath>(folder_, ".taxel-", os::Open::create_folder);
    why = staging_->file().error();
  }
  if (why != 0) throw Error(folder.string(), fmt::format("cannot be written: {}", os::error_text(why)));
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

void OutputFolder::discard() {
  std::error_code ec;
  for (const fs::directory_entry& entry : fs::directory_iterator(staging_->path(), ec))
    fs::remove_all(entry.path(), ec);
}

std::vector<fs::path> OutputFolder::collected() const {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(staging_->path()))
    if (!entry.is_directory()) files.push_back(entry.path().lexically_relative(staging_->path()));
  std::sort(files.begin(), files.end());
  return files;
}

void OutputFolder::check_targets(const std::vector<fs::path>& files) const {
  std::error_code ec;
  const auto refuse = [&](const fs::path& name, const char* why) {
    throw Error((folder_ / name).string(), fmt::format("{}; no file was written", why));
  };
  for (const fs::path& file : files) {
    if (fs::is_directory(folder_ / file, ec)) refuse(file, "is a folder, a file is needed");
    for (fs::path above = file.parent_path(); !above.empty(); above = above.parent_path())
      if (fs::exists(folder_ / above, ec) && !fs::is_directory(folder_ / above, ec))
        refuse(above, "is a file, a folder is needed");
  }
  for (const std::string& name : left_out_)
    if (fs::is_directory(folder_ / name, ec)) refuse(name, "is a folder, a file of this name would be removed");
}

std::vector<std::string> OutputFolder::commit() {
  const auto lock = lock_temporary_paths();  // a signal waits until all files are in place
  const std::vector<fs::path> files = collected();
  check_targets(files);
  std::vector<TargetFile> targets;
  for (const fs::path& file : files) targets.emplace_back(folder_ / file);
  std::set<std::string> names;
  for (std::size_t i = 0; i < files.size(); ++i) {
    made_.make((folder_ / files[i]).parent_path());
    targets[i].take(staging_->path() / files[i]);
    names.insert(files[i].begin()->string());
  }
  for (const std::string& name : left_out_) {
    std::error_code ec;
    fs::remove(folder_ / name, ec);
    if (ec) throw Error((folder_ / name).string(), fmt::format("cannot be removed: {}", ec.message()));
  }
  left_out_.clear();
  return {names.begin(), names.end()};
}

}  // namespace taxel
