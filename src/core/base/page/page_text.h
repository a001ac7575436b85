// The characters of page texts, and numbers as pages write them.
#pragma once

#include <string>
#include <vector>

namespace taxel {

/// Returns the code points of a UTF-8 text. A byte that is no part of a character becomes a question mark, and control
/// characters become spaces.
[[nodiscard]] std::u32string code_points(const std::string& text);

/// Returns a length or a colour with at most three decimals, without zeros at the end: "12.5". A number that is not
/// finite becomes 0.
[[nodiscard]] std::string page_number(double value);

/// Returns lengths with spaces between them.
[[nodiscard]] std::string joined_lengths(const std::vector<double>& lengths);

}  // namespace taxel
