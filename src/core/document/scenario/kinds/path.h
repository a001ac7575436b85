// The path: the finger moves through waypoints.
#pragma once

#include <vector>

#include "core/base/math.h"
#include "core/document/scenario/kinds/kind_traits.h"

namespace taxel {

/// A pose of the mocap body at a time. M is the frame of the finger's mesh file, W is the world.
struct WayPoint {
  double time = 0;  ///< [s]
  Pose X_WM;
  bool operator==(const WayPoint& other) const {
    return time == other.time && X_WM.p == other.X_WM.p && X_WM.q == other.X_WM.q;
  }
};

namespace scenarios {

struct Path : Timed {
  static constexpr std::string_view kWord = "path";
  static constexpr bool kHasPoses = true;
  std::vector<WayPoint> points = {};  ///< waypoints at ascending times

  template <class Self, class V>
  static void visit(Self& self, const V& v) {
    v(FieldSpec{"points", "Way points", "Poses of the finger at ascending times", FieldQuantity::list}, self.points);
  }
  /// Throws Error if there are fewer than 2 waypoints, their times do not ascend, or a pose is not valid.
  void check(ObjectShape shape) const;
  bool operator==(const Path&) const = default;
};

}  // namespace scenarios
}  // namespace taxel
