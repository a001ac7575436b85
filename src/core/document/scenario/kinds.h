// The kinds of scenario as plain values, one struct each, and the fields that several of them share.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/base/math.h"
#include "core/base/text/field_spec.h"
#include "core/base/text/words.h"

namespace taxel {

/// Object that the finger touches. The edge that a sweep crosses is the line x = 0 on top of the object. The bounds of
/// the object begin at z = 0, and their middle is at y = 0. The bounds of a mesh and of all shapes except `edge` begin
/// at x = 0.
enum class ObjectShape {
  edge,   ///< a box of `box_size` balanced on an edge; the rounded edge is on top
  box,    ///< a cube with edges of length `box_size`
  plate,  ///< a square plate with sides of length `box_size`, a tenth as thick
  sphere  ///< a sphere of diameter `box_size`
};
inline constexpr Word<ObjectShape> kObjectShapeWords[] = {{ObjectShape::edge, "edge"},
                                                          {ObjectShape::box, "box"},
                                                          {ObjectShape::plate, "plate"},
                                                          {ObjectShape::sphere, "sphere"}};
inline std::span<const Word<ObjectShape>> words_of(ObjectShape) {
  return kObjectShapeWords;
}

/// Default of `before` and `past` on an `edge`, and on all other objects [m]. If the finger would touch an `edge` at
/// that distance, the sweep starts and ends farther away.
inline constexpr double kEdgeReach = 0.025, kBoxReach = 0.012;

/// A pose of the mocap body at a time. M is the frame of the finger's mesh file, W is the world.
struct WayPoint {
  double time = 0;  ///< [s]
  Pose X_WM;
  bool operator==(const WayPoint& other) const {
    return time == other.time && X_WM.p == other.X_WM.p && X_WM.q == other.X_WM.q;
  }
};

namespace scenarios {

/// Properties of a scenario kind. Every kind derives from these defaults and redefines the ones that differ. A kind
/// also has `kWord`, its name in files, and `visit(self, v)`, which calls v(FieldSpec, value&) for each field in the
/// order of the inspector; visit_rows() does the same for the field that decides when a row is recorded.
struct KindTraits {
  static constexpr bool kHasObject = true;                 ///< true if the user chooses the object
  static constexpr bool kHasTimestep = true;               ///< false if a recording sets the time step
  static constexpr bool kHasPoses = false;                 ///< true for poses that fit one object only
  static constexpr ObjectShape kShape = ObjectShape::box;  ///< shape of the default object

  /// Throws Error("", "/key", ...) if the values of the kind contradict each other.
  void check(ObjectShape) const {}
  /// Adapts defaults that depend on the shape of the object.
  void follow_shape(ObjectShape /*from*/, ObjectShape /*to*/) {}
  bool operator==(const KindTraits&) const = default;
};

inline constexpr FieldSpec kDepth{"depth", "Depth", "Indentation depth below first contact with the object's top",
                                  FieldQuantity::length, FieldRange::positive};
inline constexpr FieldSpec kSpeed{"speed", "Path speed", "Along straight ways", FieldQuantity::speed,
                                  FieldRange::positive};
inline constexpr FieldSpec kTilt{"tilt_deg", "Tilt", "Of the finger's distal axis below the horizontal",
                                 FieldQuantity::angle};
inline constexpr FieldSpec kPlace{"place", "Place", "Lowest point of the finger, from the object's middle along x",
                                  FieldQuantity::length};
inline constexpr FieldSpec kAngle{"angle_deg", "Angle", "Through which it turns, and back; it rolls towards +x",
                                  FieldQuantity::angle};
inline constexpr FieldSpec kRate{"rate_deg", "Rate", "At which it turns", FieldQuantity::angular_speed,
                                 FieldRange::positive};

/// A kind that records a row at even times.
struct Timed : KindTraits {
  double record_interval = 0.010;  ///< time between two rows [s]

  template <class Self, class V>
  static void visit_rows(Self& self, const V& v) {
    v(FieldSpec{"record_interval", "Row every", "In plots and recordings", FieldQuantity::interval,
                FieldRange::positive},
      self.record_interval);
  }
  bool operator==(const Timed&) const = default;
};

/// The sweep: the finger crosses the edge of the object at right angles, as in Figure 3 of the paper.
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

/// The fields of kinds that press the finger down to a depth, hold it, and lift it. `visit_at_depth` of a kind visits
/// the fields of its motion at the depth.
struct Pressed : Timed {
  double depth = 0.0015;     ///< depth below first contact with the object's top [m]
  double speed = 0.010;      ///< speed of the mocap body on straight lines [m/s]
  double tilt_deg = 45.0;    ///< angle of `distal` below the horizontal
  double place = 0.0;        ///< x of the lowest point, from the object's middle [m]
  double clearance = 0.001;  ///< gap between finger and object at the start [m]
  double hold = 0.2;         ///< rest at the end of the motion at the depth [s]

