// Reads and writes whole files, and the hash by which their content is known. The bytes go into a temporary file in the
// same folder, and are on the disk (fsync of the file, then of its folder) before it is renamed to the target. So a
// reader sees the old file or the new one, never a part of it, also after a power failure. TargetFile says which
// targets are written in place instead.
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

/// Returns the first bytes of a regular file, at most `size`; empty if there is no such file or it cannot be read.
std::string read_start(const std::filesystem::path& path, std::size_t size);

/// Writes a file as TargetFile::write() does. Throws Error that names the file if this fails; a regular file is then
/// unchanged and no temporary file is left.
void write_file_atomically(const std::filesystem::path& path, std::string_view bytes);

/// Creates a folder and its parents. Throws Error that names the folder if this fails or if a file has its name.
void make_folder(const std::filesystem::path& path);

/// Returns the SHA-256 of bytes (FIPS 180-4), as lower-case hexadecimal. Computed by mbed TLS.
std::string sha256_hex(std::string_view bytes);

}  // namespace taxel
