// The words that files and menus use for the values of an enumeration. A file that defines a table of words also
// overloads words_of(E) for it; the functions here find that overload by its argument.
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

/// The word of a value, as files spell it.
template <class E>
std::string_view to_word(E value) {
  for (const Word<E>& w : words_of(value))
    if (w.value == value) return w.text;
  return "";
}

/// The value of a word, or nothing.
template <class E>
std::optional<E> from_word(std::string_view text) {
  for (const Word<E>& w : words_of(E{}))
    if (w.text == text) return w.value;
  return std::nullopt;
}

/// All words of a choice for messages: "equal", "voronoi".
template <class E>
std::string word_list() {
  std::string list;
  for (const Word<E>& w : words_of(E{})) {
    if (!list.empty()) list += ", ";
    list.append("\"").append(w.text).append("\"");
  }
  return list;
}

}  // namespace taxel
