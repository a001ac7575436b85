// A probe pressed on a sensor without a simulation, to try out a layout while editing it: the shapes that it may have,
// each with its source in shapes/, and the press.
#pragma once

#include <optional>
#include <variant>

#include "core/base/memo.h"
#include "core/base/text/field_spec.h"
#include "core/hydro/hydro_body.h"
#include "core/hydro/intersect.h"
#include "core/hydro/traction.h"
#include "core/sensor/readout/reading.h"

namespace taxel {

/// The body of a probe in its own frame, and its tip there.
struct ProbeForm {
  Shape shape;
  dvec3 tip{0};
};

/// Returns a mesh as a shape.
Shape mesh_shape(TriMeshPtr mesh);

/// Throws Error("", "probe", message).
[[noreturn]] void refuse_probe(const std::string& message);

/// Throws Error if the value is not greater than 0 and finite.
void check_probe_length(double value, const char* name);

/// Returns the tangent of half of an opening angle. Throws Error unless the angle is between 0 and 180 degrees.
double half_slope(double angle_deg);

/// A probe with the shape of a sphere.
struct ProbeSphere {
  static constexpr const char *kWord = "sphere", *kLabel = "Sphere";
  static constexpr bool kIsRound = true;  ///< a turn about z changes nothing
  static constexpr FieldKind kField = FieldKind::medial_axis;
  double radius = 0.005;  ///< [m]

  template <class V>
  void visit(const V& v) {
    v(FieldSpec{"radius", "Radius", "", FieldQuantity::length, FieldRange::positive}, radius);
  }
  /// Reduces the size to a radius [m].
  void shrink_to(double limit) { radius = std::min(radius, limit); }
  /// Throws Error if the radius is not greater than 0.
  [[nodiscard]] ProbeForm body() const;
  bool operator==(const ProbeSphere&) const = default;
};

/// A wedge whose edge is parallel to x, with the tip in the middle of the edge.
struct ProbeEdge {
  static constexpr const char *kWord = "edge", *kLabel = "Edge";
  static constexpr bool kIsRound = false;
  static constexpr FieldKind kField = FieldKind::pad;
  double length = 0.02;   ///< [m]
  double height = 0.02;   ///< [m]
  double angle_deg = 90;  ///< angle between the two faces at the edge

  template <class V>
  void visit(const V& v) {
    v(FieldSpec{"length", "Length", "", FieldQuantity::length, FieldRange::positive}, length);
    v(FieldSpec{"angle_deg", "Angle", "", FieldQuantity::angle, FieldRange::positive}, angle_deg);
  }
  /// Reduces the size to that of a probe with this radius [m].
  void shrink_to(double radius) { length = std::min(length, 4 * radius), height = std::min(height, 4 * radius); }
  /// Throws Error if a value is out of range.
  [[nodiscard]] ProbeForm body() const;
  bool operator==(const ProbeEdge&) const = default;
};

/// A cone with its apex as the tip. Its volume up to any height is that of the round cone.
struct ProbePoint {
  static constexpr const char *kWord = "point", *kLabel = "Point";
  static constexpr bool kIsRound = true;  ///< a turn about z changes nothing
  static constexpr FieldKind kField = FieldKind::pad;
  double height = 0.02;   ///< [m]
  double angle_deg = 60;  ///< full opening angle

  template <class V>
  void visit(const V& v) {
    v(FieldSpec{"height", "Height", "", FieldQuantity::length, FieldRange::positive}, height);
    v(FieldSpec{"angle_deg", "Angle", "", FieldQuantity::angle, FieldRange::positive}, angle_deg);
  }
  /// Reduces the size to that of a probe with this radius [m].
  void shrink_to(double radius) { height = std::min(height, 4 * radius); }
  /// Throws Error if a value is out of range.
  [[nodiscard]] ProbeForm body() const;
  bool operator==(const ProbePoint&) const = default;
};

/// A closed mesh that is pressed along its -z. The tip is the middle of the box around its lowest vertices.
struct ProbeMesh {
  static constexpr const char *kWord = "mesh", *kLabel = "Mesh file";
  static constexpr bool kIsRound = false;
  static constexpr FieldKind kField = FieldKind::pad;
  TriMeshPtr mesh;        ///< meshes are equal if they are the same object
  std::string file = {};  ///< file that the window reads `mesh` from

  template <class V>
  void visit(const V& v) {
    v(FieldSpec{"file", "File", "Path of a closed mesh, which is pressed along its -z", FieldQuantity::file}, file);
  }
  void shrink_to(double /*radius*/) {}
  /// Throws Error if the mesh has no triangles, is open, or is inside out.
  [[nodiscard]] ProbeForm body() const;
  bool operator==(const ProbeMesh&) const = default;
};

/// The shapes of a probe in its frame P: the tip is the origin, and the body is on the side of +z. To add a shape, add
/// its struct above, its source in shapes/ and its alternative here.
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
