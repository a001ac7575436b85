// Disjoint sets that can be united (union-find).
#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

namespace taxel {

/// Disjoint sets of the numbers 0 to n - 1, each represented by its lowest member.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0); }

  /// Returns the lowest number of the set that contains i. Shortens paths, so it is not const.
  int find(int i) {
    while (parent(i) != i) {
      parent(i) = parent(parent(i));
      i = parent(i);
    }
    return i;
  }
  void unite(int a, int b) {
    const int root_a = find(a), root_b = find(b);
    parent(std::max(root_a, root_b)) = std::min(root_a, root_b);
  }

 private:
  int& parent(int i) { return parent_[static_cast<std::size_t>(i)]; }
  std::vector<int> parent_;
};

}  // namespace taxel
