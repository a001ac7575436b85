// The section view of the paper's Figure 1: skin, object, contact surface, receptive field and rays in a plane.
#pragma once

#include "app/studio/frame/feature.h"
#include "app/studio/nouns/section/section_state.h"
#include "ui/scene/scene_input.h"

namespace taxel::ui {

/// Draws the section into the window that the caller has begun. The wheel zooms, a drag moves the section, and a double
/// click fits the section to the panel.
void section_panel(const SceneInput& input, SectionState& state);

/// A cut through the contact and the pad.
extern const Feature kSection;

}  // namespace taxel::ui
