// Taxels as text on the clipboard: JSON that a person can read and write.
#pragma once

#include <string>
#include <vector>

#include "core/layout/layout.h"

namespace taxel {

/// Returns {"format": "taxels", "version": 1, "taxels": [...]} with taxels as in layout files. Throws Error with the
/// JSON pointer of a number that is not finite.
std::string taxels_to_json(const std::vector<Taxel>& taxels);

/// Reads the text of taxels_to_json(). Also reads the text of a layout file, an array of taxels, or one taxel, so that
/// parts of files can be pasted. Unknown keys are ignored. Returns at least one taxel. Throws Error(source, JSON
/// pointer, message) for any other text.
std::vector<Taxel> parse_taxels(const std::string& text, const std::string& source = "clipboard");

}  // namespace taxel
