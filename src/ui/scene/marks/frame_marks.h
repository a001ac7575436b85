// Draws the axes of the frames of a scene.
#pragma once

#include "ui/scene/paint/segments.h"
#include "ui/scene/passes/look.h"
#include "ui/scene/scene_input.h"

namespace taxel::ui {

/// Draws x red, y green and z blue, with the lengths that MuJoCo uses and twice this length for the world. Axes inside
/// bodies are dimmed.
void draw_frame_marks(const SceneInput& input, const Look& look, SegmentPass& segments);

}  // namespace taxel::ui
