#include "core/hydro/surface_builder.h"

#include <array>

namespace taxel {

SurfaceBuilder::SurfaceBuilder(ContactSurface& out, const RigidTransform& X_AS, bool soft_is_a)
    : out_(out), X_AS_(X_AS), soft_is_a_(soft_is_a) {
  out_.clear();
}

bool SurfaceBuilder::add(std::span<const dvec3> points_S, const dvec3& normal_S, const LinearPressure& pressure,
                         const PolygonSource& source) {
  if (points_S.size() < 3) return false;
  // Fan about the first vertex: the sum of the triangles' areas and first moments.
  const dvec3& apex = points_S[0];
  double area = 0;
  dvec3 moment{0};
  for (std::size_t i = 1; i + 1 < points_S.size(); ++i) {
    const dvec3 a = points_S[i] - apex, b = points_S[i + 1] - apex;
    const double triangle = 0.5 * glm::dot(glm::cross(a, b), normal_S);
    area += triangle;
    moment += triangle / 3.0 * (a + b);
  }
  if (!(area > kSliverArea * source.size * source.size)) return reject("sliver", area);

  const dvec3 centroid_S = apex + moment / area;
  const double p = glm::dot(pressure.gradient, centroid_S) + pressure.constant;
  if (!(p > kTouchingPressure * source.size * glm::length(pressure.gradient))) return reject("touching", area);

  ContactPolygon polygon;
  polygon.first = static_cast<int>(out_.vertices.size());
  append_vertices(points_S, pressure, kMergeDistance * source.size);
  polygon.count = static_cast<int>(out_.vertices.size()) - polygon.first;
  // The rigid surface pushes the soft body along its own outward normal, and is pushed against it.
  polygon.normal = X_AS_.R * (soft_is_a_ ? normal_S : -normal_S);
  polygon.area = area;
  polygon.centroid = X_AS_(centroid_S);
  polygon.pressure = p;
  polygon.gradient = X_AS_.R * pressure.gradient;
  polygon.tet = source.tet;
  polygon.face = source.face;
  out_.polygons.push_back(polygon);
  return true;
}

void SurfaceBuilder::append_vertices(std::span<const dvec3> points_S, const LinearPressure& pressure,
                                     double merge_distance) {
  std::array<dvec3, kMaxVertices> kept;
  std::size_t count = 0;
  const auto near = [&](const dvec3& a, const dvec3& b) {
    return glm::dot(a - b, a - b) < merge_distance * merge_distance;
  };
  for (const dvec3& point : points_S) {
    if (count == 0 || !near(point, kept[count - 1])) kept[count++] = point;
  }
  while (count > 1 && near(kept[count - 1], kept[0])) --count;
  if (count < 3) {  // a strip narrower than the merging distance keeps what makes its area
    std::copy(points_S.begin(), points_S.end(), kept.begin());
    count = points_S.size();
  }
  if (!soft_is_a_) std::reverse(kept.begin(), kept.begin() + static_cast<std::ptrdiff_t>(count));
  for (std::size_t i = 0; i < count; ++i) {
    out_.vertices.push_back(X_AS_(kept[i]));
    out_.pressure.push_back(std::max(0.0, glm::dot(pressure.gradient, kept[i]) + pressure.constant));
  }
}

bool SurfaceBuilder::reject(const char* reason, double area) {
  for (RejectedPolygons& rejected : out_.rejected) {
    if (rejected.reason != reason) continue;
    ++rejected.count;
    rejected.area += std::max(0.0, area);
    return false;
  }
  out_.rejected.push_back({reason, 1, std::max(0.0, area)});
  return false;
}

}  // namespace taxel
