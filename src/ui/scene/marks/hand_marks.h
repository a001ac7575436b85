// A body in the hand, and what constraints hold together.
#pragma once

#include "ui/scene/paint/points.h"
#include "ui/scene/paint/segments.h"
#include "ui/scene/passes/look.h"
#include "ui/scene/scene_renderer.h"

namespace taxel::ui {

/// An arrow from the grabbed point to the hand, or an arc as wide as the turn; lines between points held together.
void draw_hand_marks(const SceneInput& input, const Camera& camera, const Look& look, SegmentPass& segments,
                     PointPass& points);

}  // namespace taxel::ui
