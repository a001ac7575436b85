// Taxels as text on the clipboard: JSON that a person can read, write and keep.
#pragma once

#include <string>
#include <vector>

#include "core/layout/layout.h"

namespace taxel {

/// {"format": "taxels", "version": 1, "taxels": [...]}, taxels as in layout files. Throws Error with the JSON pointer
/// of a number that is not finite.
std::string taxels_to_json(const std::vector<Taxel>& taxels);

/// What taxels_to_json wrote; also the text of a layout file, an array of taxels, or one taxel, so that parts of files
/// can be pasted. Keys that this program does not know are left out. Throws Error(source, JSON pointer, message) for
/// anything else; where the text is no JSON at all the message says so in short. At least one taxel.
std::vector<Taxel> parse_taxels(const std::string& text, const std::string& source = "clipboard");

}  // namespace taxel
