// Folders of the user, where the XDG Base Directory Specification has them.
#pragma once

#include <filesystem>

namespace taxel::os {

/// Returns $XDG_CONFIG_HOME, or ~/.config if the variable is not set: for settings.
[[nodiscard]] std::filesystem::path config_folder();
/// Returns $XDG_STATE_HOME, or ~/.local/state if the variable is not set: for files that the next start needs.
[[nodiscard]] std::filesystem::path state_folder();

}  // namespace taxel::os
