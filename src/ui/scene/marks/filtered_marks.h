// Marks of the polygons that were left out of contact surfaces, in the colour of the reason.
#pragma once

#include <span>
#include <vector>

#include "core/hydro/contact_surface.h"
#include "ui/scene/paint/points.h"
#include "ui/scene/paint/segments.h"

namespace taxel::ui {

/// The outline of each polygon, and a dot at its centre, because many of them have almost no area. Frame M.
struct FilteredMarks {
  Segments edges;
  std::vector<PointMark> dots;
};
FilteredMarks filtered_marks(std::span<const ContactSurface> surfaces);

}  // namespace taxel::ui
