// What a hand can set in a scene, free of MuJoCo: what there is to set, how it stands, and what is asked for.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/base/math.h"
#include "core/layout/file/skin_choice.h"

namespace taxel {

using ControlRange = std::array<double, 2>;

struct SceneActuator {
  std::string name;
  std::optional<ControlRange> range;  ///< of the control, in the actuator's own unit; none: unlimited
};
/// A joint of one coordinate: an angle [rad] or a length [m].
struct SceneJoint {
  std::string name;
  bool hinge = true;  ///< else it slides
  std::optional<ControlRange> range;
};
struct SceneKeyframe {
  std::string name;
  double time = 0;  ///< [s]
};
struct SceneEquality {
  std::string name;
  std::string kind;     ///< "weld", "connect", "joint", ...
  bool placed = false;  ///< holds two points together, which can be drawn
};
struct SceneBody {
  std::string name;
  int mocap = -1;      ///< its number among the mocap bodies
  bool fixed = false;  ///< to the world: nothing moves it
  int parent = 0;      ///< its number
};

/// Does not change while the scene runs.
struct SceneControls {
  std::vector<SceneBody> bodies;  ///< as MuJoCo numbers them; the first is the world
  std::vector<SceneActuator> actuators;
  std::vector<SceneJoint> joints;  ///< hinges and slides
  std::vector<SceneKeyframe> keyframes;
  std::vector<std::string> mocaps;  ///< body of each
  std::vector<SceneEquality> equalities;
  dvec3 gravity{0};        ///< [m/s^2]
  std::string integrator;  ///< as MJCF says it
};

/// A layout on a geom of a scene that does not declare it.
struct SceneAttachment {
  std::string geom;      ///< its name, or "geom 7" for one without; empty: the one that the layout names
  std::string layout;    ///< file
  SkinChoice skin = {};  ///< for layouts of other programs, which may name the geom, and take its mesh
  bool operator==(const SceneAttachment&) const = default;
};

/// How all that stands, in the state from which the next step goes on.
struct ControlValues {
  std::vector<double> controls, joints;  ///< parallel to actuators and joints
  std::vector<Pose> mocaps;              ///< X_WB
  std::vector<bool> equalities;          ///< whether they hold
};

/// A body in the hand, as MuJoCo's viewer has it: a spring pulls its grabbed point to the hand, or turns it as the hand
/// does; while nothing runs a free body is put where the hand is, and a mocap body always is.
struct Perturb {
  enum class Kind { none, pull, turn };
  Kind kind = Kind::none;
  int geom = -1;               ///< in SimScene::geoms, on which it was grabbed
  dvec3 point_G{0};            ///< where
  std::uint64_t grip = 0;      ///< another number: it is taken hold of anew, where it is then
  dvec3 moved_W{0};            ///< by the hand since [m]
  dquat turned_W{1, 0, 0, 0};  ///< likewise
  bool running = true;         ///< steps are being made
};

struct SetControl {
  int actuator = 0;
  double value = 0;
};
struct SetJoint {
  int joint = 0;
  double value = 0;
};
struct SetMocap {
  int mocap = 0;
  Pose X_WB;
};
struct SetEquality {
  int equality = 0;
  bool active = true;
};
/// To be carried out between two steps.
using SceneEdit = std::variant<SetControl, SetJoint, SetMocap, SetEquality, Perturb>;

/// A body in the hand, in one step.
struct PerturbShown {
  Perturb::Kind kind = Perturb::Kind::none;
  int body = -1;
  dvec3 grabbed_W{0};             ///< the point that was grabbed, and
  dvec3 hand_W{0};                ///< where the hand has it
  dquat hand_turn_W{1, 0, 0, 0};  ///< from the body's orientation to the hand's
};

/// Two points that an active equality constraint holds together.
struct ConstraintPoints {
  dvec3 a_W{0}, b_W{0};
  bool weld = false;
};

}  // namespace taxel
