// Trees with eight children per node, and the facets of a rigid mesh.
//
// The tree is built from the centers of the boxes: a group is halved at the median of its widest axis, the largest
// group first, until there are eight. Halves are multiples of eight where possible, so that whole nodes stay together.
// This takes O(n log n), and ties go by number, so the tree is the same on every machine.
//
// Boxes are in single precision about the middle of all boxes and rounded outward, so that eight of them are tested at
// once and a query only has to be widened by the rounding of single precision. The facets are then renumbered in the
// order of their tree, so that neighbours are close in memory.
//
// Two triangles that form a parallelogram are one facet. The longest edge of a face is tried first: without the
// diagonals of rectangles, all facets of a grid are alike. A face that folds back is no parallelogram (kSameSide).
#include "core/hydro/kernel/index/wide_tree.h"

#include <algorithm>
#include <numeric>

#include "core/base/math.h"

namespace taxel {
namespace {

using Items = std::span<std::int32_t>;

/// Halves by count at the median of the widest axis of the centers; ties by number. Whole nodes stay together: the
/// first half is a multiple of eight where that is possible.
std::size_t halve(std::span<const dvec3> centers, Items items) {
  Aabb box;
  for (const std::int32_t i : items) box.include(centers[at(i)]);
  const dvec3 e = box.extent();
  const int axis = e.x >= e.y && e.x >= e.z ? 0 : e.y >= e.z ? 1 : 2;
  std::size_t middle = items.size() / 2;
  if (items.size() > kWide) middle = std::max(kWide, (middle + kWide / 2) / kWide * kWide);
  std::nth_element(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(middle), items.end(),
                   [&](std::int32_t a, std::int32_t b) {
                     const double ca = centers[at(a)][axis], cb = centers[at(b)][axis];
                     return ca != cb ? ca < cb : a < b;
                   });
  return middle;
}

/// Up to eight groups.
std::size_t split(std::span<const dvec3> centers, Items items, std::array<Items, kWide>& groups) {
  groups[0] = items;
  std::size_t count = 1;
  while (count < kWide) {
    std::size_t largest = 0;
    for (std::size_t g = 1; g < count; ++g) {
      if (groups[g].size() > groups[largest].size()) largest = g;
    }
    if (groups[largest].size() <= kWide && items.size() > kWide) break;  // these fill one node each
    if (groups[largest].size() == 1) break;
    const Items whole = groups[largest];
    const std::size_t middle = halve(centers, whole);
    groups[largest] = whole.subspan(0, middle);
    groups[count++] = whole.subspan(middle);
  }
  return count;
}

float rounded_down(double x) {
  const auto f = static_cast<float>(x);
  return static_cast<double>(f) <= x ? f : std::nextafter(f, -std::numeric_limits<float>::infinity());
}

float rounded_up(double x) {
  return -rounded_down(-x);
}

std::vector<dvec3> centers_of(std::span<const Aabb> boxes) {
  std::vector<dvec3> centers;
  centers.reserve(boxes.size());
  for (const Aabb& box : boxes) centers.push_back(box.center());
  return centers;
}

std::vector<Aabb> boxes_of_nodes(const WideTopology& topology, std::span<const Aabb> boxes) {
  std::vector<Aabb> of_node(topology.nodes.size());
  for (std::size_t n = topology.nodes.size(); n-- > 0;) {  // children come after their parent
    for (const std::int32_t child : topology.nodes[n]) {
      if (child == WideTopology::kNone) continue;
      of_node[n].include(child < 0 ? boxes[at(~child)] : of_node[at(child)]);
    }
  }
  return of_node;
}

}  // namespace

WideTopology::WideTopology(std::span<const dvec3> centers) : order(centers.size()) {
  std::iota(order.begin(), order.end(), 0);
  if (order.empty()) return;
  struct Task {
    std::size_t node;
    Items items;
  };
  std::vector<Task> tasks{{0, order}};
  nodes.emplace_back();
  for (std::size_t next = 0; next < tasks.size(); ++next) {
    const Task task = tasks[next];
    nodes[task.node].fill(kNone);
    std::array<Items, kWide> groups;
    const std::size_t count = split(centers, task.items, groups);
    for (std::size_t g = 0; g < count; ++g) {
      if (groups[g].size() == 1) {
        nodes[task.node][g] = ~groups[g][0];
        continue;
      }
      nodes[task.node][g] = static_cast<std::int32_t>(nodes.size());
      tasks.push_back({nodes.size(), groups[g]});
      nodes.emplace_back();
    }
  }
}

WideBvh::WideBvh(std::span<const Aabb> boxes) : WideBvh(boxes, WideTopology(centers_of(boxes))) {}

WideBvh::WideBvh(std::span<const Aabb> boxes, const WideTopology& topology) {
  if (boxes.empty()) return;
  Aabb all;
  for (const Aabb& box : boxes) all.include(box);
  origin_ = all.center();
  size_ = all.diagonal();
  const std::vector<Aabb> of_node = boxes_of_nodes(topology, boxes);
  nodes_.resize(topology.nodes.size());
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    nodes_[n].child = topology.nodes[n];
    for (std::size_t lane = 0; lane < kWide; ++lane) {
      const std::int32_t child = topology.nodes[n][lane];
      Aabb box;
      if (child != WideTopology::kNone) box = child < 0 ? boxes[at(~child)] : of_node[at(child)];
      for (int axis = 0; axis < 3; ++axis) {
        nodes_[n].lo[at(axis)][lane] = rounded_down(box.lo[axis] - origin_[axis]);
        nodes_[n].hi[at(axis)][lane] = rounded_up(box.hi[axis] - origin_[axis]);
      }
    }
  }
}

