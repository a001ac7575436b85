// Marks of the polygons that were left out of contact surfaces.
#include "ui/scene/marks/marks.h"

#include "ui/scene/color_map.h"

namespace taxel::ui {

FilteredMarks filtered_marks(std::span<const ContactSurface> surfaces) {
  constexpr float kWidth = 1.8f;  // [pixel]
  FilteredMarks marks;
  for (const ContactSurface& surface : surfaces) {
    for (const FilteredPolygon& polygon : surface.filtered) {
      const std::uint32_t rgba = pack(rejection_color(polygon.reason));
      const std::span<const dvec3> corners =
          std::span(surface.filtered_vertices)
              .subspan(static_cast<std::size_t>(polygon.first), static_cast<std::size_t>(polygon.count));
      dvec3 sum(0);
      for (std::size_t i = 0; i < corners.size(); ++i) {
        sum += corners[i];
        marks.edges.push_back(segment(corners[i], corners[(i + 1) % corners.size()], kWidth, rgba));
      }
      marks.dots.push_back(point_mark(sum / static_cast<double>(corners.size()), dvec3(0), 1, rgba));
    }
  }
  return marks;
}

}  // namespace taxel::ui
