// Traversal of NearestTree. Included by nearest_tree.h.
#pragma once

#include <limits>

#include "core/mesh/query/nearest_tree.h"

namespace taxel {

/// Finds the children that may be within the limit, nearest first.
inline int NearestTree::near_children(const Node& node, const std::array<float, 3>& q, float error, float limit,
                                      std::array<Waiting, kWidth>& found) const {
  Lanes sum{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Lanes below = node.lo[axis] - q[axis], above = q[axis] - node.hi[axis];
    const Lanes outside = (below > above ? below : above) - error;
    const Lanes least = outside > 0.0f ? outside : Lanes{};
    sum += least * least;
  }
  int size = 0;
  for (int i = 0; i < node.count; ++i) {
    const float d2 = sum[i];
    if (d2 > limit) continue;
    int to = size++;
    for (; to > 0 && found[static_cast<std::size_t>(to - 1)].squared_distance > d2; --to)
      found[static_cast<std::size_t>(to)] = found[static_cast<std::size_t>(to - 1)];
    found[static_cast<std::size_t>(to)] = {d2, node.child[static_cast<std::size_t>(i)]};
  }
  return size;
}

/// Returns a limit above scale^2 reach^2 by more than the rounding errors of near_children.
inline float NearestTree::squared_limit(double reach) const {
  constexpr double kRoundings = 16 * std::numeric_limits<float>::epsilon();
  const double local = scale_ * reach;
  return static_cast<float>((1 + kRoundings) * local * local);
}

template <class Test>
void NearestTree::visit(const dvec3& p, double reach, Test&& test) const {
  if (nodes_.empty()) return;
  const dvec3 local = scale_ * (p - origin_);
  const std::array<float, 3> q{static_cast<float>(local.x), static_cast<float>(local.y), static_cast<float>(local.z)};
  // Twice the largest rounding of p.
  const double size = std::max({std::abs(local.x), std::abs(local.y), std::abs(local.z)});
  const auto error = static_cast<float>(std::numeric_limits<float>::epsilon() * size);
  float limit = squared_limit(reach);
  std::array<Waiting, (kWidth - 1) * Bvh::kMaxDepth + 1> stack;  // NOLINT: filled as it is used
  std::array<Waiting, kWidth> found;                             // NOLINT
  std::size_t waiting = 0;
  stack[waiting++] = {0.0f, 0};
  while (waiting > 0) {
    const Waiting next = stack[--waiting];
    if (next.squared_distance > limit) continue;
    const int size_found = near_children(nodes_[static_cast<std::size_t>(next.child)], q, error, limit, found);
    for (int i = 0; i < size_found; ++i) {
      const Waiting& leaf = found[static_cast<std::size_t>(i)];
      if (leaf.child < 0 && !(leaf.squared_distance > limit)) limit = squared_limit(test(~leaf.child));
    }
    for (int i = size_found - 1; i >= 0; --i) {
      const Waiting& inner = found[static_cast<std::size_t>(i)];
      if (inner.child >= 0 && !(inner.squared_distance > limit)) stack[waiting++] = inner;
    }
  }
}

}  // namespace taxel
