#include "core/hydro/kernel/index/wide_tree.h"

#include <algorithm>
#include <numeric>

#include "core/base/index.h"

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

}  // namespace taxel
