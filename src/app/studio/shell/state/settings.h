// The settings file under $XDG_CONFIG_HOME/taxelstudio: theme, scale, overlays, panels, recent files.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/studio/frame/app.h"

namespace taxel::studio {

/// Returns $XDG_CONFIG_HOME/taxelstudio, or ~/.config/taxelstudio if the variable is not set.
std::filesystem::path settings_folder();

/// Returns the folder of the files that a program leaves for the next start: $XDG_STATE_HOME/taxelstudio, or
/// ~/.local/state/taxelstudio if the variable is not set.
std::filesystem::path state_folder();

/// Applies the settings file to the window. A value that is missing or unreadable stays as it is. Returns the names of
/// unreadable values and the reasons, or an empty text. Does not throw, since settings are no reason to stop the
/// program.
std::string read_settings(const std::filesystem::path& file, ui::App& app);
/// Applies the text of a settings file in the same way.
std::string apply_settings(const std::string& text, ui::App& app);
/// Returns the text that write_settings() writes.
std::string settings_text(ui::App& app);
/// Writes the settings file. Throws Error if the folder cannot be written.
void write_settings(const std::filesystem::path& file, ui::App& app);

}  // namespace taxel::studio
