#include "core/sensor/explain/behind/back_faces_behind.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "core/base/index.h"

namespace taxel {
namespace {

/// Returns true if the segment from `from` along `way` to the depth `end` [m] meets the convex polygon.
bool meets(const dvec3& from, const dvec3& way, double end, std::span<const dvec3> polygon) {
  dvec3 normal(0);  // twice the area along the unit normal
  for (std::size_t i = 2; i < polygon.size(); ++i)
    normal += glm::cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
  const double along = glm::dot(normal, way);
  if (along == 0) return false;
  const double depth = glm::dot(normal, polygon[0] - from) / along;
  if (!(depth >= 0 && depth < end)) return false;
  const dvec3 x = from + depth * way;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const dvec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    if (glm::dot(glm::cross(b - a, x - a), normal) < 0) return false;
  }
  return true;
}

}  // namespace

std::string back_faces_text(const Explanation& explanation) {
  if (explanation.samples_at_back_faces == 0) return "";
  return fmt::format(
      "Back face left out: {} of {} samples would read a face that opposes the pressure, such as the far face of a "
      "thin body. It does not count, or in part (material/faces).",
      explanation.samples_at_back_faces, explanation.samples.size());
}

int count_samples_at_back_faces(const SensorModel& model, int taxel, const SensorStep& step) {
  std::vector<std::span<const dvec3>> back_faces;
  for (const ContactSurface& surface : step.surfaces)
    for (const FilteredPolygon& one : surface.filtered)
      if (one.reason == Rejection::back_face)
        back_faces.push_back(std::span(surface.filtered_vertices).subspan(at(one.first), at(one.count)));
  int count = 0;
  for (int e = model.fields.first[at(taxel)]; e < model.fields.first[at(taxel) + 1]; ++e) {
    const std::size_t number = at(model.readout_table.ray_of_entry[at(e)]);
    const SensorRay& ray = model.rays[number];
    const RayHit& hit = step.hits[number];
    const bool is_partial = hit.hit() && step.surfaces[at(hit.surface)].polygons[at(hit.polygon)].weight < 1;
    const double end = hit.hit() ? hit.depth : ray.max_depth;
    if (is_partial || std::any_of(back_faces.begin(), back_faces.end(), [&](std::span<const dvec3> polygon) {
          return meets(ray.origin, ray.direction, end, polygon);
        }))
      ++count;
  }
  return count;
}

}  // namespace taxel
