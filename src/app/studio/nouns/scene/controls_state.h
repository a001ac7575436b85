// The panel of settings of the running scene, the chosen geoms and the filter of their list, and the commands about the
// layouts on a scene.
#pragma once

#include <string>
#include <vector>

#include "app/studio/frame/command.h"
#include "app/studio/frame/feature.h"

namespace taxel::ui {

struct ControlsState {
  using PerDocument = ControlsState;  ///< another document resets all of it
  std::vector<std::string> geoms;     ///< geoms that a layout is to be attached to
  std::string filter;                 ///< words of names of bodies, geoms, joints and sites, any case
  int shown_body = -1;                ///< selected body to which the list of geoms has scrolled, or -1
  int outlined_body = -1;             ///< selected body to which the outliner has scrolled, or -1
  bool wants_focus = false;           ///< whether another scene was opened
};

/// Attaches a layout to geoms of the open scene and compiles the scene again; its file stays as it is. An empty path
/// asks for the layout.
struct AttachLayout {
  std::vector<std::string> geoms;
  std::string path;
};
struct DetachLayout {
  std::string geom;
};

/// The panel: layouts on geoms, actuators, joints, keyframes, mocap bodies and equality constraints.
extern const Feature kControls;
/// Sets "scene": bodies, and all values that the user can set.
void dump_controls(const App& app, nlohmann::ordered_json& state);

}  // namespace taxel::ui

namespace taxel::studio {

void carry_out(const ui::AttachLayout& command, Host& host);
void carry_out(const ui::DetachLayout& command, Host& host);

}  // namespace taxel::studio
