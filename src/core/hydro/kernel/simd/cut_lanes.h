// Permutations that move the vertices of a clipped polygon between the lanes of a vector.
#pragma once

#include <cstdint>

namespace taxel {

/// Which lanes to take: element i is the number of a lane, plus kOther for one of a second vector.
struct alignas(64) LaneNumbers {
  static constexpr std::int64_t kOther = 8;
  std::int64_t lane[8];
};

/// The same as AVX2 takes them: eight 32-bit halves of four lanes at a time. The low bits of an element are the number
/// of a half in its register; of a lane's upper half, the sign says that the lane is one of the upper four, and the bit
/// below it that it is one of the second vector.
struct alignas(64) LaneHalves {
  std::uint32_t half[2][8];
};

/// Sets element i to lane `from` of the first vector or, with kOther, of the second one.
constexpr void set_lane(LaneNumbers& numbers, unsigned i, std::int64_t from) {
  numbers.lane[i] = from;
}
constexpr void set_lane(LaneHalves& halves, unsigned i, std::int64_t from) {
  constexpr std::uint32_t kUpper = 1u << 31, kSecond = 1u << 30;
  const auto lane = static_cast<std::uint32_t>(from & 3);
  const std::uint32_t flags = ((from & 4) != 0 ? kUpper : 0) | ((from & LaneNumbers::kOther) != 0 ? kSecond : 0);
  halves.half[i / 4][2 * (i % 4)] = 2 * lane;
  halves.half[i / 4][2 * (i % 4) + 1] = (2 * lane + 1) | flags;
}

/// Where the vertices of a cut polygon come from: lanes of the old ones, and of the points where the plane crosses the
/// edges that begin there.
template <class Lanes>
class CutLanes {
 public:
  static constexpr unsigned kMax = 8;

  constexpr CutLanes() : next_{}, backward_{}, kept_{} {
    for (unsigned n = 3; n <= kMax; ++n) {
      for (unsigned i = 0; i < kMax; ++i) {
        set_lane(next_[n], i, i + 1 < n ? i + 1 : 0);
        set_lane(backward_[n], i, i < n ? n - 1 - i : 0);
      }
      for (unsigned before = 0; before < n; ++before) {
        for (unsigned run = 1; run < n; ++run) set(n, before, run);
      }
    }
  }
  /// The vertex after each of n.
  [[nodiscard]] constexpr const Lanes& next(unsigned n) const { return next_[n]; }
  /// All n vertices, the last one first.
  [[nodiscard]] constexpr const Lanes& backward(unsigned n) const { return backward_[n]; }
  /// Of n vertices the `run` after number `before` are inside.
  [[nodiscard]] constexpr const Lanes& kept(unsigned n, unsigned before, unsigned run) const {
    return kept_[(n * 8 + before) * 8 + run];
  }

 private:
  constexpr void set(unsigned n, unsigned before, unsigned run) {
    Lanes& kept = kept_[(n * 8 + before) * 8 + run];
    for (unsigned i = 0; i < kMax; ++i) set_lane(kept, i, i <= run ? (before + i) % n : 0);
    set_lane(kept, 0, LaneNumbers::kOther + before);
    if (run + 1 < kMax) set_lane(kept, run + 1, LaneNumbers::kOther + (before + run) % n);
  }

  Lanes next_[kMax + 1], backward_[kMax + 1];
  Lanes kept_[(kMax + 1) * 8 * 8];
};
template <class Lanes>
inline constexpr CutLanes<Lanes> kCutLanesAs;

}  // namespace taxel
