// The settings file: theme, scale, overlays, panels, recent files. Under $XDG_CONFIG_HOME/taxelstudio.
#pragma once

#include <filesystem>

#include "app/studio/app/ui_state.h"

namespace taxel::studio {

/// $XDG_CONFIG_HOME/taxelstudio, else ~/.config/taxelstudio.
std::filesystem::path settings_folder();

/// Of what a program leaves for the next start: $XDG_STATE_HOME/taxelstudio, else ~/.local/state/taxelstudio.
std::filesystem::path state_folder();

struct ReadSettings {
  ui::SavedState saved;
  std::string problem;  ///< what could not be read, and why; empty: nothing
};
/// What the file says; defaults for what it does not say. What cannot be read keeps its default, for settings are no
/// reason to stop, and is told.
ReadSettings read_settings(const std::filesystem::path& file);
/// The same of the file's text.
ReadSettings parse_settings(const std::string& text);
/// The text that write_settings() writes.
std::string settings_text(const ui::SavedState& saved);
/// Throws Error when the folder cannot be written.
void write_settings(const std::filesystem::path& file, const ui::SavedState& saved);

/// Puts a file first in the list of recent ones.
void remember_recent(ui::SavedState& saved, const std::string& file);

}  // namespace taxel::studio
