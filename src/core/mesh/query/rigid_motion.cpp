#include "core/mesh/query/rigid_motion.h"

#include <array>

namespace taxel {
namespace {

/// A corner of a mesh: its face and its number in the face.
struct FaceCorner {
  int face = 0, number = 0;
};

dvec3 position_of(const TriMesh& mesh, FaceCorner corner) {
  return mesh.vertex(corner.face, corner.number);
}

/// Returns the corner with the largest value of a function of its place.
template <class Value>
FaceCorner find_largest(const TriMesh& mesh, const Value& value_of) {
  FaceCorner largest;
  double value = -1;
  for (int f = 0; f < mesh.face_count(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const double here = value_of(mesh.vertex(f, k));
      if (here > value) {
        value = here;
        largest = {f, k};
      }
    }
  }
  return largest;
}

/// Returns three corners that are far apart and not on a line, unless all corners are.
std::array<FaceCorner, 3> find_distant_corners(const TriMesh& mesh) {
  const dvec3 center = mesh.bounds().center();
  const FaceCorner first = find_largest(mesh, [&](const dvec3& p) { return glm::distance(p, center); });
  const dvec3 a = position_of(mesh, first);
  const FaceCorner second = find_largest(mesh, [&](const dvec3& p) { return glm::distance(p, a); });
  const dvec3 along = position_of(mesh, second) - a;
  const FaceCorner third = find_largest(mesh, [&](const dvec3& p) { return glm::length(glm::cross(p - a, along)); });
  return {first, second, third};
}

/// Returns the axes that three points span: along the first edge, in the plane, and normal to it.
dmat3 axes_of(const TriMesh& mesh, const std::array<FaceCorner, 3>& corners) {
  const dvec3 a = position_of(mesh, corners[0]);
  const dvec3 x = glm::normalize(position_of(mesh, corners[1]) - a);
  const dvec3 z = glm::normalize(glm::cross(x, position_of(mesh, corners[2]) - a));
  return {x, glm::cross(z, x), z};
}

}  // namespace

std::optional<Pose> find_rigid_motion(const TriMesh& from, const TriMesh& to, double tolerance) {
  if (from.face_count() == 0 || from.face_count() != to.face_count()) return std::nullopt;
  const std::array<FaceCorner, 3> corners = find_distant_corners(from);
  const dmat3 R = axes_of(to, corners) * glm::transpose(axes_of(from, corners));
  const Pose X{glm::normalize(glm::quat_cast(R)), position_of(to, corners[0]) - R * position_of(from, corners[0])};
  const RigidTransform move(X);
  for (int f = 0; f < from.face_count(); ++f)
    for (int k = 0; k < 3; ++k)
      if (!(glm::distance(move(from.vertex(f, k)), to.vertex(f, k)) <= tolerance)) return std::nullopt;
  return X;
}

}  // namespace taxel
