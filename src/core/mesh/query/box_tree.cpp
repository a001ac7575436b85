// Folds a binary tree into one with four children per node and single-precision boxes.
//
// A node takes the two children of a binary node and opens the largest of them while there is room, so that the parts
// with the largest chance to be visited are found without a further node. Leaves are single primitives. Queries test
// the four boxes of a node together, and a node fills two cache lines.
//
// Pitfall: boxes are relative to the middle of the tree, scaled to about 1 and rounded outward by more than the
// rounding of both, so that a query skips only primitives that are too far. The scale is a power of two and adds no
// rounding.
#include "core/mesh/query/box_tree.h"

#include <bit>
#include <cmath>

#include "core/base/math.h"

namespace taxel {
namespace {

/// Returns a float below x by more than the last roundings of x: the next lower one of its nearest float.
float float_below(double x) {
  const auto nearest = static_cast<float>(x);
  if (nearest == 0) return -std::numeric_limits<float>::denorm_min();
  if (nearest == -std::numeric_limits<float>::infinity()) return nearest;
  const auto bits = std::bit_cast<std::int32_t>(nearest);
  return std::bit_cast<float>(nearest > 0 ? bits - 1 : bits + 1);
}

float float_above(double x) {
  return -float_below(-x);
}

}  // namespace

BoxTree::BoxTree(std::span<const Aabb> boxes, Bvh::Effort effort) {
  if (boxes.empty()) return;
  Bvh tree;
  tree.build(boxes, kWidth, effort);
  const Aabb& all = tree.nodes()[0].box;
  origin_ = all.center();
  const dvec3 extent = all.extent();
  const double size = std::max({extent.x, extent.y, extent.z});
  if (size > std::numeric_limits<double>::min()) scale_ = std::ldexp(1.0, -std::ilogb(size));
  nodes_.reserve(tree.items().size());  // enough for any tree; the pages of an unused rest take no memory
  add(tree, boxes, 0);
}

BoxTree::LocalBox BoxTree::local_box(const Aabb& box) const {
  LocalBox local{};
  for (int axis = 0; axis < 3; ++axis) {
    local.lo[at(axis)] = float_below(scale_ * (box.lo[axis] - origin_[axis]));
    local.hi[at(axis)] = float_above(scale_ * (box.hi[axis] - origin_[axis]));
  }
  return local;
}

BoxTree::Leaves BoxTree::leaves_of(int node) const {
  Leaves leaves{};
  const Node& all = nodes_[at(node)];
  for (int i = 0; i < all.count; ++i)
    if (all.child[at(i)] < 0) leaves.primitives[at(leaves.count++)] = ~all.child[at(i)];
  return leaves;
}

/// Returns the primitives of a leaf, or the two children of an inner node.
BoxTree::Entries BoxTree::below(const Bvh& tree, std::span<const Aabb> boxes, std::int32_t binary) {
  const Bvh::Node& node = tree.nodes()[at(binary)];
  Entries entries;
  if (node.leaf()) {
    for (std::int32_t i = node.first; i < node.first + node.count; ++i) {
      const std::int32_t primitive = tree.items()[at(i)];
      entries.add({boxes[at(primitive)], ~primitive, 1});
    }
    return entries;
  }
  for (const std::int32_t child : {node.first, node.first + 1}) {
    const Bvh::Node& part = tree.nodes()[at(child)];
    if (part.count == 1) {  // a node of its own would hold nothing else
      entries.add({part.box, ~tree.items()[at(part.first)], 1});
    } else {
      entries.add({part.box, child, std::max(2, part.count)});
    }
  }
  return entries;
}

/// Makes one node of a binary node and its descendants: the largest parts are opened while there is room. A leaf
/// becomes a node of its primitives. The tree is never deeper than the binary one.
std::int32_t BoxTree::add(const Bvh& tree, std::span<const Aabb> boxes, std::int32_t binary) {
  Entries entries = below(tree, boxes, binary);
  while (true) {
    int largest = -1;
    for (int i = 0; i < entries.count; ++i) {
      const Entry& entry = entries.list[at(i)];
      if (entry.child < 0 || entries.count + entry.parts - 1 > kWidth) continue;
      if (largest < 0 || entry.box.surface_area() > entries.list[at(largest)].box.surface_area()) largest = i;
    }
    if (largest < 0) break;
    const Entries parts = below(tree, boxes, entries.list[at(largest)].child);
    entries.list[at(largest)] = parts.list[0];
    for (int i = 1; i < parts.count; ++i) entries.add(parts.list[at(i)]);
  }
  const auto number = static_cast<std::int32_t>(nodes_.size());
  nodes_.push_back({});
  nodes_.back().count = entries.count;
  for (int lane = 0; lane < entries.count; ++lane) {
    const Entry& entry = entries.list[at(lane)];
    const std::int32_t child = entry.child < 0 ? entry.child : add(tree, boxes, entry.child);
    Node& node = nodes_[at(number)];
    const LocalBox box = local_box(entry.box);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      node.lo[axis][lane] = box.lo[axis];
      node.hi[axis][lane] = box.hi[axis];
    }
    node.child[at(lane)] = child;
  }
  return number;
}

}  // namespace taxel
