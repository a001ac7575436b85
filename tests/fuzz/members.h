// Archives as fuzzers write them: members one after another, without checksums. A member is the length of its name (one
// byte), its name, the length of its bytes (two bytes, the lower first) and its bytes. A member that is cut off keeps
// the bytes that are there. Input that begins as a zip archive is one.
#pragma once

#include <string>

#include "core/run/recording/zip_archive.h"

namespace taxel::fuzz {

/// The archive in memory of an input. Throws Error if two members have one name.
ZipArchive archive_of(const std::string& input);

}  // namespace taxel::fuzz
