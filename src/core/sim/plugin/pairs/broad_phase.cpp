#include "core/sim/plugin/pairs/broad_phase.h"

#include <limits>
#include <span>

namespace taxel {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kNothing = -kInfinite;
/// Factor that enlarges the bounds. The enlargement is far above the rounding errors of positions and bounds.
constexpr double kSlack = 1 + 1e-9;

/// Returns the radius of the bounding sphere about the geom's origin.
double bounding_radius(std::span<const dvec3> vertices_B, const RigidTransform& X_GB) {
  double farthest = 0;
  for (const dvec3& v_B : vertices_B) {
    const dvec3 v = X_GB(v_B);
    farthest = std::max(farthest, glm::dot(v, v));
  }
  return kSlack * std::sqrt(farthest);
}

/// Returns true if a sphere reaches below the plane z = 0 of a geom.
bool reaches(const mjData& d, int geom, const dvec3& center_W, double radius) {
  const mjtNum *p = d.geom_xpos + 3 * geom, *R = d.geom_xmat + 9 * geom;
  return glm::dot(center_W - dvec3(p[0], p[1], p[2]), dvec3(R[2], R[5], R[8])) <= radius;
}

}  // namespace

void BroadPhase::clear() {
  geoms_.clear();
  radii_.clear();
}

void BroadPhase::add(int geom) {
  geoms_.push_back(geom);
  radii_.push_back(kNothing);
}

void BroadPhase::set_body(std::size_t number, const HydroBody& body, const Pose& X_GB) {
  double& radius = radii_[number];
  radius = kInfinite;
  if (const auto* soft = std::get_if<SoftBody>(&body.geometry))
    radius = bounding_radius(soft->field->vertices(), RigidTransform(X_GB));
  if (const auto* rigid = std::get_if<RigidMesh>(&body.geometry))
    radius = bounding_radius(rigid->index->mesh().vertices(), RigidTransform(X_GB));
}

void BroadPhase::remove_body(std::size_t number) {
  radii_[number] = kNothing;
}

void BroadPhase::find(const mjData& d, const dvec3& center_W, double radius, std::vector<std::size_t>& near) const {
  near.clear();
  radius *= kSlack;
  for (std::size_t i = 0; i < geoms_.size(); ++i) {
    const double reach = radius + radii_[i];
    const mjtNum* p = d.geom_xpos + 3 * geoms_[i];
    const double x = p[0] - center_W.x, y = p[1] - center_W.y, z = p[2] - center_W.z;
    if (!(std::abs(x) <= reach) || x * x + y * y + z * z > reach * reach) continue;
    if (reach < kInfinite || reaches(d, geoms_[i], center_W, radius)) near.push_back(i);
  }
}

}  // namespace taxel
