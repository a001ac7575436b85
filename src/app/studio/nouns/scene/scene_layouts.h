// Layouts on the geoms of an open scene: making, editing, attaching and saving them, and the cards of LAYOUT about
// them.
#pragma once

#include <string>

#include "app/studio/frame/command.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/scene/controls_state.h"

namespace taxel::ui {

/// Begins a layout without taxels on a geom of the scene, whose mesh, scale and pose come from MuJoCo. An empty name is
/// the chosen geom. A layout that is on the geom already is edited.
struct NewLayoutOnGeom {
  std::string geom = {};
  bool operator==(const NewLayoutOnGeom&) const = default;
};
/// Edits the layout of a sensor of the scene; -1 is the selected one.
struct EditSensorLayout {
  int sensor = -1;
  bool operator==(const EditSensorLayout&) const = default;
};
/// Attaches the layout of the edited geom, or of the selected sensor, to one geom with the same mesh on each other
/// body.
struct AttachToSameMesh {};
/// Ends editing a layout of the scene: LAYOUT shows all of them again.
struct LeaveLayout {};

/// Offers the layout of a sensor at the row of a list that was drawn last: a double-click or Enter edits it, and a
/// right click opens a menu.
void offer_sensor(WindowUi& ui, Selection& selection, const RunView& run, int sensor);
/// Offers a geom without taxels at the row of a list that was drawn last: a right click opens a menu.
void offer_geom(WindowUi& ui, ControlsState& controls, const SceneGeom& geom);

/// The cards of LAYOUT: the layouts of a scene, and the actions for the edited one.
extern const Feature kSceneLayouts;
/// Sets "scene_layout": the edited layout of the scene, or null.
void dump_scene_layout(const App& app, nlohmann::ordered_json& state);

}  // namespace taxel::ui

namespace taxel::studio {

void carry_out(const ui::NewLayoutOnGeom& command, Host& host);
void carry_out(const ui::EditSensorLayout& command, Host& host);
void carry_out(const ui::AttachToSameMesh& command, Host& host);
void carry_out(const ui::LeaveLayout& command, Host& host);

/// Returns whether a command ends editing the layout of a scene, so that its unsaved edits would be lost.
[[nodiscard]] bool leaves_scene_layout(const ui::Command& command, const Host& host);
/// Returns whether the scene's file declares the edited layout for at least one of its geoms.
[[nodiscard]] bool edits_declared_layout(const Host& host);
/// Writes the edited layout of the scene to its file. If the scene has the layout as text, the scene's file names the
/// written file afterwards. Returns whether it was written; if not, a message says why.
bool save_scene_layout(Host& host);
/// Writes the scene that the user asked for, as soon as the simulation reads by the newest layout.
void save_scene_when_ready(Host& host);

}  // namespace taxel::studio
