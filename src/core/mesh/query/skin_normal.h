// The interpolated normal of a mesh at a point of a face.
#pragma once

#include "core/mesh/query/point_triangle.h"
#include "core/mesh/tri_mesh.h"

namespace taxel {

/// Returns the vertex normals interpolated with the weights of a face's corners, normalised (Phong 1975). The result is
/// continuous across edges. It is the face's normal where the vertex normals cancel out.
inline dvec3 skin_normal_at_weights(const TriMesh& mesh, int face, const dvec3& barycentric) {
  const ivec3& corners = mesh.faces()[static_cast<std::size_t>(face)];
  dvec3 n(0);
  for (int c = 0; c < 3; ++c) n += barycentric[c] * mesh.vertex_normals()[static_cast<std::size_t>(corners[c])];
  const double length = glm::length(n);
  return length > 0.0 && std::isfinite(length) ? n / length : mesh.face_normals()[static_cast<std::size_t>(face)];
}

/// Returns the interpolated unit normal at the point of a face that is nearest to `point`.
inline dvec3 skin_normal(const TriMesh& mesh, int face, const dvec3& point) {
  const TrianglePoint at = nearest_on_triangle(point, mesh.vertex(face, 0), mesh.vertex(face, 1), mesh.vertex(face, 2));
  return skin_normal_at_weights(mesh, face, at.barycentric);
}

}  // namespace taxel
