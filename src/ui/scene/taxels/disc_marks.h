// The receptive fields of responding taxels as discs on the skin that glow in the colours of their readings.
#pragma once

#include <vector>

#include "ui/scene/geometry/skin_paint.h"
#include "ui/scene/sensor_view.h"

namespace taxel::ui {

struct DiscMarks {
  std::vector<PaintVertex> triangles;  ///< frame M, the largest reading last
  int discs = 0;                       ///< number of taxels with a disc
};

/// Returns the discs of one sensor. There are none without overlays.receptive_fields and
/// overlays.reading_discs, before the fields are computed, and
/// of sensors whose readings have another unit than those of the selected sensor, whose range colours them. Discs that
/// face the eye behind the skin of another sensor have `dim` times the opacity of other discs.
[[nodiscard]] DiscMarks disc_marks(const SceneInput& input, const std::vector<SensorView>& views,
                                   const SensorView& view, const dvec3& eye_W, float dim);

}  // namespace taxel::ui
