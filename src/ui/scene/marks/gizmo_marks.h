// Draws the gizmo as flat marks on the screen.
#pragma once

#include "ui/scene/paint/points.h"
#include "ui/scene/paint/segments.h"
#include "ui/scene/passes/look.h"
#include "ui/scene/pick/gizmo.h"

namespace taxel::ui {

/// Draws over the present content. The frame must be a pixel_frame(), of a view of this size in pixels of marks.
void draw_gizmo(SegmentPass& segments, PointPass& points, const Camera& camera, const Look& look, const dvec2& view);

}  // namespace taxel::ui
