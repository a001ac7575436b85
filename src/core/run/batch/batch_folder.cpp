#include "core/run/batch/batch_folder.h"

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/files.h"

namespace taxel {
namespace fs = std::filesystem;
namespace {

constexpr const char* kOwnFolder = ".batch";
constexpr const char* kPublished[] = {"summary.csv", "data", "meta"};  // in the order of publishing

/// Throws Error if a folder without a journal has files with the names of a data set.
void check_is_free(const fs::path& folder) {
  std::error_code ec;
  for (const char* name : kPublished)
    if (fs::exists(folder / name, ec))
      throw Error(folder.string(),
                  fmt::format("has \"{}\" already, which no batch has written: give another folder", name));
}

}  // namespace

BatchFolder::BatchFolder(const fs::path& folder) : folder_(folder), own_(folder / kOwnFolder) {
  std::error_code ec;
  if (!fs::exists(journal(), ec)) check_is_free(folder_);
  make_folder(own_);
  lock_ = os::File(own_ / "lock", os::Open::hold);
  if (!lock_.is_open())
    throw Error(folder_.string(), fmt::format("cannot be written: {}", os::error_text(lock_.error())));
  if (!lock_.try_lock())
    throw Error(folder_.string(), "another batch writes into this folder: wait for its end, or give another folder");
  make_folder(shards());
}

fs::path BatchFolder::empty_staging() const {
  const fs::path staging = own_ / "data_set";
  std::error_code ec;
  fs::remove_all(staging, ec);
  make_folder(staging);
  return staging;
}

void BatchFolder::publish() const {
  const fs::path staging = own_ / "data_set";
  std::error_code ec;
  for (auto name = std::rbegin(kPublished); name != std::rend(kPublished); ++name) fs::remove_all(folder_ / *name, ec);
  for (const char* name : kPublished) {
    if (!fs::exists(staging / name, ec)) continue;
    fs::rename(staging / name, folder_ / name, ec);
    if (ec) throw Error((folder_ / name).string(), fmt::format("cannot be written: {}", ec.message()));
  }
}

void BatchFolder::clean() const {
  std::error_code ec;  // files that stay here do no harm
  fs::remove_all(shards(), ec);
  fs::remove_all(own_ / "data_set", ec);
}

}  // namespace taxel
