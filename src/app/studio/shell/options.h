// What the command line of taxelstudio says.
#pragma once

#include <optional>
#include <string>

namespace taxel::studio {

struct Options {
  std::string file;      ///< empty: the fingertip sweep
  std::string scenario;  ///< file of the scenario that the window begins with; empty: the default sweep
  bool headless = false;
  std::string script, screenshot, dump_state, shader_dir, plugins;
  std::string state_dir;  ///< of settings and autosave; empty: the user's own, or none where frames follow a script
  double autosave_every = 30;  ///< [s]
  bool empty = false;          ///< opens nothing
  bool tour = false;           ///< begins with the tour, seen or not
  int width = 1280, height = 800;
  std::string cut_out;  ///< the 3-D view alone, on a transparent background
  int cut_out_width = 2400, cut_out_height = 1800;
  int frames = 0;  ///< 0: until the script ends or the window is closed
  bool list_bindings = false, version = false;

  bool live = false;  ///< a script's events come as a hand's do, while the simulation runs by the clock

  /// Whether frames follow the clock. Otherwise each takes 20 ms, and a script gets the same frames every time.
  [[nodiscard]] bool is_real_time() const { return live || (!headless && script.empty()); }
  /// Settings are read and written, and unsaved edits are kept.
  [[nodiscard]] bool keeps_state() const { return (is_real_time() && script.empty()) || !state_dir.empty(); }
};

/// Exit status instead where the program should stop right away (help, bad usage).
struct ParsedOptions {
  Options options;
  std::optional<int> exit_status;
};
ParsedOptions parse_options(int argc, char** argv);

}  // namespace taxel::studio
