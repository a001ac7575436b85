// Cameras of the scene, a camera that follows a body, and the camera that a view starts with.
#pragma once

#include "app/studio/frame/feature.h"
#include "app/studio/frame/selection.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/camera/follow_state.h"
#include "app/studio/nouns/perturb/perturb_state.h"
#include "app/studio/nouns/scene/controls_state.h"
#include "ui/scene/pick/picking.h"

namespace taxel::ui {

/// Returns the camera of a mode before anything is loaded.
[[nodiscard]] Camera first_camera(Mode mode);
/// Frames a scene that is displayed for the first time. A scene with several sensors is seen from the direction that
/// its file sets, if it sets one.
void show_scene_first(Viewer& viewer, const Shown& shown);
/// Moves the camera so that all displayed objects fill the view; in a scene with several sensors, all sensors. The
/// direction of view stays.
void frame_scene(Viewer& viewer, const Shown& shown);
/// Restores the initial direction of view. A MuJoCo scene gets the camera of its file (mjv_defaultFreeCamera).
void align_camera(Viewer& viewer, const Shown& shown, FollowState& follow);

/// Returns whether the view looks through a camera of the scene, which the user cannot move.
[[nodiscard]] bool looks_through_camera(const Viewer& viewer, const FollowState& follow);
[[nodiscard]] bool has_cameras(const Viewer& viewer, const RunView& run);
/// Looks through the next camera of the scene (`direction` 1) or the previous camera (-1).
void look_through_next(const Viewer& viewer, const Shown& shown, FollowState& follow, int direction);
/// Centres the camera on the picked point. If the point's body can move, the camera follows the body.
void track_body(Viewer& viewer, const RunView& run, FollowState& follow, const Pick& under);
/// Stops following. The camera of SIMULATE returns to where the user left it, or stays where it followed the body to.
void leave_followed(Viewer& viewer, FollowState& follow);
/// Calls leave_followed() in SIMULATE, because the user moves the camera.
void free_camera(Viewer& viewer, FollowState& follow);
/// Returns a text that names the followed camera or body and how to stop following. Empty if the camera follows
/// nothing.
[[nodiscard]] std::string follow_text(const Viewer& viewer, const RunView& run, const FollowState& follow);

[[nodiscard]] bool can_select_parent(const Viewer& viewer, const RunView& run);
/// Selects the parent of the selected body.
void select_parent(WindowUi& ui, Selection& selection, const RunView& run, PerturbState& perturb,
                   ControlsState& controls);

/// Moves the camera with the camera or body that it follows.
void follow_scene(Viewer& viewer, const RunView& run, FollowState& follow);
/// Lets the camera follow the chosen body or camera, in each frame.
extern const Feature kCameraFollow;
/// Sets "followed" and "sensor_boxes": the corners of each sensor in the window.
void dump_camera_follow(const App& app, nlohmann::ordered_json& state);

}  // namespace taxel::ui
