// The section view of the paper's Figure 1: skin, object, contact surface, receptive field and rays in a plane.
#pragma once

#include "ui/scene/scene_input.h"

namespace taxel::ui {

struct SectionState {
  double zoom = 1;       ///< 1: the section fits
  dvec2 pan{0};          ///< of the view's middle from the section's focus [m]
  double slab = 0.0002;  ///< rays and samples this near to the plane are shown [m], either side
};

/// Draws into the window that the caller has begun. Wheel zooms, drag moves, double click fits again.
void section_panel(const SceneInput& input, SectionState& state);

}  // namespace taxel::ui
