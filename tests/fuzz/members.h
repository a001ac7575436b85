// Archives in the form that fuzzers write: a sequence of members without checksums. A member is the length of its name
// (one byte), its name, the length of its bytes (two bytes, the lower first) and its bytes. A member that is cut off
// has the bytes that are present. Input that begins as a zip archive is read as one.
#pragma once

#include <string>

#include "core/base/archive/npz.h"

namespace taxel::fuzz {

/// Returns the bytes of an archive with the members of an input.
std::string archive_bytes_of(const std::string& input);

/// Returns the in-memory archive of an input. Throws Error if two members have the same name.
ZipArchive archive_of(const std::string& input);

}  // namespace taxel::fuzz
