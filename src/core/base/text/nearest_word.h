// The known word that a misspelt word probably means.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace taxel {

/// Returns the known word that is at most two letters away from `word` (inserted, deleted or replaced), or of which
/// `word` is the beginning, or the reverse (at least four letters). Case, '_', '-' and spaces do not count. Returns an
/// empty view if there is none, and the first of several that are equally near.
std::string_view nearest_word(std::string_view word, std::span<const std::string_view> known);

/// Returns "; did you mean "WORD"?" for the nearest known word, or an empty text if there is none.
std::string meant_word(std::string_view word, std::span<const std::string_view> known);

}  // namespace taxel
