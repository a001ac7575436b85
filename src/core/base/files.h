// Whole files in and out. Writing is atomic: the bytes go beside the target and are renamed over it, so a reader sees
// the old file or the new one, never half of one; and they are on the disk before that (fsync of the file, then of its
// folder), so that a machine that loses power has one of the two as well.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace taxel {

/// The largest file that is read whole [bytes]. A larger one is refused before memory is taken for it.
inline constexpr std::uint64_t kMaxFileBytes = std::uint64_t{1} << 30;

/// Returns all bytes of a regular file. Throws Error that names the file if it is missing, unreadable, larger than
/// `max_bytes`, or not a regular file: reading a pipe or a device may never end. Never waits for a writer.
std::string read_file(const std::filesystem::path& path, std::uint64_t max_bytes = kMaxFileBytes);

/// Writes beside and renames. Throws Error that names the file; then the target is untouched and nothing is left over.
void write_file_atomically(const std::filesystem::path& path, std::string_view bytes);

/// Makes a folder and its parents. Throws Error that names it when that fails or a file is in the way.
void make_folder(const std::filesystem::path& path);

}  // namespace taxel
