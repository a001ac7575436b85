// Fields for a choice: one of a few words, or yes or no.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/layout/words.h"
#include "ui/widgets/ui.h"

namespace taxel::ui {

/// Draws a field for one of several choices. Returns the index of the choice that the user makes in this frame, or
/// nothing. `chosen` is the index of the present choice. `width` is that of ImGui::SetNextItemWidth().
std::optional<std::size_t> choice_of(Ui& ui, const std::string& name, std::span<const std::string_view> choices,
                                     std::size_t chosen, float width = -1);

/// Draws a field for the words that a layout file uses for the values of E. Returns the new value, or nothing.
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

/// Draws a field for yes or no. Returns the new state if the user toggles it in this frame, or nothing.
std::optional<bool> switch_field(Ui& ui, const std::string& name, bool on);

}  // namespace taxel::ui
