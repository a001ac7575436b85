#include "core/hydro/behind_skin.h"

#include <algorithm>

namespace taxel {
namespace {

Aabb bounds_of(const std::vector<dvec3>& points) {
  Aabb box;
  for (const dvec3& x : points) box.include(x);
  return box;
}

}  // namespace

dvec3 inner_point(const HydroBody& body) {
  if (const auto* soft = std::get_if<SoftBody>(&body.geometry)) return bounds_of(soft->field->vertices()).center();
  const auto* rigid = std::get_if<RigidMesh>(&body.geometry);
  if (rigid == nullptr) return dvec3(0);
  const dvec3 middle = rigid->index->mesh().bounds().center();
  if (rigid->index->signed_distance(middle) <= 0) return middle;
  const std::vector<dvec3>& vertices = rigid->index->mesh().vertices();
  return *std::min_element(vertices.begin(), vertices.end(), [&](const dvec3& a, const dvec3& b) {
    return glm::distance(a, middle) < glm::distance(b, middle);
  });
}

BehindSkin behind_skin(const HydroBody& body, const dvec3& x) {
  if (const auto* space = std::get_if<SoftHalfSpace>(&body.geometry)) return {-x.z, space->thickness};
  const auto* soft = std::get_if<SoftBody>(&body.geometry);
  if (soft == nullptr || soft->depth == nullptr) return {};
  return {soft->depth->at(x).depth, soft->depth->thickness()};
}

}  // namespace taxel
