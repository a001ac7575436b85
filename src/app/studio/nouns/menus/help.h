// The window with all keys and mouse gestures, and a field that searches them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/studio/frame/feature.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/menus/help_state.h"

namespace taxel::ui {

/// One row of the help.
struct HelpRow {
  std::string keys, where;
  const char* label = "";
};

/// Returns the rows in which each word of `typed` begins a word of the label, of its synonyms, of the keys, or of the
/// context. Case is ignored. An empty text matches all rows.
[[nodiscard]] std::vector<HelpRow> find_help(std::string_view typed, const KeyNames& names = {});

/// All keys and gestures, with a search.
extern const Feature kHelp;

}  // namespace taxel::ui
