// The settings file under $XDG_CONFIG_HOME/taxelstudio: theme, scale, overlays, panels, recent files.
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "app/studio/app/app.h"
#include "app/studio/features/plot/plot_choice.h"
#include "ui/scene/scene_input.h"

namespace taxel::studio {

/// Returns $XDG_CONFIG_HOME/taxelstudio, or ~/.config/taxelstudio if the variable is not set.
std::filesystem::path settings_folder();

/// Returns the folder of the files that a program leaves for the next start: $XDG_STATE_HOME/taxelstudio, or
/// ~/.local/state/taxelstudio if the variable is not set.
std::filesystem::path state_folder();

/// Returns whether each panel with a key is open at the first start, and "info", by key.
std::map<std::string, bool> panels_at_first();

/// The values of the settings file, in its order.
struct SavedState {
  bool dark = true;
  float scale = 1.0f;                                      ///< scale of the interface, in addition to the screen's own
  ui::Overlays overlays;                                   ///< overlays of LAYOUT
  ui::Overlays run_overlays = ui::overlays_of_run();       ///< overlays of SIMULATE
  std::map<std::string, bool> panels = panels_at_first();  ///< whether each panel is open, by the key of its row
  ui::PlotOptions plot;
  bool tour_seen = false;
  bool timeline_unfolded = false;     ///< whether the timeline displays its tracks
  std::array<int, 4> window_place{};  ///< x, y, width, height in screen coordinates; width 0 if not known
  bool window_maximized = false;
  std::vector<std::string> recent;  ///< recently opened files, newest first
  bool ranges_linked = false;       ///< whether surface and readings share one range
  bool desktop_dialog = true;       ///< whether the desktop's file dialog is used if there is one
};

/// Returns the values that are kept from one start to the next.
SavedState saved_state(const ui::App& app);
/// Applies the values of the settings file to the window.
void apply_saved(const SavedState& saved, ui::App& app);

struct ReadSettings {
  SavedState saved;
  std::string problem;  ///< names of unreadable values and the reasons, or empty
};
/// Reads the settings file. A value that is missing or unreadable keeps its default; `problem` reports unreadable
/// values. Does not throw, since settings are no reason to stop the program.
ReadSettings read_settings(const std::filesystem::path& file);
/// Reads settings from the text of a settings file.
ReadSettings parse_settings(const std::string& text);
/// Returns the text that write_settings() writes.
std::string settings_text(const SavedState& saved);
/// Writes the settings file. Throws Error if the folder cannot be written.
void write_settings(const std::filesystem::path& file, const SavedState& saved);

/// Makes a file the first one in the list of recent files.
void remember_recent(std::vector<std::string>& recent, const std::string& file);

}  // namespace taxel::studio
