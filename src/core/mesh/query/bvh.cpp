// A binary tree of boxes by the surface area heuristic (SAH), with bins (Wald 2007).
//
// A node is split where visiting its parts is expected to cost least: the chance that a query meets a part is taken as
// its surface, its cost as the number of its boxes. Centers are sorted into at most 16 bins along each axis, and only
// the planes between bins are tried. A node of few boxes has few bins, since trees over contact surfaces are rebuilt in
// each step.
//
// Cost: O(n log n). Pitfalls. Empty or infinite boxes have centers that are no numbers: comparisons are written so that
// these fail, every box still gets a bin, and no primitive is lost. Boxes with one center cannot be separated, and the
// list is halved. Below a depth of 56 nodes are halved by count too, which bounds the depth, so that queries have a
// stack of fixed size. Large nodes choose their split by a part of their boxes. The result does not depend on threads
// or machines.
#include "core/mesh/query/bvh.h"

#include <numeric>

#include "core/base/math.h"

namespace taxel {
namespace {

constexpr int kFewBins = 4, kSomeBins = 8, kMaxBins = 16;
/// Cost of visiting a node, in units of testing one primitive.
constexpr double kVisitCost = 1.0;
/// The split of a larger node is chosen by this many of its boxes, evenly taken from its list. A search through all of
/// them takes 0.2 s more for 2 million triangles, and rays test as many triangles with either tree (to 0.1 %).
constexpr int kMostTried = 8192;
/// Axes shorter than this fraction of the longest one are not tried.
constexpr double kThinAxis = 0.25;
/// Below this depth nodes are halved by count, which bounds the depth at kSahDepth + 31 < Bvh::kMaxDepth - 1.
constexpr int kSahDepth = 56;

/// Returns twice the centre of a box along one axis. NaN (an empty or infinite box) and infinities cannot be sorted.
double key_of(const Aabb& box, int axis) {
  return box.lo[axis] + box.hi[axis];
}

/// The two clamps have no branch, which would often be predicted wrongly. NaN gives bin 0.
int bin_of(double key, double lo, double scale, int bins) {
  const double bin = (key - lo) * scale, from_zero = bin > 0 ? bin : 0.0;
  const double last = bins - 1;
  return static_cast<int>(from_zero < last ? from_zero : last);
}

/// Returns the distance in the list between boxes that choose a node's split.
int stride_of(int count) {
  return (count + kMostTried - 1) / kMostTried;
}

/// A node of few boxes needs no more bins than boxes: trees over contact surfaces are rebuilt in each step.
int bins_for(int count) {
  return std::clamp(count, kFewBins, kMaxBins);
}

/// Includes twice the centre of a box. NaN fails every comparison.
void include_key(Aabb& keys, const Aabb& box) {
  for (int axis = 0; axis < 3; ++axis) {
    const double key = key_of(box, axis);
    keys.lo[axis] = key < keys.lo[axis] ? key : keys.lo[axis];
    keys.hi[axis] = key > keys.hi[axis] ? key : keys.hi[axis];
  }
}

/// Includes only finite keys.
void include_finite_key(Aabb& keys, const Aabb& box) {
  for (int axis = 0; axis < 3; ++axis) {
    const double key = key_of(box, axis);
    if (!std::isfinite(key)) continue;
    keys.lo[axis] = std::min(keys.lo[axis], key);
    keys.hi[axis] = std::max(keys.hi[axis], key);
  }
}

/// Returns true if the keys differ along an axis. A direction much shorter than the longest one rarely has the better
/// split.
bool is_tried(const Aabb& keys, int axis, int bins, double thin = kThinAxis) {
  const dvec3 extent = keys.extent();
  const double longest = std::max({extent.x, extent.y, extent.z}), scale = bins / extent[axis];
  return extent[axis] >= thin * longest && extent[axis] > 0 && std::isfinite(scale) && scale > 0;
}

}  // namespace

/// A split: bins below `bin` of the axis go left. Axis -1 if no plane separates the boxes and the list is halved.
struct Bvh::Split {
  int axis = -1, bin = 0, bins = 0;
  double lo = 0, scale = 0;
  double cost = std::numeric_limits<double>::infinity();
};

/// The two parts of a node's list: the number of boxes that go left, the union of each part, and its keys.
struct Bvh::Parts {
  std::int32_t left = 0;
  Aabb box[2], keys[2];
};

/// The boxes of a node in bins along one axis. kMost is the size of the arrays, whose setup costs small nodes more than
/// the sums.
template <int kMost>
struct Bvh::Bins {
  int axis = -1;
  double lo = 0, scale = 0;
  std::array<Aabb, kMost> box;
  std::array<int, kMost> count{};

