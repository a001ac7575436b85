#include "core/mesh/surface_brush.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/mesh/query/triangle.h"

namespace taxel {
namespace {

/// Returns the faces within the brush, connected or not, ascending.
std::vector<int> faces_within(const MeshIndex& index, const SurfacePoint& at, const SurfaceBrush& brush) {
  const TriMesh& mesh = index.mesh();
  const dvec3 normal = mesh.face_normals()[static_cast<std::size_t>(at.face)];
  const double least_cosine = std::cos(brush.max_angle_deg * kPi / 180.0);
  std::vector<int> faces{at.face};
  for (const int face : index.faces_near(at.position, brush.radius)) {
    if (face == at.face || !(glm::dot(mesh.face_normals()[static_cast<std::size_t>(face)], normal) > least_cosine))
      continue;
    const TrianglePoint nearest =
        nearest_on_triangle(at.position, mesh.vertex(face, 0), mesh.vertex(face, 1), mesh.vertex(face, 2));
    if (nearest.squared_distance <= brush.radius * brush.radius) faces.push_back(face);
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

}  // namespace

std::vector<int> faces_under_brush(const MeshIndex& index, const SurfacePoint& at, const SurfaceBrush& brush) {
  const TriMesh& mesh = index.mesh();
  const std::vector<int> within = faces_within(index, at, brush);
  const EdgeTopology& edges = mesh.topology();
  std::vector<int> painted{at.face};
  std::vector<bool> is_painted(within.size(), false);
  const auto number = [&](int face) { return std::lower_bound(within.begin(), within.end(), face) - within.begin(); };
  is_painted[static_cast<std::size_t>(number(at.face))] = true;
  for (std::size_t next = 0; next < painted.size(); ++next) {  // `painted` grows in the loop
    for (int h = 3 * painted[next], end = h + 3; h < end; ++h) {
      for (const int other : edges.edge_between(edges.from(h), edges.to(h))) {
        const auto neighbour = static_cast<std::size_t>(number(other / 3));
        if (neighbour == within.size() || within[neighbour] != other / 3 || is_painted[neighbour]) continue;
        painted.push_back(other / 3);
        is_painted[neighbour] = true;
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
