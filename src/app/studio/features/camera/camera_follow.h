// Cameras of the scene, a camera that goes along with a body, and the one that a hand starts from.
#pragma once

#include "app/studio/app/values/selection.h"
#include "app/studio/app/values/shown.h"
#include "app/studio/app/values/viewer.h"
#include "app/studio/app/values/window_ui.h"
#include "app/studio/features/camera/follow_state.h"
#include "app/studio/features/perturb/perturb_state.h"
#include "app/studio/features/scene/controls_state.h"
#include "ui/scene/pick/picking.h"

namespace taxel::ui {

/// Where a mode is looked at from before anything is known of it.
[[nodiscard]] Camera first_camera(Mode mode);
/// All that there is to show fills the view, seen from where the camera is.
void frame_scene(Viewer& viewer, const Shown& shown);
/// From the first direction again; a MuJoCo scene as its file has it (mjv_defaultFreeCamera).
void align_camera(Viewer& viewer, const Shown& shown, FollowState& follow);

/// Whether the view looks through a camera of the scene, which no hand moves.
[[nodiscard]] bool looks_through_camera(const Viewer& viewer, const FollowState& follow);
[[nodiscard]] bool has_cameras(const Viewer& viewer, const RunView& run);
/// Through the next camera of the scene, or the one before (-1).
void look_through_next(const Viewer& viewer, const Shown& shown, FollowState& follow, int direction);
/// Centres on the point, and goes along with it where its body can move.
void track_body(Viewer& viewer, const RunView& run, FollowState& follow, const Pick& under);
/// The camera of SIMULATE is where the hand left it, or where it went with the body.
void leave_followed(Viewer& viewer, FollowState& follow);
/// The same, in SIMULATE: a hand moves the camera.
void free_camera(Viewer& viewer, FollowState& follow);
/// To be called before each picture.
void follow_scene(Viewer& viewer, const RunView& run, FollowState& follow);
/// What leads the camera, and how to end it; empty: nothing.
[[nodiscard]] std::string follow_text(const Viewer& viewer, const RunView& run, const FollowState& follow);

[[nodiscard]] bool can_select_parent(const Viewer& viewer, const RunView& run);
/// Selects the body that the selected one hangs on.
void select_parent(WindowUi& ui, Selection& selection, const RunView& run, PerturbState& perturb,
                   ControlsState& controls);

}  // namespace taxel::ui
