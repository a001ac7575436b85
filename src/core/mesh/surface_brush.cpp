#include "core/mesh/surface_brush.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "core/mesh/query/point_triangle.h"

namespace taxel {
namespace {

/// Ascending.
std::vector<int> faces_within(const MeshIndex& index, const SurfacePoint& at, const SurfaceBrush& brush) {
  const TriMesh& mesh = index.mesh();
  const dvec3 normal = mesh.face_normals()[static_cast<std::size_t>(at.face)];
  const double least_cosine = std::cos(brush.max_angle_deg * kPi / 180.0);
  std::vector<int> faces{at.face};
  index.bvh().visit(
      [&](const Aabb& box) {
        return glm::distance(glm::clamp(at.position, box.lo, box.hi), at.position) <= brush.radius;
      },
      [&](int face) {
        if (face == at.face || !(glm::dot(mesh.face_normals()[static_cast<std::size_t>(face)], normal) > least_cosine))
          return;
        const TrianglePoint nearest =
            nearest_on_triangle(at.position, mesh.vertex(face, 0), mesh.vertex(face, 1), mesh.vertex(face, 2));
        if (nearest.squared_distance <= brush.radius * brush.radius) faces.push_back(face);
      });
  std::sort(faces.begin(), faces.end());
  return faces;
}

}  // namespace

std::vector<int> faces_under_brush(const MeshIndex& index, const SurfacePoint& at, const SurfaceBrush& brush) {
  const TriMesh& mesh = index.mesh();
  const std::vector<int> within = faces_within(index, at, brush);
  using Edge = std::pair<int, int>;
  const auto edge_of = [&](int face, int corner) -> Edge {
    const ivec3 v = mesh.faces()[static_cast<std::size_t>(face)];
    return std::minmax(v[corner], v[(corner + 1) % 3]);
  };
  std::vector<std::pair<Edge, int>> sides;
  for (const int face : within)
    for (int corner = 0; corner < 3; ++corner) sides.emplace_back(edge_of(face, corner), face);
  std::sort(sides.begin(), sides.end());
  std::vector<int> painted{at.face};
  std::vector<bool> done(within.size(), false);
  const auto number = [&](int face) {
    return static_cast<std::size_t>(std::lower_bound(within.begin(), within.end(), face) - within.begin());
  };
  done[number(at.face)] = true;
  for (std::size_t next = 0; next < painted.size(); ++next) {  // grows
    for (int corner = 0; corner < 3; ++corner) {
      const Edge edge = edge_of(painted[next], corner);
      auto side = std::lower_bound(sides.begin(), sides.end(), std::pair(edge, -1));
      for (; side != sides.end() && side->first == edge; ++side) {
        const std::size_t neighbour = number(side->second);
        if (!done[neighbour]) painted.push_back(side->second);
        done[neighbour] = true;
      }
    }
  }
  std::sort(painted.begin(), painted.end());
  return painted;
}

std::vector<int> with_faces(const std::vector<int>& region, const std::vector<int>& painted) {
  std::vector<int> out;
  std::set_union(region.begin(), region.end(), painted.begin(), painted.end(), std::back_inserter(out));
  return out;
}

std::vector<int> without_faces(const std::vector<int>& region, const std::vector<int>& erased) {
  std::vector<int> out;
  std::set_difference(region.begin(), region.end(), erased.begin(), erased.end(), std::back_inserter(out));
  return out;
}

double area_of_faces(const TriMesh& mesh, const std::vector<int>& faces) {
  double area = 0;
  for (const int face : faces)
    if (face >= 0 && face < mesh.face_count()) area += mesh.face_areas()[static_cast<std::size_t>(face)];
  return area;
}

}  // namespace taxel
