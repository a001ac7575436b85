// Cameras of the scene, a camera that goes along with a body, and the one that a hand starts from.
#pragma once

#include "app/studio/app/ui_state.h"
#include "ui/scene/pick/picking.h"

namespace taxel::ui {

/// Where a mode is looked at from before anything is known of it.
[[nodiscard]] Camera first_camera(Mode mode);
/// All that there is to show fills the view, seen from where the camera is.
void frame_scene(UiState& ui, const UiInput& input);
/// From the first direction again; a MuJoCo scene as its file has it (mjv_defaultFreeCamera).
void align_camera(UiState& ui, const UiInput& input);

/// Whether the view looks through a camera of the scene, which no hand moves.
[[nodiscard]] bool looks_through_camera(const UiState& ui);
[[nodiscard]] bool has_cameras(const UiState& ui, const UiInput& input);
/// Through the next camera of the scene, or the one before (-1).
void look_through_next(UiState& ui, const UiInput& input, int direction);
/// Centres on the point, and goes along with it where its body can move.
void track_body(UiState& ui, const UiInput& input, const Pick& under);
/// The camera of SIMULATE is where the hand left it, or where it went with the body.
void leave_followed(UiState& ui);
/// The same, in SIMULATE: a hand moves the camera.
void free_camera(UiState& ui);
/// To be called before each picture.
void follow_scene(UiState& ui, const UiInput& input);
/// What leads the camera, and how to end it; empty: nothing.
[[nodiscard]] std::string follow_text(const UiState& ui, const UiInput& input);

[[nodiscard]] bool can_select_parent(const UiState& ui, const UiInput& input);
/// Selects the body that the selected one hangs on.
void select_parent(UiState& ui, const UiInput& input);

}  // namespace taxel::ui
