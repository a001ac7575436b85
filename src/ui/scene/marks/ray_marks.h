// Marks of the rays of a reading: hits at full length with a dot at the hit, misses as faint stubs.
#pragma once

#include "ui/scene/color_map.h"
#include "ui/scene/paint/points.h"
#include "ui/scene/paint/segments.h"
#include "ui/scene/passes/look.h"
#include "ui/scene/sensor_view.h"

namespace taxel::ui {

struct RayMarks {
  Segments hits, misses;        ///< lines in frame M
  std::vector<PointMark> dots;  ///< dots at the hits, coloured by pressure
};

/// Returns the rays of the selected taxel, or of all taxels with readings above 0 if none is selected, or all rays if
/// `all` is true. If there are too many to distinguish, they are thinned evenly and always in the same way. `spacing`
/// is the distance of samples on the screen [pixel].
RayMarks ray_marks(const SensorView& view, bool all, const PressureRange& range, const Look& look, double spacing);

}  // namespace taxel::ui
