#include "core/mesh/topology/surface_distance.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/mesh/query/closest_point.h"

namespace taxel {
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
