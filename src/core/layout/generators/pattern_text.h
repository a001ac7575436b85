// Patterns of taxels from texts, for command lines and Python: the fields of all kinds with their keys and defaults,
// and the pattern of a kind with the values of some fields. The fields follow from the kinds in pattern.h.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/layout/generators/pattern.h"

namespace taxel {

/// A field of one or several kinds.
struct PatternFieldHelp {
  std::string key;                 ///< key of the field
  std::string help;                ///< its meaning, as the window says it
  std::string unit;                ///< unit of a number without one: "m", "deg" or "" (a number or a word)
  std::string default_text;        ///< default of the first kind with the field
  std::vector<std::string> kinds;  ///< words of the kinds that have the field
};

/// Returns the words of all kinds in the order of the window.
std::vector<std::string> pattern_words();
/// Returns all fields, each once, in the order of the kinds.
std::vector<PatternFieldHelp> pattern_fields();

/// Keys with the texts of their values.
using PatternTexts = std::vector<std::pair<std::string, std::string>>;

/// Returns the pattern of a kind. Texts are numbers with or without a unit ("4 mm", 0.004), whole numbers, "true" or
/// "false", or words of a choice. The radius of a kind with a pitch is 0.8 times the pitch unless it is given, as in
/// the window. Throws Error("", key, ...) for an unknown kind or word, a key that the kind does not have, and a text
/// that is no value of the field; make_pattern() checks the ranges.
Pattern pattern_of_texts(std::string_view kind, const PatternTexts& values);

}  // namespace taxel
