// Where the vertices of a cut polygon come from, when it lies in the lanes of a vector.
#pragma once

#include <cstdint>

namespace taxel {

/// Which lanes to take: element i is the number of a lane, plus kOther for one of a second vector.
struct alignas(64) LaneNumbers {
  static constexpr std::int64_t kOther = 8;
  std::int64_t lane[8];
};

/// Where the vertices of a cut polygon come from: lanes of the old ones, and of the points where the plane crosses the
/// edges that begin there.
class CutLanes {
 public:
  static constexpr unsigned kMost = 8;

  constexpr CutLanes() : next_{}, backward_{}, kept_{} {
    for (unsigned n = 3; n <= kMost; ++n) {
      for (unsigned i = 0; i < kMost; ++i) {
        next_[n].lane[i] = i + 1 < n ? i + 1 : 0;
        backward_[n].lane[i] = i < n ? n - 1 - i : 0;
      }
      for (unsigned before = 0; before < n; ++before) {
        for (unsigned run = 1; run < n; ++run) set(n, before, run);
      }
    }
  }
  /// The vertex after each of n.
  [[nodiscard]] constexpr const LaneNumbers& next(unsigned n) const { return next_[n]; }
  /// All n vertices, the last one first.
  [[nodiscard]] constexpr const LaneNumbers& backward(unsigned n) const { return backward_[n]; }
  /// Of n vertices the `run` after number `before` are inside.
  [[nodiscard]] constexpr const LaneNumbers& kept(unsigned n, unsigned before, unsigned run) const {
    return kept_[(n * 8 + before) * 8 + run];
  }

 private:
  constexpr void set(unsigned n, unsigned before, unsigned run) {
    LaneNumbers& kept = kept_[(n * 8 + before) * 8 + run];
    for (unsigned i = 0; i < kMost; ++i) kept.lane[i] = i <= run ? (before + i) % n : 0;
    kept.lane[0] += LaneNumbers::kOther;
    if (run + 1 < kMost) kept.lane[run + 1] = LaneNumbers::kOther + (before + run) % n;
  }

  LaneNumbers next_[kMost + 1], backward_[kMost + 1];
  LaneNumbers kept_[(kMost + 1) * 8 * 8];
};
inline constexpr CutLanes kCutLanes;

}  // namespace taxel
