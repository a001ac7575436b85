// What happens in a built scene: plain values that a project file holds and a user edits.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/base/math.h"
#include "core/layout/words.h"

namespace taxel {

/// How the finger is led. In all but `drop` a weld holds it to a mocap body.
enum class ScenarioKind {
  sweep,   ///< straight over the edge of the object, at right angles to it: the paper's Figure 3
  press,   ///< down to a depth, hold, up
  roll,    ///< pressed down, it rolls about its width axis, without slipping, and back
  twist,   ///< pressed down, it turns about its pad's normal through its lowest point, and back
  slide,   ///< pressed down, it slides along the top, and back
  drop,    ///< released above the object: gravity, no weld
  path,    ///< through waypoints
  replay,  ///< the poses of a recording, step by step
  paper    ///< the path of the paper's released demo, onto the demo's box and back
};
inline constexpr Word<ScenarioKind> kScenarioKindWords[] = {
    {ScenarioKind::sweep, "sweep"}, {ScenarioKind::press, "press"},   {ScenarioKind::roll, "roll"},
    {ScenarioKind::twist, "twist"}, {ScenarioKind::slide, "slide"},   {ScenarioKind::drop, "drop"},
    {ScenarioKind::path, "path"},   {ScenarioKind::replay, "replay"}, {ScenarioKind::paper, "paper"}};
inline std::span<const Word<ScenarioKind>> words_of(ScenarioKind) {
  return kScenarioKindWords;
}

/// Object that the finger touches. The edge that a sweep crosses is the line x = 0 on top of the object; the bounds
/// begin at z = 0, their middle is at y = 0. The bounds of all shapes but `edge`, and those of a mesh, begin at x = 0.
enum class ObjectShape {
  edge,   ///< a box of `box_size` that is balanced on an edge; the opposite edge, rounded, points up
  box,    ///< `box_size` is the length of its edges
  plate,  ///< `box_size` is the length of its sides; a tenth as thick
  sphere  ///< `box_size` is its diameter
};
inline constexpr Word<ObjectShape> kObjectShapeWords[] = {{ObjectShape::edge, "edge"},
                                                          {ObjectShape::box, "box"},
                                                          {ObjectShape::plate, "plate"},
                                                          {ObjectShape::sphere, "sphere"}};
inline std::span<const Word<ObjectShape>> words_of(ObjectShape) {
  return kObjectShapeWords;
}

/// The mocap body is at X_WM (the frame of the finger's mesh file, world) at `time`.
struct WayPoint {
  double time = 0;  ///< [s]
  Pose X_WM;
  bool operator==(const WayPoint& other) const {
    return time == other.time && X_WM.p == other.X_WM.p && X_WM.q == other.X_WM.q;
  }
};

/// Each kind uses some of these values (ScenarioParameter::kinds); those that it does not use stay as they are.
struct Scenario {
  ScenarioKind kind = ScenarioKind::sweep;
  double depth = 0.0015;           ///< below first touch on the object's top [m]
  double speed = 0.010;            ///< of the mocap body along straight ways [m/s]
  double before = 0.025;           ///< start: distance of the finger's lowest point from the edge; see kEdgeReach [m]
  double past = 0.025;             ///< end: distance of the finger's lowest point from the edge [m]
  double tilt_deg = 45.0;          ///< of `distal` below the horizontal
  double record_every = 0.0001;    ///< a row per this travel, of a sweep [m]
  double timestep = 0.001;         ///< [s]; a replay takes its recording's
  double finger_mass = 0.020;      ///< [kg]
  double box_size = 0.050;         ///< see ObjectShape [m]
  double edge_radius = 0.001;      ///< radius of the round on an `edge` [m]
  std::string object;              ///< mesh file of the object; empty: `shape`
  double place = 0.0;              ///< lowest point of the finger, from the object's middle along x [m]
  double clearance = 0.001;        ///< gap between finger and object at the start [m]
  double hold = 0.2;               ///< rest at the depth, or at the end of the way there [s]
  double angle_deg = 30.0;         ///< through which it rolls (positive: forward, towards +x) or twists
  double rate_deg = 60.0;          ///< at which it does [degrees/s]
  double distance = 0.010;         ///< of the slide [m]
  double direction_deg = 0.0;      ///< of the slide, from +x towards +y
  double height = 0.010;           ///< from which it drops: gap to the object [m]
  double duration = 0.5;           ///< of a drop [s]
  double record_interval = 0.010;  ///< a row per this time, of all but a sweep [s]
  ObjectShape shape = ObjectShape::edge;
  std::string source = {};            ///< of a replay: a folder that holds a recording, or its .npz
  std::vector<WayPoint> points = {};  ///< of a path, at ascending times
  bool operator==(const Scenario&) const = default;
};

/// Default of `record_interval`, that of `paper` being a step of the released demo [s].
inline constexpr double kInterval = 0.010, kPaperInterval = 0.025;

/// Default of `before` and `past` on an `edge`, and on all other objects [m]. A sweep over an `edge` starts and ends
/// farther away where the finger would touch the object there.
inline constexpr double kEdgeReach = 0.025, kBoxReach = 0.012;

/// The default object of a kind: `edge` for a sweep, `box` for all others.
ObjectShape default_shape(ScenarioKind kind);

/// Returns the default scenario of a kind, with its default object.
Scenario default_scenario(ScenarioKind kind);

/// Returns `scenario` with another shape in place of its object. `before` and `past` follow if they have the default
/// values of the former shape.
Scenario with_shape(Scenario scenario, ObjectShape shape);

/// Returns `scenario` with a mesh file as its object, or with `box` if `file` is empty.
Scenario with_object(Scenario scenario, const std::string& file);

/// Returns `scenario` as another kind. The object follows if it is the default object of the former kind; it stays if
/// the new kind has poses in the world, which were made for it.
Scenario with_kind(Scenario scenario, ScenarioKind kind);

enum class ParameterRange { positive, not_negative, any };

/// A number of a scenario: its key in files, its range, and the kinds and shapes that use it.
struct ScenarioParameter {
  const char* key;
  double Scenario::*value;
  ParameterRange range;
  unsigned kinds;          ///< bit 1 << kind
  bool edge_only = false;  ///< used by the shape `edge` alone

  [[nodiscard]] bool used_by(ScenarioKind kind, ObjectShape shape) const {
    return (kinds >> static_cast<unsigned>(kind) & 1U) != 0 && (!edge_only || shape == ObjectShape::edge);
  }
  [[nodiscard]] bool used_by(const Scenario& scenario) const { return used_by(scenario.kind, scenario.shape); }
};

/// All of them, in the order of files.
std::span<const ScenarioParameter> scenario_parameters();

}  // namespace taxel
