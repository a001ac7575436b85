// Search of named entries by typed words: words in any order, their beginnings, other words for the same thing, and
// words with typing errors. Pure functions, without a window.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace taxel::ui {

/// The texts by which an entry is found. Case is ignored in all of them.
struct SearchTexts {
  std::string name;   ///< displayed name
  std::string place;  ///< menu, panel or document that has the entry
  std::string words;  ///< further words by which people look for it
  std::string keys;   ///< its chords, such as "Ctrl+Y, Ctrl+Shift+Z"
  std::string help;   ///< sentence about it
  /// Advantage over entries that match equally well, in units of a matched word of the name (10).
  double bias = 0;
};

/// The same texts in lower case and in words, as the search needs them.
struct SearchWords {
  explicit SearchWords(const SearchTexts& texts);
  std::string whole_name, further;
  std::vector<std::string> name, words, place, help, chords;
  double bias = 0;
};

/// Returns the indices of the entries that match `typed`, best first; equal matches keep their order. An entry matches
/// if each typed word equals, begins or, with at most two typing errors, resembles a word of its texts. Words such as
/// "the" and "how" are left out. If fewer than three entries match, entries that lack one of several words follow; if
/// there is none, entries whose names contain the typed letters in their order. An empty text matches all entries.
[[nodiscard]] std::vector<std::size_t> search(std::string_view typed, std::span<const SearchWords* const> entries);

/// Returns the number of typing errors between two words, up to `most` + 1: a letter that is missing, added or wrong,
/// or two neighbours that are exchanged (optimal string alignment). Words of more than 40 letters count as different.
[[nodiscard]] std::size_t typing_errors(std::string_view a, std::string_view b, std::size_t most);

}  // namespace taxel::ui
