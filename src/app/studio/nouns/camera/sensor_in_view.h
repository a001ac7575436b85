// Tests of whether the 3-D view shows the sensors.
#pragma once

#include <array>
#include <vector>

#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"

namespace taxel::ui {

/// The eight corners of a sensor's bounding box, which is aligned with the axes of its mesh [m], world.
using BoxCorners = std::array<dvec3, 8>;

/// Returns the boxes of the sensors that the present mode shows: all sensors of the scene in SIMULATE, and the sensor
/// of the document in LAYOUT.
[[nodiscard]] std::vector<BoxCorners> sensor_boxes(const Viewer& viewer, const Shown& shown);

/// Returns whether every corner of the box projects into the view.
[[nodiscard]] bool is_inside_view(const BoxCorners& box_W, const Camera& camera, int width, int height);

/// Returns whether the whole box is beyond one side of the view, or behind the eye. A box that surrounds the view is
/// not outside.
[[nodiscard]] bool is_outside_view(const BoxCorners& box_W, const Camera& camera, int width, int height);

/// Returns whether every sensor of the present mode is outside the view. False before the view has a size, and without
/// sensors.
[[nodiscard]] bool sensors_are_outside_view(const Viewer& viewer, const Shown& shown);

}  // namespace taxel::ui