  void include(const Aabb& b, int bins) {
    const std::size_t bin = at(bin_of(key_of(b, axis), lo, scale, bins));
    box[bin].include(b);
    ++count[bin];
  }
  /// Improves the split by the planes between the bins of `tried` boxes. Binned SAH (Wald 2007):
  /// cost = visit + (area_left * count_left + area_right * count_right) / area. Next to an empty bin a plane separates
  /// the same boxes as the plane before it.
  void find_split(int bins, int tried, double area, Split& best) const {
    std::array<double, kMost> right_cost{};  // cost of bins >= i
    Aabb right, left;
    int right_count = 0, left_count = 0;
    for (int i = bins - 1; i > 0; --i) {
      if (count[at(i)] > 0) {
        right.include(box[at(i)]);
        right_count += count[at(i)];
        right_cost[at(i)] = right.surface_area() * right_count;
      } else if (i + 1 < bins) {
        right_cost[at(i)] = right_cost[at(i + 1)];
      }
    }
    for (int i = 1; i < bins && left_count + count[at(i - 1)] < tried; ++i) {
      if (count[at(i - 1)] == 0) continue;
      left.include(box[at(i - 1)]);
      left_count += count[at(i - 1)];
      const double cost = kVisitCost + (left.surface_area() * left_count + right_cost[at(i)]) / area;
      if (cost < best.cost) best = {axis, i, bins, lo, scale, cost};
    }
  }
};

template <int kMost>
void Bvh::try_axes(std::span<const Aabb> boxes, const Node& node, const Aabb& keys, Effort effort, Split& best) const {
  const int bins = bins_for(node.count);
  std::array<Bins<kMost>, 3> all;
  std::size_t axis_count = 0;
  for (int axis = 0; axis < 3; ++axis) {
    if (!is_tried(keys, axis, bins, effort == Effort::many_queries ? kThinAxis : 1.0)) continue;
    all[axis_count].axis = axis;
    all[axis_count].lo = keys.lo[axis];
    all[axis_count++].scale = bins / keys.extent()[axis];
  }
  const int stride = stride_of(node.count);
  for (int i = 0; i < node.count; i += stride) {
    const Aabb& box = boxes[at(items_[at(node.first + i)])];
    for (std::size_t a = 0; a < axis_count; ++a) all[a].include(box, bins);
  }
  const int tried = (node.count + stride - 1) / stride;
  const double area = node.box.surface_area();
  for (std::size_t a = 0; a < axis_count; ++a) all[a].find_split(bins, tried, area, best);
}

/// Two boxes are separated along every axis, at equal cost: the first axis decides.
void Bvh::split_pair(const Aabb& first, const Aabb& second, const Node& node, const Aabb& keys, Split& best) {
  const double cost = kVisitCost + (first.surface_area() + second.surface_area()) / node.box.surface_area();
  for (int axis = 0; axis < 3 && best.axis < 0; ++axis) {
    if (!is_tried(keys, axis, kFewBins) || !(cost < best.cost)) continue;
    best = {axis, 1, kFewBins, keys.lo[axis], kFewBins / keys.extent()[axis], cost};
  }
}

Bvh::Split Bvh::best_split(std::span<const Aabb> boxes, const Node& node, Aabb keys, Effort effort) const {
  const int stride = stride_of(node.count);
  if (stride > 1) {
    keys = {};
    for (int i = 0; i < node.count; i += stride) include_key(keys, boxes[at(items_[at(node.first + i)])]);
  }
  if (!is_finite(keys.lo) || !is_finite(keys.hi)) {  // infinities are searched only if the bounds are infinite
    keys = {};
    for (int i = 0; i < node.count; i += stride) include_finite_key(keys, boxes[at(items_[at(node.first + i)])]);
  }
  Split best;
  if (node.count == 2) {
    split_pair(boxes[at(items_[at(node.first)])], boxes[at(items_[at(node.first + 1)])], node, keys, best);
  } else if (node.count <= kFewBins) {
    try_axes<kFewBins>(boxes, node, keys, effort, best);
  } else if (node.count <= kSomeBins) {
    try_axes<kSomeBins>(boxes, node, keys, effort, best);
  } else {
    try_axes<kMaxBins>(boxes, node, keys, effort, best);
  }
  return best;
}

Bvh::Parts Bvh::partition(std::span<const Aabb> boxes, const Node& node, const Split& split) {
  Parts parts;
  const auto include = [&](int part, const Aabb& box) {
    parts.box[part].include(box);
    include_key(parts.keys[part], box);
  };
  std::int32_t left = node.first, right = node.first + node.count - 1;
  if (split.axis < 0) {
    parts.left = node.count / 2;
    for (std::int32_t i = 0; i < node.count; ++i)
      include(i < parts.left ? 0 : 1, boxes[at(items_[at(node.first + i)])]);
    return parts;
  }
  while (left <= right) {
    const Aabb& box = boxes[at(items_[at(left)])];
    if (bin_of(key_of(box, split.axis), split.lo, split.scale, split.bins) < split.bin) {
      include(0, box);
      ++left;
    } else {
      include(1, box);
      std::swap(items_[at(left)], items_[at(right)]);
      --right;
    }
  }
  parts.left = left - node.first;
  return parts;
}

void Bvh::build(std::span<const Aabb> boxes, int max_leaf, Effort effort) {
  const int count = static_cast<int>(boxes.size());
  nodes_.clear();
  items_.resize(boxes.size());
  std::iota(items_.begin(), items_.end(), 0);
  if (count == 0) return;
  nodes_.reserve(2 * boxes.size());
  Pending root{0, 0, {}};
  nodes_.push_back({Aabb{}, 0, count});
  for (const Aabb& box : boxes) {
    nodes_[0].box.include(box);
    include_key(root.keys, box);
  }
  // Pending nodes with their depths, the deepest last: one sibling per level.
  std::array<Pending, kMaxDepth> stack;  // NOLINT: filled as it is used
  int size = 0;
  stack[at(size++)] = root;
  while (size > 0) {
    const Pending next = stack[at(--size)];
    const Node node = nodes_[at(next.node)];
    if (node.count == 1 || (effort == Effort::few_queries && node.count <= max_leaf)) continue;
    const Split split = next.depth < kSahDepth ? best_split(boxes, node, next.keys, effort) : Split{};
    if (node.count <= max_leaf && !(split.cost < node.count)) continue;
    const Parts parts = partition(boxes, node, split);
    const auto child = static_cast<std::int32_t>(nodes_.size());
    nodes_.push_back({parts.box[0], node.first, parts.left});
    nodes_.push_back({parts.box[1], node.first + parts.left, node.count - parts.left});
    nodes_[at(next.node)].first = child;
    nodes_[at(next.node)].count = 0;
    stack[at(size++)] = {child + 1, next.depth + 1, parts.keys[1]};
    stack[at(size++)] = {child, next.depth + 1, parts.keys[0]};
  }
}

}  // namespace taxel
