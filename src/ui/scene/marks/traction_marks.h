// Marks of the tractions of contact surfaces, as arrows.
#pragma once

#include <vector>

#include "core/sensor/surface_motion.h"
#include "ui/scene/field_numbers.h"
#include "ui/scene/paint/segments.h"
#include "ui/scene/passes/look.h"
#include "ui/scene/sensor_view.h"

namespace taxel::ui {

/// Two arrows from the centroid of each polygon, with the values of traction(): p n, the pressure with damping along
/// the normal that pushes the sensor, and the friction t: in the plane of the polygon, or that of the bristles if it
/// sticks. Frame M.
struct TractionMarks {
  Segments normal, friction;
  TractionNumbers numbers;
};
/// Builds the arrows. The length of an arrow for the largest pressure of the range is a seventh of the sensor's
/// diagonal.
TractionMarks traction_marks(const SensorView& view, const PressureRange& range, const Look& look);

}  // namespace taxel::ui
