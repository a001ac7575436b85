// Commands by part of their names.
#pragma once

#include <string_view>
#include <vector>

#include "app/studio/app/keymap.h"

namespace taxel::ui {

/// The commands of the keymap that `typed` may mean, best first: every word of it stands in the name, the menu or the
/// chord ("export lay", "view cov", "ctrl+e"); where there is none, its letters stand in the name in order ("prjbk").
/// Any case. Names that begin with what is typed come first, then those with a word that does, then the others; in the
/// table's order among equals. All for an empty text. Keys of gestures and fields are no commands.
std::vector<const Binding*> find_commands(std::string_view typed);

}  // namespace taxel::ui
