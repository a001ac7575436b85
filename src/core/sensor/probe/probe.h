// A probe pressed on a sensor at once, without a simulation: what tells while editing whether a layout senses what it
// should.
#pragma once

#include <optional>
#include <variant>

#include "core/base/memo.h"
#include "core/hydro/intersect.h"
#include "core/hydro/traction.h"
#include "core/sensor/readout/reading.h"

namespace taxel {

// Shapes in the frame P of the probe: its tip is the origin, the rest lies towards +z. Lengths in metres.

struct ProbeSphere {
  double radius = 0.005;
  bool operator==(const ProbeSphere&) const = default;
};

/// A wedge: its edge lies along x, with the tip in the middle.
struct ProbeEdge {
  double length = 0.02;
  double height = 0.02;
  double angle_deg = 90;  ///< between its two faces
  bool operator==(const ProbeEdge&) const = default;
};

/// A cone that stands on its apex; of any height the volume is that of the round cone.
struct ProbePoint {
  double height = 0.02;
  double angle_deg = 60;  ///< full opening angle
  bool operator==(const ProbePoint&) const = default;
};

/// A closed mesh that is pressed along its -z. Tip: the middle of the box around its lowest vertices.
struct ProbeMesh {
  TriMeshPtr mesh;  ///< equal where it is the same object
  bool operator==(const ProbeMesh&) const = default;
};

using ProbeShape = std::variant<ProbeSphere, ProbeEdge, ProbePoint, ProbeMesh>;

/// A probe, and where it is pressed. Frame M.
struct Probe {
  ProbeShape shape;
  Material material;               ///< modulus 0: rigid, which only a soft sensor can be touched with
  dvec3 point{0};                  ///< pressed at the nearest point of the skin
  std::optional<dvec3> direction;  ///< in which it is pushed, of any length; against the skin's normal where not set
  double depth = 0.001;            ///< of the tip below that point, along the direction; at 0 nothing touches yet [m]
  double roll_deg = 0;             ///< about z of P, from where its x is e1 of tangent_frame() for z
  bool operator==(const Probe&) const = default;
};

/// What a press needs and produces: the bodies of the last few shapes, and memory that is reused.
struct ProbePress {
  Pose X_MP;
  TriMeshPtr mesh;         ///< the probe as drawn, the same object for equal shapes that are still kept
  Pose X_MG;               ///< of that mesh
  ContactSurface surface;  ///< frame M; its normals push the sensor
  Wrench wrench;           ///< of the pressure on the sensor, about M's origin, frame M [N], [N m]
  SensorReading reading;   ///< one value per taxel of the model

  struct Body {
    HydroBodyPtr body;
    TriMeshPtr mesh;  ///< of what is pressed, as drawn
    dvec3 tip{0};     ///< in its own frame
  };
  struct BodyKey {
    ProbeShape shape;
    Material material;
    bool operator==(const BodyKey&) const = default;
  };
  Memo<BodyKey, Body> bodies{8};
  IntersectWorkspace workspace;
};

/// Presses the probe on the sensor and reads it: both at rest, so no damping and no friction. Throws Error that names
/// what cannot be pressed ("probe: depth must be 0 or more, is -0.001"): a length or an angle out of range, an open
/// mesh or one that is inside out, a direction that leads out of the skin, a rigid probe on a rigid sensor. `out` is
/// then as it was.
void press(const SensorModel& model, const Probe& probe, ProbePress& out);

}  // namespace taxel
