#include "app/studio/host/document/file_watch.h"

#include <algorithm>
#include <system_error>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/base/hash.h"

namespace taxel::studio {

namespace {

constexpr double kBetweenLooks = 0.5;  // [s]

}  // namespace

std::string hash_of(const std::string& file) {
  try {
    return file.empty() ? "" : sha256_hex(read_file(file));
  } catch (const Error&) {
    return "";
  }
}

FileWatch::Stamp FileWatch::stamp_of(const std::string& file) {
  std::error_code missing;
  Stamp stamp;
  stamp.time = std::filesystem::last_write_time(file, missing);
  if (missing) return {};
  stamp.size = std::filesystem::file_size(file, missing);
  if (missing) return {};
  stamp.there = true;
  return stamp;
}

void FileWatch::watch(const std::vector<std::string>& files) {
  const auto same = [](const Watched& one, const std::string& file) { return one.file == file; };
  if (std::equal(watched_.begin(), watched_.end(), files.begin(), files.end(), same)) return;
  std::vector<Watched> watched;
  for (const std::string& file : files) {
    const auto known =
        std::find_if(watched_.begin(), watched_.end(), [&](const Watched& one) { return same(one, file); });
    const Stamp stamp = known == watched_.end() ? stamp_of(file) : Stamp{};
    watched.push_back(known == watched_.end() ? Watched{file, stamp, stamp} : *known);
  }
  watched_ = std::move(watched);
}

void FileWatch::accept(const std::string& file) {
  for (Watched& watched : watched_) {
    if (watched.file == file) watched.known = watched.last = stamp_of(file);
  }
}

std::vector<std::pair<std::string, FileChange>> FileWatch::look(double now) {
  std::vector<std::pair<std::string, FileChange>> changes;
  if (now < next_) return changes;
  next_ = now + kBetweenLooks;
  for (Watched& watched : watched_) {
    const Stamp stamp = stamp_of(watched.file);
    const bool still = stamp == watched.last;
    watched.last = stamp;
    if (!still || stamp == watched.known) continue;
    watched.known = stamp;
    changes.emplace_back(watched.file, stamp.there ? FileChange::changed : FileChange::deleted);
  }
  return changes;
}

}  // namespace taxel::studio
