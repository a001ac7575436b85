#include "core/base/archive/zip_archive.h"

#include <fmt/format.h>
#include <zip.h>

#include <numeric>

#include "core/base/error.h"
#include "core/base/files.h"

namespace taxel {
namespace {

[[noreturn]] void fail(const std::string& file, zip_error_t& error) {
  const std::string why = zip_error_strerror(&error);
  zip_error_fini(&error);
  throw Error(file, "cannot be read as .npz: " + why);
}

}  // namespace

ZipArchive::ZipArchive(const std::filesystem::path& path) : ZipArchive(path.string(), read_file(path)) {}

ZipArchive::ZipArchive(std::string file, std::string bytes)
    : file_(std::move(file)), bytes_(std::make_shared<const std::string>(std::move(bytes))) {
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* source = zip_source_buffer_create(bytes_->data(), bytes_->size(), 0, &error);
  if (source == nullptr) fail(file_, error);
  // ZIP_CHECKCONS compares the header of each member with the directory of the archive. Without it, a flipped bit in a
  // name would hide an array.
  zip_t* const archive = zip_open_from_source(source, ZIP_RDONLY | ZIP_CHECKCONS, &error);
  if (archive == nullptr) {
    zip_source_free(source);
    fail(file_, error);
  }
  archive_.reset(archive, &zip_discard);
  list_members();
}

void ZipArchive::list_members() {
  const zip_int64_t count = zip_get_num_entries(archive_.get(), 0);
  for (zip_int64_t i = 0; i < count; ++i) {
    zip_stat_t status;
    zip_stat_init(&status);
    const auto index = static_cast<zip_uint64_t>(i);
    const char* const name = zip_get_name(archive_.get(), index, ZIP_FL_ENC_UTF_8);
    constexpr zip_uint64_t kNeeded = ZIP_STAT_SIZE | ZIP_STAT_CRC;
    if (name == nullptr || zip_stat_index(archive_.get(), index, 0, &status) < 0 || (status.valid & kNeeded) != kNeeded)
      throw Error(file_, fmt::format("member {} of the archive is broken", i));
    if (!members_.try_emplace(name, Member{index, status.size}).second)
      throw Error(file_, name, "is twice in the archive");
  }
}

std::string ZipArchive::read(const std::string& name) const {
  const auto found = members_.find(name);
  if (found == members_.end()) throw Error(file_, name, "is missing");
  const Member& member = found->second;
  std::uint64_t others = 0;
  for (const auto& [other, size] : unpacked_) others += other == name ? 0 : size;
  const std::uint64_t most = kFreeBytes + kMaxRatio * bytes_->size();
  if (member.size > most || others > most - member.size)
    throw Error(file_, name,
                fmt::format("announces {} bytes; of an archive of {} bytes at most {} are unpacked, {} are already",
                            member.size, bytes_->size(), most, others));
  unpacked_[name] = member.size;
  std::string bytes(member.size, '\0');
  char beyond = 0;
  const std::unique_ptr<zip_file_t, decltype(&zip_fclose)> in(zip_fopen_index(archive_.get(), member.index, 0),
                                                              &zip_fclose);
  // Libzip compares the checksum when a read reaches the end of the member, so one more read is needed after the bytes.
  if (in == nullptr || zip_fread(in.get(), bytes.data(), bytes.size()) != static_cast<zip_int64_t>(bytes.size()) ||
      zip_fread(in.get(), &beyond, 1) != 0)
    throw Error(file_, name, "is broken off or damaged: its content differs from its checksum");
  return bytes;
}

}  // namespace taxel
