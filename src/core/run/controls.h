// The controls of a scene that users can set: their descriptions, their values, and requests to change them. Free of
// MuJoCo.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/base/math.h"
#include "core/layout/user_choices.h"
#include "core/sensor/sensor_model.h"

namespace taxel {

using ControlRange = std::array<double, 2>;

struct SceneActuator {
  std::string name;
  std::optional<ControlRange> range;  ///< range of the control, in the actuator's unit; empty if unlimited
  std::string joint = {};             ///< name of the driven joint, or empty if the actuator drives something else
};
/// A joint with one coordinate: an angle [rad] or a length [m].
struct SceneJoint {
  std::string name;
  bool hinge = true;  ///< true for a hinge, false for a slide
  std::optional<ControlRange> range;
};
struct SceneKeyframe {
  std::string name;
  double time = 0;  ///< [s]
};
struct SceneEquality {
  std::string name;
  std::string kind;     ///< "weld", "connect", "joint", ...
  bool placed = false;  ///< the constraint holds two points together, which can be drawn
};
struct SceneBody {
  std::string name;
  int mocap = -1;      ///< index among the mocap bodies, or -1
  bool fixed = false;  ///< fixed to the world, so that nothing moves the body
  int parent = 0;      ///< index of the parent body
  bool free = false;   ///< has a free joint
};

/// All controls of a scene. They do not change while the scene runs.
struct SceneControls {
  std::vector<SceneBody> bodies;  ///< in MuJoCo's order; the first is the world
  std::vector<SceneActuator> actuators;
  std::vector<SceneJoint> joints;  ///< hinges and slides
  std::vector<SceneKeyframe> keyframes;
  std::vector<std::string> mocaps;  ///< body name of each mocap body
  std::vector<SceneEquality> equalities;
  dvec3 gravity{0};        ///< [m/s^2]
  std::string integrator;  ///< MJCF keyword
};

/// A layout on a geom of a scene whose file does not declare that layout.
struct SceneAttachment {
  std::string geom;            ///< name (SceneNames::find); empty for the geom that the layout names
  std::string layout;          ///< layout file
  SkinChoice skin = {};        ///< skin of another program's layout, which may name the geom and take its mesh
  std::string body = {};       ///< body whose only mesh gets the layout; empty if the geom is named
  std::string others = {};     ///< names of the touched geoms, or empty for all that the geom's body can touch
  bool keeps_sisters = false;  ///< collision geoms of the body within the skin keep their contacts
  /// Compiled layout that is used instead of the content of `layout`, or null. Its mesh is in the frame of the geom's
  /// mesh file.
  SensorModelPtr model = nullptr;
  /// The scene's file declares a sensor on `geom`, whose layout was edited: `model` is used instead of that layout.
  bool is_declared = false;
  bool operator==(const SceneAttachment&) const = default;
};

/// The values of all controls, in the state from which the next step begins.
struct ControlValues {
  std::vector<double> controls, joints;  ///< parallel to actuators and joints
  std::vector<Pose> mocaps;              ///< X_WB
  std::vector<bool> equalities;          ///< active constraints
};

/// A body that the user drags, as in MuJoCo's viewer: a spring pulls the grabbed point, or turns the body. While the
/// simulation is paused, a free body moves with the pointer at once; a mocap body always does.
struct Perturb {
  enum class Kind { none, pull, turn };
  Kind kind = Kind::none;
  int geom = -1;               ///< index in SimScene::geoms of the grabbed geom
  dvec3 point_G{0};            ///< grabbed point
  std::uint64_t grip = 0;      ///< number of the grab; a new number grabs the body again where it is then
  dvec3 moved_W{0};            ///< translation since the grab [m]
  dquat turned_W{1, 0, 0, 0};  ///< rotation since the grab
  bool running = true;         ///< the simulation is making steps
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
/// Places a body with a free joint, at rest, or a mocap body.
struct SetBody {
  int body = 0;  ///< index in SceneControls::bodies
  Pose X_WB;
};
/// A change of the scene between two steps.
using SceneEdit = std::variant<SetControl, SetJoint, SetMocap, SetEquality, SetBody, Perturb>;

/// The body that the user drags, at one step.
struct PerturbShown {
  Perturb::Kind kind = Perturb::Kind::none;
  int body = -1;
  dvec3 grabbed_W{0};               ///< grabbed point of the body
  dvec3 target_W{0};                ///< point to which the user drags the grabbed point
  dquat target_turn_W{1, 0, 0, 0};  ///< rotation from the body's orientation to the requested one
};

/// Two points that an active equality constraint holds together.
struct ConstraintPoints {
  dvec3 a_W{0}, b_W{0};
  bool weld = false;
};

}  // namespace taxel
