// The generalised winding number of triangles around a point: the sum of their solid angles over 4 pi (Jacobson, Kavan,
// Sorkine-Hornung 2013), by clusters (Barill et al. 2018).
//
// Around a closed surface it is a whole number; for one with holes it is about 1 inside and about 0 outside, so it
// separates the two without needing either. The sum over all triangles would cost O(n) per point. A node of the tree
// that is farther away than 2.5 times its radius counts as one dipole, with the sum of the area vectors at the centre
// of the areas; nearer nodes are opened. A point costs about O(log n). Pitfall: a face that is to be left out is never
// in a far cluster, since its own point is on it.
#include "core/mesh/query/winding_number.h"

#include "core/base/math.h"

namespace taxel {

WindingNumber::WindingNumber(const std::vector<dvec3>& points, std::vector<ivec3> faces)
    : points_(points), faces_(std::move(faces)) {
  constexpr double kReach = 2.5;  // radii of the cluster; less is faster and less exact
  std::vector<Aabb> boxes(faces_.size());
  for (std::size_t f = 0; f < faces_.size(); ++f)
    for (int c = 0; c < 3; ++c) boxes[f].include(points_[at(faces_[f][c])]);
  bvh_.build(boxes, 8);
  clusters_.resize(bvh_.nodes().size());
  std::vector<double> areas(clusters_.size(), 0);
  for (std::size_t i = clusters_.size(); i-- > 0;) {  // children have higher numbers than their parent
    const Bvh::Node& node = bvh_.nodes()[i];
    Cluster& cluster = clusters_[i];
    const auto add = [&](const dvec3& center, const dvec3& normal, double area) {
      cluster.center += area * center;
      cluster.normal += normal;
      areas[i] += area;
    };
    for (int k = 0; k < node.count; ++k) {
      const ivec3& face = faces_[at(bvh_.items()[at(node.first + k)])];
      const dvec3 &a = points_[at(face.x)], &b = points_[at(face.y)], &c = points_[at(face.z)];
      const dvec3 normal = 0.5 * glm::cross(b - a, c - a);
      add((a + b + c) / 3.0, normal, glm::length(normal));
    }
    for (int child = node.first; !node.leaf() && child < node.first + 2; ++child)
      add(clusters_[at(child)].center, clusters_[at(child)].normal, areas[at(child)]);
    cluster.center = areas[i] > 0 ? cluster.center / areas[i] : node.box.center();
    const dvec3 farthest = glm::max(node.box.hi - cluster.center, cluster.center - node.box.lo);
    cluster.squared_reach = kReach * kReach * glm::dot(farthest, farthest);
  }
}

double WindingNumber::without(const dvec3& p, int left_out) const {
  double sum = 0;
  std::array<std::int32_t, Bvh::kMaxDepth> stack;  // NOLINT: filled as it is used
  int size = 0;
  if (!bvh_.empty()) stack[at(size++)] = 0;
  while (size > 0) {
    const int index = stack[at(--size)];
    const Bvh::Node& node = bvh_.nodes()[at(index)];
    const Cluster& cluster = clusters_[at(index)];
    const dvec3 r = cluster.center - p;
    const double squared = glm::dot(r, r);
    if (squared > cluster.squared_reach) {  // never a cluster around p, and so never that of the face left out
      sum += glm::dot(r, cluster.normal) / (squared * std::sqrt(squared));
    } else if (node.leaf()) {
      for (int k = 0; k < node.count; ++k) {
        const int number = bvh_.items()[at(node.first + k)];
        if (number == left_out) continue;
        const ivec3& face = faces_[at(number)];
        sum += solid_angle(points_[at(face.x)] - p, points_[at(face.y)] - p, points_[at(face.z)] - p);
      }
    } else {
      stack[at(size++)] = node.first + 1;
      stack[at(size++)] = node.first;
    }
  }
  return sum / (4.0 * kPi);
}

}  // namespace taxel
