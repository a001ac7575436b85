// Names of the keys on the user's keyboard.
#pragma once

#include <map>
#include <string>

namespace taxel::ui {

/// ImGui's key to its name on the user's keyboard, for keys whose name differs from a US keyboard.
using KeyNames = std::map<int, std::string>;

}  // namespace taxel::ui
