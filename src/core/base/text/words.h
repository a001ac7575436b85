// The words that files and menus use for the values of an enumeration, and the known word that a misspelt one probably
// means. A file that defines a table of words also overloads words_of(E) for the enumeration. The functions here find
// that overload by its argument; its rows have `value` and `text` as Word has.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace taxel {

template <class E>
struct Word {
  E value;
  std::string_view text;
};

/// Returns the word of a value, as files spell it.
template <class E>
std::string_view to_word(E value) {
  for (const auto& w : words_of(value))
    if (w.value == value) return w.text;
  return "";
}

/// Returns the value of a word, or nothing for an unknown word.
template <class E>
std::optional<E> from_word(std::string_view text) {
  for (const auto& w : words_of(E{}))
    if (w.text == text) return w.value;
  return std::nullopt;
}

/// Returns all words of a choice for messages: "equal", "voronoi".
template <class E>
std::string word_list() {
  std::string list;
  for (const auto& w : words_of(E{})) {
    if (!list.empty()) list += ", ";
    list.append("\"").append(w.text).append("\"");
  }
  return list;
}

/// Returns the known word that is at most two letters away from `word` (inserted, deleted or replaced), or of which
/// `word` is the beginning, or the reverse (at least four letters). Case, '_', '-' and spaces do not count. Returns an
/// empty view if there is none, and the first of several that are equally near.
std::string_view nearest_word(std::string_view word, std::span<const std::string_view> candidates);

/// Returns "; did you mean "WORD"?" for the nearest known word, or an empty text if there is none.
std::string meant_word(std::string_view word, std::span<const std::string_view> candidates);

}  // namespace taxel
