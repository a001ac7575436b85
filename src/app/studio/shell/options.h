// Command-line options of taxelstudio.
#pragma once

#include <optional>
#include <string>

#include "core/run/lead.h"

namespace taxel::studio {

struct Options {
  std::string file;      ///< file to open, or empty for the fingertip sweep
  std::string scenario;  ///< file of the scenario at the start, or empty for the default sweep
  LeadRequest lead;      ///< start of the scene, and files that lead it
  bool headless = false;
  std::string script, screenshot, dump_state, shader_dir, plugins;
  /// Folder of settings and autosave. If empty, the user's own folders, or none if frames follow a script.
  std::string state_dir;
  double autosave_every = 30;  ///< interval between autosaves [s]
  bool empty = false;          ///< whether nothing is opened at the start
  /// Whether the contact of the fingertip sweep plays in a loop under a moving camera, until the user pauses.
  bool demo = false;
  bool tour = false;  ///< whether the window begins with the tour
  int width = 1280, height = 800;
  bool has_size = false;  ///< whether --size was given, so that the window does not go to its kept place
  std::string cut_out;    ///< file for an image of the 3-D view alone, on a transparent background
  int cut_out_width = 2400, cut_out_height = 1800;
  int frames = 0;  ///< number of frames; if 0, until the script ends or the window is closed
  bool list_bindings = false, version = false;

  /// Whether only frames that are saved as pictures are drawn. Others are laid out, so that the state is complete.
  bool draws_saved_only = false;
  bool live = false;            ///< whether script events come like a user's while simulating in real time
  bool desktop_dialog = false;  ///< whether scripts may use the desktop's file dialog

  /// Returns whether frames follow real time. Otherwise each frame takes 20 ms, and a script gets the same frames every
  /// time.
  [[nodiscard]] bool is_real_time() const { return live || (!headless && script.empty()); }
  /// Returns whether the desktop's file dialog may be used. A script and a window without a display have nobody who
  /// answers the dialog, so that a test has to request it.
  [[nodiscard]] bool may_use_desktop() const { return desktop_dialog || (!headless && script.empty()); }
  /// Returns whether settings are read and written, and unsaved edits are kept.
  [[nodiscard]] bool keeps_state() const { return (is_real_time() && script.empty()) || !state_dir.empty(); }
};

/// Options, or an exit status if the program should stop right away (help, bad usage).
struct ParsedOptions {
  Options options;
  std::optional<int> exit_status;
};
ParsedOptions parse_options(int argc, char** argv);

}  // namespace taxel::studio