  template <class Self, class V>
  static void visit(Self& self, const V& v) {
    v(kDepth, self.depth);
    v(kSpeed, self.speed);
    v(kTilt, self.tilt_deg);
    v(kPlace, self.place);
    v(FieldSpec{"clearance", "Clearance", "Gap between finger and object at the start", FieldQuantity::length,
                FieldRange::not_negative},
      self.clearance);
    Self::visit_at_depth(self, v);
    v(FieldSpec{"hold", "Hold", "Rest at the depth, or at the end of the way there", FieldQuantity::duration,
                FieldRange::not_negative},
      self.hold);
  }
  bool operator==(const Pressed&) const = default;
};

/// The press: the finger moves down to a depth, rests, and moves up.
struct Press : Pressed {
  static constexpr std::string_view kWord = "press";
  template <class Self, class V>
  static void visit_at_depth(Self&, const V&) {}
  bool operator==(const Press&) const = default;
};

/// The roll: the pressed finger rolls about its width axis without slipping, and back.
struct Roll : Pressed {
  static constexpr std::string_view kWord = "roll";
  double angle_deg = 30.0;  ///< angle of the roll; positive towards +x
  double rate_deg = 60.0;   ///< angular speed [degrees/s]

  template <class Self, class V>
  static void visit_at_depth(Self& self, const V& v) {
    v(kAngle, self.angle_deg);
    v(kRate, self.rate_deg);
  }
  bool operator==(const Roll&) const = default;
};

/// The twist: the pressed finger turns about its pad's normal through its lowest point, and back.
struct Twist : Pressed {
  static constexpr std::string_view kWord = "twist";
  double angle_deg = 30.0;  ///< angle of the twist
  double rate_deg = 60.0;   ///< angular speed [degrees/s]

  template <class Self, class V>
  static void visit_at_depth(Self& self, const V& v) {
    v(kAngle, self.angle_deg);
    v(kRate, self.rate_deg);
  }
  bool operator==(const Twist&) const = default;
};

/// The slide: the pressed finger moves along the object's top, and back.
struct Slide : Pressed {
  static constexpr std::string_view kWord = "slide";
  double distance = 0.010;     ///< length of the slide [m]
  double direction_deg = 0.0;  ///< direction of the slide, from +x towards +y

  template <class Self, class V>
  static void visit_at_depth(Self& self, const V& v) {
    v(FieldSpec{"distance", "Slide distance", "There, and the same way back", FieldQuantity::length,
                FieldRange::positive},
      self.distance);
    v(FieldSpec{"direction_deg", "Direction", "Of the slide, from +x towards +y", FieldQuantity::angle},
      self.direction_deg);
  }
  bool operator==(const Slide&) const = default;
};

/// The drop: the finger falls on the object under gravity; no weld holds it.
struct Drop : Timed {
  static constexpr std::string_view kWord = "drop";
  double tilt_deg = 45.0;  ///< angle of `distal` below the horizontal
  double place = 0.0;      ///< x of the lowest point, from the object's middle [m]
  double height = 0.010;   ///< gap between finger and object at the start [m]
  double duration = 0.5;   ///< duration of the scenario [s]

  template <class Self, class V>
  static void visit(Self& self, const V& v) {
    v(kTilt, self.tilt_deg);
    v(kPlace, self.place);
    v(FieldSpec{"height", "Height", "From which it drops: the gap to the object", FieldQuantity::length,
                FieldRange::positive},
      self.height);
    v(FieldSpec{"duration", "Drop lasts", "Until the scenario is over", FieldQuantity::duration, FieldRange::positive},
      self.duration);
  }
  bool operator==(const Drop&) const = default;
};

/// The path: the finger moves through waypoints.
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

/// The replay: the finger takes the poses of a recording, step by step.
struct Replay : Timed {
  static constexpr std::string_view kWord = "replay";
  static constexpr bool kHasPoses = true, kHasTimestep = false;
  std::string source = {};  ///< folder of a recording, or its .npz file

  template <class Self, class V>
  static void visit(Self& self, const V& v) {
    v(FieldSpec{"source", "Recording", "A folder of taxel sweep, play or run, or its readings.npz",
                FieldQuantity::file},
      self.source);
  }
  void check(ObjectShape) const {
    if (source.empty()) throw Error("", "/source", "a replay needs a recording: a folder or its .npz");
  }
  bool operator==(const Replay&) const = default;
};

/// The path of the paper's released demo: onto the demo's box, and back.
struct Paper : Timed {
  static constexpr std::string_view kWord = "paper";
  static constexpr bool kHasObject = false;
  Paper() { record_interval = 0.025; }  // a step of the released demo

  template <class Self, class V>
  static void visit(Self&, const V&) {}
  bool operator==(const Paper&) const = default;
};

}  // namespace scenarios
}  // namespace taxel
