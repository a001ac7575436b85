// Nearest points of a mesh, first hits of rays, and signed distances.
//
// The tree is visited roughly from near to far, and a box farther than the best point is skipped. The plane of a
// triangle excludes many triangles before their edges are looked at. The sign comes from the angle-weighted
// pseudonormal of the feature that holds the nearest point (Baerentzen, Aanaes 2005): a face, an edge or a vertex,
// which exact zeros among the barycentric weights name.
//
// Pitfalls. Boxes that are farther by less than the rounding error of a distance are visited as well, and ties go to
// the lowest face, so the result does not depend on the shape of the tree. The normals of needles have errors; each
// normal has a bound, by which its plane is moved away. Rays through an edge give the lowest face, too.
#include "core/mesh/query/closest_point.h"

#include <algorithm>
#include <utility>

#include "core/base/math.h"
#include "core/mesh/query/triangle.h"

namespace taxel {
namespace {

/// Returns a bound of the rounding error of each unit normal: a normal is the cross product of two edges over its
/// length, and the product is exact to some units in the last place of the product of the edges' lengths.
std::vector<float> normal_errors(const TriMesh& mesh) {
  std::vector<float> errors(mesh.faces().size());
  for (int f = 0; f < mesh.face_count(); ++f) {
    const dvec3 ab = mesh.vertex(f, 1) - mesh.vertex(f, 0), ac = mesh.vertex(f, 2) - mesh.vertex(f, 0);
    const double error =
        16 * std::numeric_limits<double>::epsilon() * glm::length(ab) * glm::length(ac) / mesh.face_areas()[at(f)];
    errors[at(f)] = std::nextafter(static_cast<float>(error), std::numeric_limits<float>::infinity());
  }
  return errors;
}

/// Returns the sum of the normals of all faces at the edge of a half-edge: the pseudonormal of the edge, in which both
/// faces have the weight pi, unnormalised. The order of the sum is that of the faces.
dvec3 edge_pseudonormal(const TriMesh& mesh, int h) {
  const EdgeTopology& edges = mesh.topology();
  const auto normal_at = [&](int half_edge) { return mesh.face_normals()[at(half_edge / 3)]; };
  if (const int twin = edges.twin(h); twin >= 0) return normal_at(std::min(h, twin)) + normal_at(std::max(h, twin));
  dvec3 sum{0};
  for (const int half_edge : edges.edge_between(edges.from(h), edges.to(h))) sum += normal_at(half_edge);
  return sum;
}

}  // namespace

BoxTree tree_of_faces(const TriMesh& mesh, Bvh::Effort effort) {
  std::vector<Aabb> boxes(mesh.faces().size());
  for (int f = 0; f < mesh.face_count(); ++f)
    for (int c = 0; c < 3; ++c) boxes[at(f)].include(mesh.vertex(f, c));
  return BoxTree(boxes, effort);
}

MeshIndex::MeshIndex(TriMeshPtr mesh, Bvh::Effort effort)
    : mesh_(std::move(mesh)), tree_(tree_of_faces(*mesh_, effort)) {
  normal_errors_ = normal_errors(*mesh_);  // after the build of the tree, which takes the most memory
}

std::vector<int> MeshIndex::faces_near(const dvec3& p, double reach) const {
  std::vector<int> faces;
  tree_.visit_near(p, reach, [&](int face) {
    faces.push_back(face);
    return reach;
  });
  std::sort(faces.begin(), faces.end());
  return faces;
}

SurfacePoint MeshIndex::closest_point(const dvec3& p, double within) const {
  // Squares of longer distances overflow. From that far, only the direction decides which point is nearest.
  constexpr double kLongest = 1e150;  // [m]
  if (const double far = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
      far > kLongest && far <= std::numeric_limits<double>::max()) {
    SurfacePoint nearest = closest_point(p * (kLongest / far), within * (kLongest / far));
    nearest.distance *= far / kLongest;
    return nearest;
  }
  SurfacePoint best;
  best.distance = std::numeric_limits<double>::infinity();
  if (tree_.empty()) return best;
  // Rounding errors of distances grow with the coordinates. Boxes that are farther by less than these errors are still
  // visited, so that the result does not depend on the shape of the tree.
  const dvec3 reach = glm::max(glm::max(glm::abs(mesh_->bounds().lo), glm::abs(mesh_->bounds().hi)), glm::abs(p));
  const double slack = 16 * std::numeric_limits<double>::epsilon() * glm::length(reach);
  double best_squared = (within + slack) * (within + slack);
  tree_.visit_near(p, within + slack, [&, reach = within + slack](int face) mutable {
    const dvec3& a = mesh_->vertex(face, 0);
    // No point of a triangle is nearer than its plane, which excludes many triangles quickly.
    const dvec3 from = p - a;
    const double above = std::abs(glm::dot(mesh_->face_normals()[at(face)], from));
    const double error = normal_errors_[at(face)] * (std::abs(from.x) + std::abs(from.y) + std::abs(from.z));
    if (above > reach + error) return reach;
    const TrianglePoint q = nearest_on_triangle(p, a, mesh_->vertex(face, 1), mesh_->vertex(face, 2));
    const bool is_tie = best.face >= 0 && q.squared_distance == best_squared;
    if (q.squared_distance > best_squared || (is_tie && face > best.face)) return reach;
    best_squared = q.squared_distance;
    best = {q.position, face, q.barycentric, std::sqrt(best_squared)};
    return reach = best.distance + slack;
  });
  return best;
}

std::optional<MeshHit> MeshIndex::cast(const Ray& ray) const {
  return cast_except(ray, -1);
}

std::optional<MeshHit> MeshIndex::cast_except(const Ray& ray, int except) const {
  MeshHit best;
  const RayTriangleTest test(ray);
  tree_.cast(ray, [&](int face, double t_max) {
    if (face == except) return t_max;
    const auto hit = test(mesh_->vertex(face, 0), mesh_->vertex(face, 1), mesh_->vertex(face, 2), t_max);
    if (!hit || (best.face >= 0 && hit->t == best.t && face > best.face)) return t_max;
    best = {hit->t, face, hit->barycentric};
    return hit->t;
  });
  return best.face >= 0 ? std::optional(best) : std::nullopt;
}

SignedPoint MeshIndex::signed_point(const dvec3& p, double within) const {
  const SurfacePoint nearest = closest_point(p, within);
  return nearest.face < 0 ? SignedPoint{nearest, nearest.distance} : with_sign(p, nearest);
}

SignedPoint MeshIndex::with_sign(const dvec3& p, const SurfacePoint& q) const {
  dvec3 normal = mesh_->face_normals()[at(q.face)];
  for (int c = 0; c < 3; ++c) {
    const int next = (c + 1) % 3, opposite = (c + 2) % 3;
    if (q.barycentric[next] == 0 && q.barycentric[opposite] == 0) {
      normal = mesh_->vertex_normals()[at(mesh_->faces()[at(q.face)][c])];
      break;
    }
    if (q.barycentric[opposite] == 0 && q.barycentric[c] != 0) normal = edge_pseudonormal(*mesh_, 3 * q.face + c);
  }
  return {q, glm::dot(p - q.position, normal) < 0 ? -q.distance : q.distance};
}

}  // namespace taxel
