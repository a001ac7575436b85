#include "core/mesh/query/bvh.h"

#include <numeric>

#include "core/base/index.h"

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

int bin_of(double key, double lo, double scale, int bins) {
  const double bin = (key - lo) * scale;
  if (!(bin > 0)) return 0;  // also for NaN
  return bin < bins - 1 ? static_cast<int>(bin) : bins - 1;
}

/// Returns the distance in the list between boxes that choose a node's split.
int stride_of(int count) {
  return (count + kMostTried - 1) / kMostTried;
}

/// A node of few boxes needs no more bins than boxes: trees over contact surfaces are rebuilt in each step.
int bins_for(int count) {
  return std::clamp(count, kFewBins, kMaxBins);
}

}  // namespace

/// A split: bins below `bin` of the axis go left. Axis -1 if no plane separates the boxes and the list is halved.
struct Bvh::Split {
  int axis = -1, bin = 0, bins = 0;
  double lo = 0, scale = 0;
  double cost = std::numeric_limits<double>::infinity();
};

// Binned SAH (Wald 2007): cost = visit + (area_left * count_left + area_right * count_right) / area. kMostBins is
// the size of the arrays, whose setup costs small nodes more than the sums.
template <int kMostBins>
void Bvh::try_axis(std::span<const Aabb> boxes, const Node& node, int axis, const dvec3& lo, const dvec3& hi,
                   Split& best) const {
  const int bins = bins_for(node.count);
  const double scale = bins / (hi[axis] - lo[axis]);
  if (!(hi[axis] > lo[axis]) || !std::isfinite(scale) || !(scale > 0)) return;
  std::array<Aabb, kMostBins> box;
  std::array<int, kMostBins> count{};
  const int stride = stride_of(node.count);
  const int tried = (node.count + stride - 1) / stride;
  for (int i = 0; i < node.count; i += stride) {
    const Aabb& b = boxes[at(items_[at(node.first + i)])];
    const std::size_t bin = at(bin_of(key_of(b, axis), lo[axis], scale, bins));
    box[bin].include(b);
    ++count[bin];
  }
  std::array<double, kMostBins> right_cost{};  // cost of bins >= i
  Aabb right;
  int right_count = 0;
  for (int i = bins - 1; i > 0; --i) {
    right.include(box[at(i)]);
    right_count += count[at(i)];
    right_cost[at(i)] = right.surface_area() * right_count;
  }
  Aabb left;
  int left_count = 0;
  for (int i = 1; i < bins; ++i) {
    left.include(box[at(i - 1)]);
    left_count += count[at(i - 1)];
    if (left_count == 0 || left_count == tried) continue;
    const double cost = kVisitCost + (left.surface_area() * left_count + right_cost[at(i)]) / node.box.surface_area();
    if (cost < best.cost) best = {axis, i, bins, lo[axis], scale, cost};
  }
}

Bvh::Split Bvh::best_split(std::span<const Aabb> boxes, const Node& node) const {
  // Bounds of twice the finite centres. NaN fails every comparison; infinities are searched only if the bounds are
  // infinite.
  Aabb keys;
  const auto gather = [&](const auto& wanted) {
    keys = {};
    for (int i = 0; i < node.count; i += stride_of(node.count)) {
      const Aabb& box = boxes[at(items_[at(node.first + i)])];
      for (int axis = 0; axis < 3; ++axis) {
        const double key = key_of(box, axis);
        if (!wanted(key)) continue;
        keys.lo[axis] = key < keys.lo[axis] ? key : keys.lo[axis];
        keys.hi[axis] = key > keys.hi[axis] ? key : keys.hi[axis];
      }
    }
  };
  gather([](double) { return true; });
  if (!is_finite(keys.lo) || !is_finite(keys.hi)) gather([](double key) { return std::isfinite(key); });
  Split best;
  const dvec3 extent = keys.extent();
  for (int axis = 0; axis < 3; ++axis) {
    // A direction much shorter than the longest one rarely has the better split.
    const double longest = std::max({extent.x, extent.y, extent.z});
    if (extent[axis] < kThinAxis * longest) continue;
    if (node.count <= kFewBins) {
      try_axis<kFewBins>(boxes, node, axis, keys.lo, keys.hi, best);
    } else if (node.count <= kSomeBins) {
      try_axis<kSomeBins>(boxes, node, axis, keys.lo, keys.hi, best);
    } else {
      try_axis<kMaxBins>(boxes, node, axis, keys.lo, keys.hi, best);
    }
    if (node.count == 2 && best.axis >= 0) break;  // two boxes are separated along every axis at equal cost
  }
  return best;
}

std::int32_t Bvh::partition(std::span<const Aabb> boxes, const Node& node, const Split& split) {
  if (split.axis < 0) return node.count / 2;
  std::int32_t left = node.first, right = node.first + node.count - 1;
  while (left <= right) {
    const Aabb& box = boxes[at(items_[at(left)])];
    if (bin_of(key_of(box, split.axis), split.lo, split.scale, split.bins) < split.bin) {
      ++left;
    } else {
      std::swap(items_[at(left)], items_[at(right)]);
      --right;
    }
  }
  return left - node.first;
}

void Bvh::build(std::span<const Aabb> boxes, int max_leaf) {
  const int count = static_cast<int>(boxes.size());
  nodes_.clear();
  items_.resize(boxes.size());
  std::iota(items_.begin(), items_.end(), 0);
  if (count == 0) return;
  nodes_.reserve(2 * boxes.size());
  nodes_.push_back({Aabb{}, 0, count});
  // Pending nodes with their depths, the deepest last: one sibling per level.
  std::array<std::pair<std::int32_t, int>, kMaxDepth> stack{};
  int size = 0;
  stack[at(size++)] = {0, 0};
  while (size > 0) {
    const auto [index, depth] = stack[at(--size)];
    Node node = nodes_[at(index)];
    for (int i = 0; i < node.count; ++i) node.box.include(boxes[at(items_[at(node.first + i)])]);
    nodes_[at(index)].box = node.box;
    if (node.count == 1) continue;
    const Split split = depth < kSahDepth ? best_split(boxes, node) : Split{};
    if (node.count <= max_leaf && !(split.cost < node.count)) continue;
    const std::int32_t left = partition(boxes, node, split);
    const auto child = static_cast<std::int32_t>(nodes_.size());
    nodes_.push_back({Aabb{}, node.first, left});
    nodes_.push_back({Aabb{}, node.first + left, node.count - left});
    nodes_[at(index)].first = child;
    nodes_[at(index)].count = 0;
    stack[at(size++)] = {child + 1, depth + 1};
    stack[at(size++)] = {child, depth + 1};
  }
}

}  // namespace taxel