namespace {

using Facet = FacetTree::Facet;

double largest_coordinate(const dvec3& x) {
  return std::max({std::abs(x.x), std::abs(x.y), std::abs(x.z)});
}

/// Pairs the faces of a mesh.
class FacetsOfMesh {
 public:
  explicit FacetsOfMesh(const TriMesh& mesh)
      : mesh_(mesh), edges_(mesh.topology()), taken_(mesh.faces().size(), false) {}

  /// Returns the facets, ascending by their faces.
  std::vector<Facet> find() {
    std::vector<Facet> facets;
    for (int f = 0; f < mesh_.face_count(); ++f) {
      if (taken_[at(f)]) continue;
      Facet& facet = facets.emplace_back();
      facet.face = f;
      facet.normal = mesh_.face_normals()[at(f)];
      const int diagonal = diagonal_of(f);
      const int first = diagonal < 0 ? 3 * f : previous_edge(diagonal);  // corner 0 is opposite to the diagonal
      facet.vertex = {edges_.from(first), edges_.to(first), edges_.from(previous_edge(first)), -1};
      if (diagonal < 0) continue;
      facet.corners = 4;
      facet.vertex[3] = apex(edges_.twin(diagonal));
      taken_[at(edges_.face_across(diagonal))] = true;
    }
    return facets;
  }

 private:
  [[nodiscard]] const dvec3& position(int vertex) const { return mesh_.vertices()[at(vertex)]; }
  /// Returns the vertex of a half-edge's face that is not on it.
  [[nodiscard]] int apex(int half_edge) const { return edges_.to(next_edge(half_edge)); }
  [[nodiscard]] double squared_length(int half_edge) const {
    const dvec3 along = position(edges_.to(half_edge)) - position(edges_.from(half_edge));
    return glm::dot(along, along);
  }

  /// Returns the half-edge of a face beyond which another one completes a parallelogram, or -1.
  [[nodiscard]] int diagonal_of(int face) const {
    std::array<int, 3> half_edges{3 * face, 3 * face + 1, 3 * face + 2};
    std::stable_sort(half_edges.begin(), half_edges.end(),
                     [&](int a, int b) { return squared_length(a) > squared_length(b); });
    const auto found = std::find_if(half_edges.begin(), half_edges.end(), [&](int h) { return is_diagonal(h); });
    return found == half_edges.end() ? -1 : *found;
  }

  [[nodiscard]] bool is_diagonal(int half_edge) const {
    constexpr double kSameSide = 0.99;  // cosine: faces that fold back are no parallelogram
    const int across = edges_.face_across(half_edge);
    if (across < 0 || taken_[at(across)]) return false;
    const auto& normals = mesh_.face_normals();
    if (!(glm::dot(normals[at(half_edge / 3)], normals[at(across)]) > kSameSide)) return false;
    const dvec3 &x0 = position(apex(half_edge)), &x1 = position(edges_.from(half_edge)),
                &x2 = position(edges_.to(half_edge)), &x3 = position(apex(edges_.twin(half_edge)));
    const double largest =
        std::max({largest_coordinate(x0), largest_coordinate(x1), largest_coordinate(x2), largest_coordinate(x3)});
    return largest_coordinate(x1 + (x2 - x0) - x3) <= kSameCorner * largest;
  }

  const TriMesh& mesh_;
  const EdgeTopology& edges_;
  std::vector<bool> taken_;
};

}  // namespace

FacetTree::FacetTree(const TriMesh& mesh) {
  const std::vector<Facet> found = FacetsOfMesh(mesh).find();
  std::vector<Aabb> boxes(found.size());
  std::vector<dvec3> centers;
  for (std::size_t f = 0; f < found.size(); ++f) {
    const auto corner = [&](std::size_t c) { return mesh.vertices()[at(found[f].vertex[c])]; };
    for (std::size_t c = 0; c < 3; ++c) boxes[f].include(corner(c));
    if (found[f].corners == 4) boxes[f].include(corner(1) + corner(2) - corner(0));
    centers.push_back(boxes[f].center());
  }
  WideTopology topology(centers);
  std::vector<std::int32_t> number(mesh.vertices().size(), -1);
  std::vector<Aabb> ordered;
  std::vector<std::int32_t> place(found.size());
  for (const std::int32_t f : topology.order) {
    place[at(f)] = static_cast<std::int32_t>(facets_.size());
    ordered.push_back(boxes[at(f)]);
    Facet& facet = facets_.emplace_back(found[at(f)]);
    for (int c = 0; c < facet.corners; ++c) {
      std::int32_t& vertex = facet.vertex[at(c)];
      std::int32_t& v = number[at(vertex)];
      if (v < 0) {
        v = static_cast<std::int32_t>(vertices_.size());
        vertices_.push_back(mesh.vertices()[at(vertex)]);
      }
      vertex = v;
    }
  }
  for (auto& node : topology.nodes) {
    for (std::int32_t& child : node) {
      if (child < 0 && child != WideTopology::kNone) child = ~place[at(~child)];
    }
  }
  tree_ = WideBvh(ordered, topology);
}

}  // namespace taxel
