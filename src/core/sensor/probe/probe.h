// A probe pressed on a sensor without a simulation, to try out a layout while editing it.
#pragma once

#include <optional>
#include <variant>

#include "core/base/memo.h"
#include "core/hydro/intersect.h"
#include "core/hydro/traction.h"
#include "core/sensor/probe/shapes/edge.h"
#include "core/sensor/probe/shapes/mesh.h"
#include "core/sensor/probe/shapes/point.h"
#include "core/sensor/probe/shapes/sphere.h"
#include "core/sensor/readout/reading.h"

namespace taxel {

/// The shapes of a probe in its frame P: the tip is the origin, and the body is on the side of +z. To add a shape, add
/// its files in shapes/ and its alternative here.
using ProbeShape = std::variant<ProbeSphere, ProbeEdge, ProbePoint, ProbeMesh>;

/// A probe and the place where it is pressed, in frame M.
struct Probe {
  ProbeShape shape;
  Material material;  ///< modulus 0 for a rigid probe, which needs a soft sensor
  dvec3 point{0};     ///< the probe is pressed at the nearest point of the skin
  /// Direction of the push, of any length. If empty, the direction is opposite to the skin's normal.
  std::optional<dvec3> direction;
  double depth = 0.001;  ///< depth of the tip below that point along the direction [m]
  double roll_deg = 0;   ///< turn about z of P; at 0, x of P is e1 of tangent_frame()
  bool operator==(const Probe&) const = default;
};

/// Result and reused memory of a press, and the bodies of the last shapes.
struct ProbePress {
  Pose X_MP;
  TriMeshPtr mesh;         ///< mesh to draw; the same object while the shape is kept
  Pose X_MG;               ///< pose of `mesh`
  ContactSurface surface;  ///< frame M; its normals point into the sensor
  Wrench wrench;           ///< pressure on the sensor, about the origin of M [N], [N m]
  SensorReading reading;   ///< one value per taxel of the model

  struct Body {
    HydroBodyPtr body;
    TriMeshPtr mesh;  ///< mesh to draw
    dvec3 tip{0};     ///< tip in the frame of the body
  };
  struct BodyKey {
    ProbeShape shape;
    Material material;
    bool operator==(const BodyKey&) const = default;
  };
  Memo<BodyKey, Body> bodies{8};
  IntersectWorkspace workspace;
};

/// Presses the probe on the sensor and reads the sensor. Both are at rest, so there is no damping and no friction. At
/// depth 0 nothing touches. Throws Error that names the value ("probe: depth must be 0 or more, is -0.001") for a
/// length or an angle out of range, an open or inverted mesh, a direction out of the skin, or a rigid probe on a rigid
/// sensor. `out` is then unchanged.
void press(const SensorModel& model, const Probe& probe, ProbePress& out);

}  // namespace taxel
