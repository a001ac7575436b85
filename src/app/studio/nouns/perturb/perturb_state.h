// The selected body and the drag that moves it, with the controls of MuJoCo's viewer.
#pragma once

#include <cstdint>

#include "app/studio/frame/feature.h"
#include "app/studio/frame/pointer_event.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/scene/controls_state.h"
#include "core/run/controls.h"
#include "ui/scene/picking.h"

namespace taxel::ui {

struct PerturbState {
  using PerDocument = PerturbState;          ///< another document resets all of it
  int geom = -1;                             ///< clicked geom of the selected body, index in SimScene::geoms, or -1
  dvec3 point_G{0};                          ///< clicked point, in the frame of the geom
  Perturb::Kind kind = Perturb::Kind::none;  ///< kind of the drag while a button is held
  int button = 0;                            ///< mouse button of the drag
  std::uint64_t grip = 0;                    ///< number of drags so far
  dvec2 start{0};                            ///< pointer at the start of the drag [pixels of the view]
  dvec3 grabbed_W{0};                        ///< grabbed point at the start of the drag
};

/// Returns the picked geom, also if the geom belongs to a sensor and is drawn from the sensor's model; -1 if there is
/// none.
[[nodiscard]] int picked_geom(const SimScene& scene, const Pick& pick);

/// Selects the body under the pointer and records the point to grab. Deselects if the world or nothing is there.
void select_body(WindowUi& ui, Selection& selection, const RunView& run, PerturbState& perturb, ControlsState& controls,
                 const std::optional<Pick>& under);
void deselect_body(WindowUi& ui, Selection& selection, PerturbState& perturb);

/// Returns the effect of a drag by a number of pixels on a body grabbed at a point. A pull keeps the point under the
/// pointer, in the upright plane that faces the camera, or in the horizontal plane if `level`. A rotation makes a full
/// turn over the height of the view, about the vertical and the horizontal of the image, or about those of the ground
/// if `level`.
[[nodiscard]] Perturb dragged_body(const Camera& camera, int height, const dvec2& pixels, Perturb::Kind kind,
                                   bool level, const dvec3& grabbed_W);

/// Handles the mouse. Ctrl+left-drag turns the body, Ctrl+right-drag and Ctrl+Alt+left-drag pull it, and Shift makes
/// the drag level. Returns whether the mouse was consumed.
bool handle_perturb_mouse(WindowUi& ui, const Viewer& viewer, const RunView& run, PerturbState& state,
                          const PointerEvent& event);

/// Lets the pointer pull and turn bodies.
extern const Feature kPerturb;

}  // namespace taxel::ui
