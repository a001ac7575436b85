// Arrows of the tractions of contact surfaces.
#include "ui/scene/marks/marks.h"

namespace taxel::ui {
namespace {

constexpr double kLongest = 1.0 / 7;  // of the mesh's diagonal, for the range's upper end
constexpr float kWidth = 1.1f;        // [pixel]

}  // namespace

TractionMarks traction_marks(const SensorView& view, const PressureRange& range, const Look& look) {
  TractionMarks out;
  TractionNumbers& numbers = out.numbers;
  const SensorStep& state = *view.state;
  numbers.metres_per_pascal = range.hi > 0 ? kLongest * view.model->mesh->bounds().diagonal() / range.hi : 0.0;
  numbers.friction_known = state.motions.size() == state.surfaces.size() && !state.surfaces.empty();
  const bool can_stick = state.sticking.size() == state.surfaces.size();
  const auto add = [&](Segments& to, const dvec3& from, const dvec3& traction, const glm::vec4& color,
                       double& largest) {
    const double size = glm::length(traction);
    if (!(size > 0)) return;
    largest = std::max(largest, size);
    to.push_back(segment(from, from + numbers.metres_per_pascal * traction, kWidth, pack(color)));
  };
  for (std::size_t s = 0; s < state.surfaces.size(); ++s) {
    SurfaceMotion motion = numbers.friction_known ? state.motions[s] : SurfaceMotion{};
    if (can_stick && !state.sticking[s].roots.empty()) motion.sticking = &state.sticking[s];
    for (const ContactPolygon& polygon : state.surfaces[s].polygons) {
      const dvec3 v = motion.velocity(polygon.centroid);
      // p = p0 (1 - d vn)+: Hunt and Crossley (1975), as traction.h
      const double damping = std::max(0.0, 1 - motion.properties.dissipation * glm::dot(v, polygon.normal));
      ++numbers.polygons;
      add(out.normal, polygon.centroid, damping * polygon.pressure * polygon.normal, look.force,
          numbers.largest_pressure);
      add(out.friction, polygon.centroid, motion.friction(polygon.pressure, polygon.normal, polygon.centroid),
          look.friction, numbers.largest_friction);
    }
  }
  return out;
}

}  // namespace taxel::ui
