// The settings file: theme, scale, overlays, panels, recent files. Under $XDG_CONFIG_HOME/taxelstudio.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/studio/app/app.h"

namespace taxel::studio {

/// $XDG_CONFIG_HOME/taxelstudio, else ~/.config/taxelstudio.
std::filesystem::path settings_folder();

/// Of what a program leaves for the next start: $XDG_STATE_HOME/taxelstudio, else ~/.local/state/taxelstudio.
std::filesystem::path state_folder();

/// The values of the settings file, in its order.
struct SavedState {
  bool dark = true;
  float scale = 1.0f;  ///< scale of the interface, in addition to the screen's own
  ui::Overlays overlays;
  ui::PanelsShown panels;
  ui::PlotOptions plot;
  bool tour_seen = false;
  std::vector<std::string> recent;  ///< recently opened files, newest first
};

/// Returns the values that are kept from one start to the next.
SavedState saved_state(const ui::App& app);
/// Gives the window the values of the settings file.
void apply_saved(const SavedState& saved, ui::App& app);

struct ReadSettings {
  SavedState saved;
  std::string problem;  ///< what could not be read, and why; empty: nothing
};
/// What the file says; defaults for what it does not say. What cannot be read keeps its default, for settings are no
/// reason to stop, and is told.
ReadSettings read_settings(const std::filesystem::path& file);
/// The same of the file's text.
ReadSettings parse_settings(const std::string& text);
/// The text that write_settings() writes.
std::string settings_text(const SavedState& saved);
/// Throws Error when the folder cannot be written.
void write_settings(const std::filesystem::path& file, const SavedState& saved);

/// Puts a file first in the list of recent ones.
void remember_recent(std::vector<std::string>& recent, const std::string& file);

}  // namespace taxel::studio
