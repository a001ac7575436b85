// Tractions of contact surfaces as arrows.
#pragma once

#include <vector>

#include "core/sensor/surface_motion.h"
#include "ui/scene/field_numbers.h"
#include "ui/scene/paint/segments.h"
#include "ui/scene/passes/look.h"
#include "ui/scene/sensor_view.h"

namespace taxel::ui {

/// Of each polygon, from its centroid: p n, the pressure with damping along the normal that pushes the sensor, and the
/// friction t in its plane, as traction() has them. Frame M.
struct TractionMarks {
  Segments normal, friction;
  TractionNumbers numbers;
};
/// An arrow of the largest pressure of the range is a seventh of the sensor's diagonal long.
TractionMarks traction_marks(const SensorView& view, const PressureRange& range, const Look& look);

}  // namespace taxel::ui
