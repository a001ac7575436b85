// Finds empty circles between points of the plane.
#pragma once

#include <vector>

#include "core/base/math.h"

namespace taxel {

using glm::vec2;

/// The centre of an empty circle between points.
struct Hole {
  vec2 center{0};
  float clearance = 0;  ///< squared distance of the nearest point
};

/// Finds places in the plane that are far from all given points. Single precision, for lengths about 1; uses the best
/// instruction set of the machine, with the same bits on each machine. Reuses its memory.
class HoleFinder {
 public:
  void clear() { size_ = 0; }
  void add(const vec2& p) {
    if (size_ + kLanes > x_.size()) grow();
    x_[size_] = p.x, y_[size_] = p.y;
    ++size_;
  }
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] vec2 point(std::size_t i) const { return {x_[i], y_[i]}; }
  /// Returns the squared distance of the nearest point.
  [[nodiscard]] float clearance(const vec2& at) const;

  /// Moves from `start` to a local maximum of the distance to the nearest point, at most about `reach` away. The
  /// distance never decreases, up to rounding. There must be at least one point.
  [[nodiscard]] Hole climb(const vec2& start, float reach) const;

 private:
  static constexpr std::size_t kLanes = 16;  // at most
  void grow();

  std::vector<float> x_, y_;  // longer than size_ by whole lanes
  std::size_t size_ = 0;
};

}  // namespace taxel
