// Fields for what is chosen: one of a few words, yes or no.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/layout/words.h"
#include "ui/widgets/ui.h"

namespace taxel::ui {

/// Index of the choice that was made now; none: as it was.
std::optional<std::size_t> choice_of(Ui& ui, const std::string& name, std::span<const std::string_view> choices,
                                     std::size_t chosen);

/// One of the words that a layout file uses for E.
template <class E>
std::optional<E> word_field(Ui& ui, const std::string& name, E value) {
  std::vector<std::string_view> choices;
  std::size_t chosen = 0;
  for (const auto& word : words_of(E{})) {
    if (word.value == value) chosen = choices.size();
    choices.push_back(word.text);
  }
  const std::optional<std::size_t> made = choice_of(ui, name, choices, chosen);
  return made ? std::optional<E>(words_of(E{})[*made].value) : std::nullopt;
}

/// The new state where it was switched now.
std::optional<bool> switch_field(Ui& ui, const std::string& name, bool on);

}  // namespace taxel::ui
