// Finds commands by parts of their names.
#pragma once

#include <string_view>
#include <vector>

#include "app/studio/frame/keymap.h"

namespace taxel::ui {

/// Returns the commands of the keymap that match `typed`, best first. A command matches if its name, its menu, its
/// chord and its synonyms contain every word of `typed` ("export lay", "view cov", "ctrl+e", "gif"). If no command
/// matches in this way, a command matches if its name contains the letters of `typed` in order ("prjbk"). Case is
/// ignored. Names that begin with `typed` come first, then names with a word that begins with `typed`, then the others;
/// equal matches keep the order of the keymap. An empty text matches all commands. Keys of gestures and fields are not
/// commands.
std::vector<const Binding*> find_commands(std::string_view typed, const KeyNames& names = {});

}  // namespace taxel::ui
