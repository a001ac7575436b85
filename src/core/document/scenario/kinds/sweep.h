// The sweep: the finger crosses the edge of the object at right angles, as in Figure 3 of the paper.
#pragma once

#include "core/base/error.h"
#include "core/document/scenario/kinds/kind_traits.h"

namespace taxel {

/// Default of `before` and `past` on an `edge`, and on all other objects [m]. If the finger would touch an `edge` at
/// that distance, the sweep starts and ends farther away.
inline constexpr double kEdgeReach = 0.025, kBoxReach = 0.012;

namespace scenarios {

struct Sweep : KindTraits {
  static constexpr std::string_view kWord = "sweep";
  static constexpr ObjectShape kShape = ObjectShape::edge;

  double depth = 0.0015;         ///< depth below first contact with the object's top [m]
  double speed = 0.010;          ///< speed of the mocap body [m/s]
  double before = kEdgeReach;    ///< distance of the lowest point from the edge at the start [m]
  double past = kEdgeReach;      ///< distance of the lowest point from the edge at the end [m]
  double tilt_deg = 45.0;        ///< angle of `distal` below the horizontal
  double record_every = 0.0001;  ///< travel between two rows [m]

  template <class Self, class V>
  static void visit(Self& self, const V& v) {
    v(kDepth, self.depth);
    v(kSpeed, self.speed);
    v(FieldSpec{"before", "Before the edge",
                "Where the lowest point of the finger starts; farther away if it would touch an upright edge there",
                FieldQuantity::length, FieldRange::not_negative},
      self.before);
    v(FieldSpec{"past", "Past the edge",
                "Where the lowest point of the finger ends; farther away if it would touch an upright edge there",
                FieldQuantity::length, FieldRange::not_negative},
      self.past);
    v(kTilt, self.tilt_deg);
  }
  template <class Self, class V>
  static void visit_rows(Self& self, const V& v) {
    v(FieldSpec{"record_every", "Row every", "Of travel, in plots and recordings", FieldQuantity::length,
                FieldRange::positive},
      self.record_every);
  }

  void check(ObjectShape shape) const {
    if (shape != ObjectShape::edge && !(before + past > 0))
      throw Error("", "/past", "before and past together must be greater than 0");
  }
  /// Replaces `before` and `past` if they have the default values of the former shape.
  void follow_shape(ObjectShape from, ObjectShape to) {
    const auto reach = [](ObjectShape shape) { return shape == ObjectShape::edge ? kEdgeReach : kBoxReach; };
    for (double* distance : {&before, &past})
      if (*distance == reach(from)) *distance = reach(to);
  }
  bool operator==(const Sweep&) const = default;
};

}  // namespace scenarios
}  // namespace taxel
