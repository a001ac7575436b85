// Empty circles between points of the plane.
#pragma once

#include <array>
#include <vector>

#include "core/base/math.h"

namespace taxel {

/// The centre of an empty circle between points.
struct Hole {
  dvec2 center{0};
  double clearance = 0;  ///< squared distance of the nearest point
};

/// Points of the plane, and climbs among them to the places farthest from all. Keeps its memory.
class HoleFinder {
 public:
  void clear() { x_.clear(), y_.clear(); }
  void add(const dvec2& p) { x_.push_back(p.x), y_.push_back(p.y); }
  [[nodiscard]] std::size_t size() const { return x_.size(); }
  /// Squared distance of the nearest point.
  [[nodiscard]] double clearance(const dvec2& at) const;

  /// Climbs from `start` to a local maximum of the distance to the nearest point, and stops at most about `reach` away.
  /// Never ends nearer to a point than it began. There is at least one point.
  Hole climb(const dvec2& start, double reach);

 private:
  /// One straight stretch, until one more point is as near. False at the top or where `reach` is used up.
  bool advance(double reach);
  bool uphill(dvec2& up);
  bool along_bisector(std::size_t p, std::size_t q, dvec2& up) const;
  [[nodiscard]] dvec2 point(std::size_t i) const { return {x_[i], y_[i]}; }

  std::vector<double> x_, y_;
  std::vector<double> value_;            // of each point, for one pass over all
  dvec2 at_{0};                          // where the climb is
  std::array<std::size_t, 4> active_{};  // the points that are all equally near to it, at most three
  std::size_t count_ = 0;
};

}  // namespace taxel
