// The rays that a reading is made of: at true length with a dot where they hit, misses as faint stubs.
#pragma once

#include "ui/scene/color_map.h"
#include "ui/scene/paint/points.h"
#include "ui/scene/paint/segments.h"
#include "ui/scene/passes/look.h"
#include "ui/scene/sensor_view.h"

namespace taxel::ui {

struct RayMarks {
  Segments hits, misses;        ///< frame M
  std::vector<PointMark> dots;  ///< at the hits, coloured by pressure
};

/// Rays of the selected taxel, or of all whose reading is above 0 when none is selected, or all; thinned evenly and
/// repeatably where there are more than a picture can show. `spacing`: of samples on the screen [pixel].
RayMarks ray_marks(const SensorView& view, bool all, const PressureRange& range, const Look& look, double spacing);

}  // namespace taxel::ui
