// The rigid motion by three corners that are far apart, and distances from points spread over the surfaces.

#include "core/mesh/compare.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "core/mesh/query/closest_point.h"

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

namespace {

/// Returns points spread evenly by area: the k-th at (k + 1/2) / count of the area in the order of the faces, within
/// its face by the R2 sequence (Roberts 2018).
std::vector<dvec3> spread_points(const TriMesh& mesh, int count) {
  constexpr double kA = 0.7548776662466927, kB = 0.5698402909980532;
  std::vector<double> sums(mesh.face_areas().size());
  std::partial_sum(mesh.face_areas().begin(), mesh.face_areas().end(), sums.begin());
  std::vector<dvec3> points;
  points.reserve(static_cast<std::size_t>(count));
  for (int k = 0; k < count; ++k) {
    const double area = sums.back() * (k + 0.5) / count;
    const auto face = static_cast<int>(std::min<std::ptrdiff_t>(
        std::upper_bound(sums.begin(), sums.end(), area) - sums.begin(), static_cast<std::ptrdiff_t>(sums.size()) - 1));
    double u = std::fmod(0.5 + kA * k, 1.0), v = std::fmod(0.5 + kB * k, 1.0);
    if (u + v > 1) u = 1 - u, v = 1 - v;
    points.push_back((1 - u - v) * mesh.vertex(face, 0) + u * mesh.vertex(face, 1) + v * mesh.vertex(face, 2));
  }
  return points;
}

}  // namespace

SurfaceDistance measure_surface_distance(const TriMeshPtr& a, const TriMeshPtr& b, int points) {
  SurfaceDistance found;
  double squares = 0;
  for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)}) {
    const MeshIndex index(to);
    for (const dvec3& p : spread_points(*from, points)) {
      const double distance = index.closest_point(p).distance;
      found.largest = std::max(found.largest, distance);
      squares += distance * distance;
    }
    for (const dvec3& p : from->vertices()) found.largest = std::max(found.largest, index.closest_point(p).distance);
  }
  found.rms = std::sqrt(squares / (2.0 * points));
  return found;
}

}  // namespace taxel
