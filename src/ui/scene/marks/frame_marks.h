// Axes of the frames that a scene consists of.
#pragma once

#include "ui/scene/paint/segments.h"
#include "ui/scene/passes/look.h"
#include "ui/scene/scene_input.h"

namespace taxel::ui {

/// x red, y green, z blue, as long as MuJoCo draws them; those of the world twice that. Dimmed within bodies.
void draw_frame_marks(const SceneInput& input, const Look& look, SegmentPass& segments);

}  // namespace taxel::ui
