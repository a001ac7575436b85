// Selecting a body and dragging it, by the habits of MuJoCo's viewer.
#pragma once

#include "app/studio/app/pointing/pointer_event.h"
#include "app/studio/app/values/selection.h"
#include "app/studio/app/values/shown.h"
#include "app/studio/app/values/viewer.h"
#include "app/studio/app/values/window_ui.h"
#include "app/studio/features/perturb/perturb_state.h"
#include "app/studio/features/scene/controls_state.h"
#include "ui/scene/pick/picking.h"

namespace taxel::ui {

/// The geom that was picked, also where it is a sensor's and drawn from its model; -1: none.
[[nodiscard]] int picked_geom(const SimScene& scene, const Pick& pick);

/// Selects the body under the pointer, and where it would be grabbed; the world, or nothing: none.
void select_body(WindowUi& ui, Selection& selection, const RunView& run, PerturbState& perturb, ControlsState& controls,
                 const std::optional<Pick>& under);
void deselect_body(WindowUi& ui, Selection& selection, PerturbState& perturb);

/// What a drag by so many pixels does to a body grabbed at a point: a pull keeps the point under the pointer, in the
/// upright plane that faces the camera, or `level`; a turn is a full one for the height of the view, about the vertical
/// and the horizontal of the picture, or, `level`, about those of the ground.
[[nodiscard]] Perturb dragged_body(const Camera& camera, int height, const dvec2& pixels, Perturb::Kind kind,
                                   bool level, const dvec3& grabbed_W);

/// Ctrl+left-drag turns, Ctrl+right-drag and Ctrl+Alt+left-drag pull, Shift: level. True: the mouse is taken.
bool handle_perturb_mouse(WindowUi& ui, const Viewer& viewer, const RunView& run, PerturbState& state,
                          const PointerEvent& event);

}  // namespace taxel::ui
