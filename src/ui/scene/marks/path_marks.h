// The path of the finger, and the line between the points of the measure tool.
#pragma once

#include "ui/scene/paint/points.h"
#include "ui/scene/paint/segments.h"
#include "ui/scene/passes/look.h"
#include "ui/scene/scene_input.h"

namespace taxel::ui {

/// Returns the drawn path in the world [m]: the edited one, or that of the frame; empty without a path.
[[nodiscard]] std::vector<dvec3> drawn_path(const SceneInput& input);

/// Draws the path of the finger, with the waypoints of an edited path in front of everything else.
void draw_path_marks(const SceneInput& input, const Look& look, SegmentPass& segments, PointPass& points);

/// Draws the measured path on the skin as a thick line, and the straight distance as a thin line.
void draw_measure_marks(const SceneInput& input, const Look& look, SegmentPass& segments, PointPass& points);

}  // namespace taxel::ui
