// Words by which people look for commands that have other names.
#pragma once

#include <cstddef>
#include <string_view>

namespace taxel::ui {

/// Returns further words for the command with this label, in lower case and separated by spaces; empty if there are
/// none.
[[nodiscard]] std::string_view synonyms_of(std::string_view label);
/// Returns the number of labels with synonyms.
[[nodiscard]] std::size_t synonym_count();

}  // namespace taxel::ui
