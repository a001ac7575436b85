#include "core/base/output/target_file.h"

#include <fmt/format.h>

#include <string>
#include <system_error>

#include "core/base/error.h"
#include "core/base/output/temporary_path.h"

namespace taxel {
namespace fs = std::filesystem;
namespace {

/// Returns the path behind all links. It may not exist.
fs::path behind_links(fs::path path) {
  constexpr int kMostLinks = 40;  // as in Linux
  std::error_code ec;
  for (int i = 0; i < kMostLinks && fs::is_symlink(fs::symlink_status(path, ec)); ++i) {
    const fs::path next = fs::read_symlink(path, ec);
    if (ec) break;
    path = path.parent_path() / next;
  }
  return path;
}

fs::path folder_of(const fs::path& file) {
  return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

bool is_same(const os::Status& a, const os::Status& b) {
  return a.device == b.device && a.inode == b.inode;
}

void sync_folder(const fs::path& folder) {
  const os::File file(folder, os::Open::folder);
  if (file.is_open()) static_cast<void>(file.sync());  // the new file is in place: a failure changes nothing
}

/// Passes the content of a file to `use`, piece by piece, until it returns an error.
template <class Use>
int each_piece(const fs::path& path, const Use& use) {
  constexpr std::size_t kPieceBytes = std::size_t{1} << 20;
  const os::File in(path, os::Open::check);
  if (!in.is_open()) return in.error();
  std::string piece;
  for (std::uint64_t at = 0;; at += piece.size()) {
    if (const int why = in.read_at(piece, at, kPieceBytes); why != 0) return why;
    if (piece.empty()) return 0;
    if (const int why = use(piece); why != 0) return why;
  }
}

}  // namespace

TargetFile::TargetFile(const fs::path& path) : path_(path), real_(path) {
  const auto refuse = [&](const std::string& why) { throw Error(path_.string(), why); };
  if (const int why = os::look_at(path_, old_); why != 0) {
    if (!os::is_missing(why)) refuse("cannot be written: " + os::error_text(why));
    real_ = behind_links(path_);
    return;
  }
  exists_ = true;
  if (old_.kind == os::Kind::folder) refuse("is a folder, a file is needed");
  if (old_.kind == os::Kind::disk) refuse("is a disk, a file is needed");
  stream_ = os::standard_output_of(old_);
  real_ = behind_links(path_);
  os::Status behind;
  const bool has_name = os::look_at(real_, behind) == 0 && is_same(behind, old_);  // not so: /proc/self/fd/3
  if (stream_.is_open() || old_.kind != os::Kind::file || !has_name) {
    how_ = How::written_into;
    if (!stream_.is_open()) stream_ = os::File(path_, os::Open::write);
    if (os::has_no_file(stream_.error())) refuse("cannot be written: no program reads it");
    if (!stream_.is_open()) refuse("cannot be written: " + os::error_text(stream_.error()));
    return;
  }
  if (!os::can_write(real_)) refuse("cannot be written: the file is write-protected");
  if (old_.links > 1 || os::has_access_list(real_)) how_ = How::overwritten;
}

void TargetFile::fail(int why) const {
  throw Error(path_.string(), "writing failed: " + os::error_text(why));
}

template <class Content>
void TargetFile::write_content(const Content& content) const {
  if (how_ == How::written_into) {
    if (const int why = content(stream_); why != 0) fail(why);
    return;
  }
  TemporaryPath temporary(folder_of(real_), real_.filename().string() + ".",
                          exists_ ? os::Open::create_private : os::Open::create);
  if (!temporary.file().is_open())
    throw Error(path_.string(), "cannot be written: " + os::error_text(temporary.file().error()));
  int why = content(temporary.file());
  if (why == 0) why = temporary.file().sync();
  if (why != 0) fail(why);
  put_in_place(temporary.path(), temporary.file());
}

void TargetFile::write(std::string_view bytes) const {
  write_content([&](const os::File& out) { return out.write(bytes); });
}

void TargetFile::take(const fs::path& complete) const {
  os::Status from, folder;
  const bool can_move = how_ != How::written_into && os::look_at(complete, from) == 0 &&
                        os::look_at(folder_of(real_), folder) == 0 && from.device == folder.device;
  if (can_move) {
    const os::File file(complete, os::Open::check);
    if (!file.is_open()) fail(file.error());
    if (const int why = file.sync(); why != 0) fail(why);
    return put_in_place(complete, file);
  }
  write_content([&](const os::File& out) {
    return each_piece(complete, [&](const std::string& piece) { return out.write(piece); });
  });
}

void TargetFile::put_in_place(const fs::path& complete, const os::File& file) const {
  const auto lock = lock_temporary_paths();  // a signal either comes before the file is in place or after it
  if (how_ == How::overwritten || (exists_ && !file.take_rights(old_))) return overwrite(complete);
  std::error_code ec;
  fs::rename(complete, real_, ec);
  if (ec) throw Error(path_.string(), fmt::format("cannot be replaced: {}", ec.message()));
  sync_folder(folder_of(real_));
}

void TargetFile::overwrite(const fs::path& complete) const {
  const os::File out(real_, os::Open::write);
  if (!out.is_open()) fail(out.error());
  const std::uint64_t before = out.size();
  std::error_code ec;
  const std::uint64_t size = fs::file_size(complete, ec);
  if (ec) fail(ec.value());
  if (const int why = out.reserve(size); why != 0) {
    static_cast<void>(out.cut(before));
    fail(why);
  }
  int why = each_piece(complete, [&](const std::string& piece) { return out.write(piece); });
  if (why == 0) why = out.cut(size);
  if (why == 0) why = out.sync();
  if (why != 0) fail(why);
}

}  // namespace taxel
