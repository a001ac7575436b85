// Everything that the command palette finds: commands, parts of panels, mouse gestures and headings of the user guide.
// The entries come from the tables that draw these things.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "app/studio/frame/feature.h"
#include "app/studio/frame/keymap.h"
#include "app/studio/frame/search.h"

namespace taxel::ui {

struct App;

/// A field, choice or button of a panel.
struct FoundPart {
  const Feature* panel = nullptr;
  PanelPart part;
};
/// A heading of the user guide.
struct FoundHeading {
  std::string text;
};

/// One entry of the palette.
struct Found {
  using Target = std::variant<const Binding*, FoundPart, const Gesture*, FoundHeading>;
  SearchTexts texts;
  SearchWords words;
  Target target;
  Found(SearchTexts shown, Target meant) : texts(std::move(shown)), words(texts), target(std::move(meant)) {}
};

/// Returns all entries: commands first, in the order of the keymap.
[[nodiscard]] std::vector<Found> all_found(const KeyNames& names = {});

/// Returns the indices of the entries that match `typed`, best first, as search() does. An empty text matches the
/// commands alone.
[[nodiscard]] std::vector<std::size_t> find_entries(std::string_view typed, const std::vector<Found>& entries);

/// Returns why an entry cannot be carried out or shown now; empty if it can.
[[nodiscard]] std::string why_not_now(const Found& entry, const App& app);

/// Carries out a command; shows a part of a panel and gives it the keyboard; shows a gesture in the list of keys; opens
/// the guide at a heading. The entry must be possible now.
void choose(const Found& entry, App& app);

}  // namespace taxel::ui
