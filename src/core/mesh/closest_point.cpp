#include "core/mesh/closest_point.h"

#include <array>
#include <utility>

#include "core/mesh/edge_sides.h"
#include "core/mesh/point_triangle.h"
#include "core/mesh/ray_triangle.h"

namespace taxel {
namespace {

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

/// By value, so that it compiles to one instruction and not to a branch that nobody can predict.
inline double larger(double a, double b) {
  return a > b ? a : b;
}

inline dvec3 larger(const dvec3& a, const dvec3& b) {
  return {larger(a.x, b.x), larger(a.y, b.y), larger(a.z, b.z)};
}
inline dvec3 smaller(const dvec3& a, const dvec3& b) {
  return -larger(-a, -b);
}

inline double squared_distance(const Aabb& box, const dvec3& p) {
  const double x = larger(larger(box.lo.x - p.x, p.x - box.hi.x), 0.0);
  const double y = larger(larger(box.lo.y - p.y, p.y - box.hi.y), 0.0);
  const double z = larger(larger(box.lo.z - p.z, p.z - box.hi.z), 0.0);
  return x * x + y * y + z * z;
}

/// Rounding turns a normal, the cross product of two edges over its length, by at most some units in the last place of
/// the product of the edges' lengths.
std::vector<double> normal_errors(const TriMesh& mesh) {
  std::vector<double> errors(mesh.faces().size());
  for (int f = 0; f < mesh.face_count(); ++f) {
    const dvec3 ab = mesh.vertex(f, 1) - mesh.vertex(f, 0), ac = mesh.vertex(f, 2) - mesh.vertex(f, 0);
    errors[at(f)] =
        16 * std::numeric_limits<double>::epsilon() * glm::length(ab) * glm::length(ac) / mesh.face_areas()[at(f)];
  }
  return errors;
}

/// Sum of the normals of the faces at each face's three edges: the pseudonormal of an edge (both weigh pi),
/// unnormalised. Entry 3 f + c belongs to the edge from corner c to corner c + 1.
std::vector<dvec3> edge_pseudonormals(const TriMesh& mesh) {
  std::vector<dvec3> normals(3 * mesh.faces().size());
  for_each_edge(edge_sides(mesh), [&](std::span<const EdgeSide> sides) {
    dvec3 sum{0};
    for (const EdgeSide& side : sides) sum += mesh.face_normals()[at(side.face)];
    for (const EdgeSide& side : sides) normals[at(3 * side.face + side.corner)] = sum;
  });
  return normals;
}

}  // namespace

MeshIndex::MeshIndex(TriMeshPtr mesh)
    : mesh_(std::move(mesh)), edge_normals_(edge_pseudonormals(*mesh_)), normal_errors_(normal_errors(*mesh_)) {
  std::vector<Aabb> boxes(at(mesh_->face_count()));
  for (int f = 0; f < mesh_->face_count(); ++f) {
    for (int c = 0; c < 3; ++c) boxes[at(f)].include(mesh_->vertex(f, c));
  }
  bvh_.build(boxes);
}

SurfacePoint MeshIndex::closest_point(const dvec3& p, double within) const {
  SurfacePoint best;
  best.distance = std::numeric_limits<double>::infinity();
  if (bvh_.empty()) return best;
  // Distances carry roundings of the coordinates' size; boxes that are farther by less than that are still opened, so
  // that the face found does not depend on the shape of the tree.
  const dvec3 reach = glm::max(glm::max(glm::abs(mesh_->bounds().lo), glm::abs(mesh_->bounds().hi)), glm::abs(p));
  const double slack = 16 * std::numeric_limits<double>::epsilon() * glm::length(reach);
  double best_squared = best.distance, reach_limit = within + slack, limit = reach_limit * reach_limit;
  struct Waiting {  // not a pair: that would be zeroed kMaxDepth times for every query
    std::int32_t node;
    double squared_distance;
  };
  std::array<Waiting, Bvh::kMaxDepth> stack;  // NOLINT: filled as it is used
  int size = 0;
  stack[at(size++)] = {0, squared_distance(bvh_.nodes()[0].box, p)};
  while (size > 0) {
    const auto [index, d2] = stack[at(--size)];
    if (d2 > limit) continue;
    const Bvh::Node& node = bvh_.nodes()[at(index)];
    if (node.leaf()) {
      for (int i = node.first; i < node.first + node.count; ++i) {
        const int face = bvh_.items()[at(i)];
        const dvec3& a = mesh_->vertex(face, 0);
        // No point of a triangle is nearer than its plane: that spares most of them the search.
        const dvec3 from = p - a;
        const double above = std::abs(glm::dot(mesh_->face_normals()[at(face)], from));
        const double error = normal_errors_[at(face)] * (std::abs(from.x) + std::abs(from.y) + std::abs(from.z));
        if (above > reach_limit + error) continue;
        const dvec3 &b = mesh_->vertex(face, 1), &c = mesh_->vertex(face, 2);
        if (squared_distance({smaller(smaller(a, b), c), larger(larger(a, b), c)}, p) > limit) continue;
        const TrianglePoint q = nearest_on_triangle(p, a, b, c);
        if (q.squared_distance > best_squared || (q.squared_distance == best_squared && face > best.face)) continue;
        best_squared = q.squared_distance;
        best = {q.position, face, q.barycentric, std::sqrt(best_squared)};
        reach_limit = best.distance + slack;
        limit = reach_limit * reach_limit;
      }
      continue;
    }
    Waiting nearer{node.first, squared_distance(bvh_.nodes()[at(node.first)].box, p)};
    Waiting farther{node.first + 1, squared_distance(bvh_.nodes()[at(node.first + 1)].box, p)};
    if (farther.squared_distance < nearer.squared_distance) std::swap(nearer, farther);
    if (farther.squared_distance <= limit) stack[at(size++)] = farther;
    if (nearer.squared_distance <= limit) stack[at(size++)] = nearer;
  }
  return best;
}

std::optional<MeshHit> MeshIndex::cast(const Ray& ray) const {
  return cast_except(ray, -1);
}

std::optional<MeshHit> MeshIndex::cast_except(const Ray& ray, int except) const {
  MeshHit best;
  const RayTriangleTest test(ray);
  bvh_.cast(ray, [&](int face, double t_max) {
    if (face == except) return t_max;
    const auto hit = test(mesh_->vertex(face, 0), mesh_->vertex(face, 1), mesh_->vertex(face, 2), t_max);
    if (!hit || (best.face >= 0 && hit->t == best.t && face > best.face)) return t_max;
    best = {hit->t, face, hit->barycentric};
    return hit->t;
  });
  return best.face >= 0 ? std::optional(best) : std::nullopt;
}

SignedPoint MeshIndex::signed_point(const dvec3& p, double within) const {
  const SurfacePoint q = closest_point(p, within);
  if (q.face < 0) return {q, q.distance};
  // Pseudonormal of the feature that holds the point: exact zeros among the weights tell which (Baerentzen, Aanaes
  // 2005).
  dvec3 normal = mesh_->face_normals()[at(q.face)];
  for (int c = 0; c < 3; ++c) {
    const int next = (c + 1) % 3, opposite = (c + 2) % 3;
    if (q.barycentric[next] == 0 && q.barycentric[opposite] == 0) {
      normal = mesh_->vertex_normals()[at(mesh_->faces()[at(q.face)][c])];
      break;
    }
    if (q.barycentric[opposite] == 0 && q.barycentric[c] != 0) normal = edge_normals_[at(3 * q.face + c)];
  }
  return {q, glm::dot(p - q.position, normal) < 0 ? -q.distance : q.distance};
}

}  // namespace taxel
