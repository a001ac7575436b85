#include "core/run/batch/batch_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/base/output.h"
#include "core/run/batch/batch_index.h"

namespace taxel {
namespace fs = std::filesystem;
namespace {

constexpr const char* kOwnFolder = ".batch";
constexpr const char* kStaging = "staging";
constexpr const char* kWritten[] = {kBatchFile,    "episodes.jsonl", "layouts.jsonl", "failed.jsonl",
                                    "summary.csv", "meshes",         "shards"};

/// Whether a file is written when its group ends, and not with the index.
bool is_of_group(const std::string& name) {
  return name.starts_with("runs/") || name.starts_with("shards/");
}

/// Throws Error if a folder without a journal has files with the names of a batch's.
void check_is_free(const fs::path& folder) {
  std::error_code ec;
  for (const char* name : kWritten)
    if (fs::exists(folder / name, ec))
      throw Error(folder.string(),
                  fmt::format("has \"{}\" already, which no batch has written: give another folder", name));
}

/// Throws Error if a name of the batch's own files is a link, whose target belongs to somebody else.
void check_is_no_link(const fs::path& path) {
  std::error_code ec;
  if (fs::is_symlink(fs::symlink_status(path, ec)))
    throw Error(path.string(), "is a link, and a batch writes its own files into its folder only: remove the link");
}

PublishedFile described(const fs::path& file, const std::string& name) {
  const std::string bytes = read_file(file, kMostShardBytes);
  return {name, bytes.size(), sha256_hex(bytes)};
}

}  // namespace

BatchFolder::BatchFolder(const fs::path& folder) : folder_(folder), own_(folder / kOwnFolder) {
  std::error_code ec;
  if (!fs::exists(journal(), ec)) check_is_free(folder_);
  for (const fs::path& own : {own_, own_ / "lock", own_ / kStaging, journal(), folder_ / "shards", folder_ / "meshes"})
    check_is_no_link(own);
  make_folder(own_);
  lock_ = os::File(own_ / "lock", os::Open::hold);
  if (!lock_.is_open())
    throw Error(folder_.string(), fmt::format("cannot be written: {}", os::error_text(lock_.error())));
  if (!lock_.try_lock())
    throw Error(folder_.string(), "another batch writes into this folder: wait for its end, or give another folder");
}

fs::path BatchFolder::empty_staging() const {
  const fs::path staging = own_ / kStaging;
  std::error_code ec;
  fs::remove_all(staging, ec);
  make_folder(staging);
  return staging;
}

std::vector<PublishedFile> BatchFolder::staged_files() const {
  const fs::path staging = own_ / kStaging;
  std::vector<PublishedFile> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(staging))
    if (entry.is_regular_file())
      files.push_back(described(entry.path(), entry.path().lexically_relative(staging).generic_string()));
  std::ranges::sort(files, {}, [](const PublishedFile& f) { return std::pair(f.name == kBatchFile, f.name); });
  return files;
}

std::vector<PublishedFile> BatchFolder::result_files(const std::vector<std::string>& names) const {
  std::vector<PublishedFile> files;
  std::error_code ec;
  for (const std::string& name : names)
    if (fs::exists(folder_ / name, ec)) files.push_back(described(folder_ / name, name));
  return files;
}

std::string BatchFolder::first_missing(const std::vector<PublishedFile>& files) const {
  std::string missing;
  for (const PublishedFile& file : files) {
    std::error_code ec;
    if (!fs::exists(folder_ / file.name, ec)) {
      if (missing.empty()) missing = file.name;
    } else if (described(folder_ / file.name, file.name) != file) {
      throw Error((folder_ / file.name).string(),
                  "is not as the batch has written it: remove it to have it written again, or give another folder");
    }
  }
  return missing;
}

void BatchFolder::withdraw(const std::vector<PublishedFile>& files) const {
  std::error_code ec;
  const fs::path head = folder_ / kBatchFile;
  if (fs::exists(head, ec) && std::ranges::count(files, described(head, kBatchFile)) > 0) fs::remove(head, ec);
}

void BatchFolder::publish(const std::vector<PublishedFile>& files, const std::vector<PublishedFile>& before) const {
  std::error_code ec;
  for (const PublishedFile& file : files) {
    const fs::path target = folder_ / file.name;
    if (!fs::exists(target, ec)) continue;
    if (const PublishedFile existing = described(target, file.name);
        existing != file && !std::ranges::count(before, existing))
      throw Error(target.string(), "exists, and no batch has written it: remove it, or give another folder");
  }
  fs::remove(folder_ / kBatchFile, ec);  // the batch is not complete until it is there again
  for (const PublishedFile& old : before) {
    if (is_of_group(old.name)) continue;
    const bool is_needed = std::ranges::find(files, old.name, &PublishedFile::name) != files.end();
    if (!is_needed && fs::exists(folder_ / old.name, ec) && described(folder_ / old.name, old.name) == old)
      fs::remove(folder_ / old.name, ec);
  }
  for (const PublishedFile& file : files) {
    make_folder((folder_ / file.name).parent_path());
    TargetFile(folder_ / file.name).take(own_ / kStaging / file.name);
  }
}

void BatchFolder::clean() const {
  std::error_code ec;  // files that stay here do no harm
  fs::remove_all(own_ / kStaging, ec);
}

}  // namespace taxel
