// The section view of the paper's Figure 1: skin, object, contact surface, receptive field and rays in a plane.
#pragma once

#include "app/studio/frame/feature.h"
#include "core/base/math.h"
#include "ui/scene/scene_input.h"

namespace taxel::ui {

/// The part of the section that the panel shows.
struct SectionState {
  double zoom = 1;       ///< 1 if the sensor, the contact or the taxel of the section fits the panel
  dvec2 pan{0};          ///< vector from the section's focus to the middle of the panel [m]
  double slab = 0.0002;  ///< distance from the plane within which rays and samples are drawn [m]
};

/// Draws the section into the window that the caller has begun. The wheel zooms, a drag moves the section, and a double
/// click fits the section to the panel.
void section_panel(const SceneInput& input, SectionState& state);

/// A cut through the contact and the pad.
extern const Feature kSection;

}  // namespace taxel::ui
