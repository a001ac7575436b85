// Draws the marks of a grabbed body, and of the constraints between bodies.
#pragma once

#include "ui/scene/paint/points.h"
#include "ui/scene/paint/segments.h"
#include "ui/scene/passes/look.h"
#include "ui/scene/pick/camera.h"
#include "ui/scene/scene_input.h"

namespace taxel::ui {

/// Draws an arrow from the grabbed point to the pointer, or an arc as wide as the rotation, and lines between
/// constraint points.
void draw_hand_marks(const SceneInput& input, const Camera& camera, const Look& look, SegmentPass& segments,
                     PointPass& points);

}  // namespace taxel::ui
