// Numbers in lines and attributes of other programs' files.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace taxel {

/// Returns the words of a text, which blanks, tabs and line breaks separate.
std::vector<std::string_view> split_words(std::string_view text);

/// Returns the finite number that a whole word is; nothing for other words. A leading plus is allowed.
std::optional<double> number_of_word(std::string_view word);

/// Returns numbers in the shortest form that reads back, separated by blanks.
std::string words_of_numbers(const std::vector<double>& numbers);

}  // namespace taxel
