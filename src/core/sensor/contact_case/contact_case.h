// One contact between two bodies at given poses: the `contact-case` file and its evaluation.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/hydro/contact_surface.h"
#include "core/hydro/hydro_body.h"
#include "core/hydro/intersect.h"
#include "core/hydro/traction.h"
#include "core/mesh/make/primitives.h"
#include "core/sensor/sensor_model.h"

namespace taxel {

/// A shape with MuJoCo's name of its type. A mesh comes from a file.
struct CaseShape {
  ShapeType type = ShapeType::sphere;
  dvec3 size{0};                            ///< size as in Shape::size [m]
  std::string file;                         ///< mesh or tets, relative to the case file or absolute
  dvec3 scale{1.0};                         ///< factors of the mesh file's coordinates
  std::optional<HeightField> height_field;  ///< height field in place of the above; rigid
  /// Target edge length of the tessellation [m]; 0 for a tenth of the smallest extent.
  double resolution = 0;
  TouchedRepair repair = TouchedRepair::automatic;  ///< repair of a mesh

  bool operator==(const CaseShape&) const = default;
};

/// A body of a case: a shape with a material, or a layout with its mesh and material. The caller gives the body if both
/// are empty.
struct CaseBody {
  std::optional<CaseShape> shape;
  std::string layout;  ///< layout file, relative to the case file or absolute
  Material material;   ///< material of a shape
  Pose X_WB;           ///< pose of the shape, or of the layout's mesh frame
  Twist V_WB;          ///< velocity of the body's origin, world frame [m/s], [rad/s]
};

/// The two bodies of a case.
struct ContactCase {
  CaseBody a, b;
  std::string file;  ///< file of the case, for messages and relative paths
};

/// Parses version 1 of `contact-case`. A quaternion is normalised only if its squared length differs from 1 by more
/// than 1e-12, so that recorded poses keep their bits. Throws Error(file, JSON pointer, message): wrong JSON, unknown
/// key or word, wrong type or length, size <= 0, a zero quaternion, another version.
ContactCase parse_contact_case(const std::string& text, const std::string& file = "");
/// Reads a file by parse_contact_case(). Throws Error as it does, or if the file cannot be read.
ContactCase read_contact_case(const std::filesystem::path& path);

/// Returns a quaternion that is normalised only if its squared length differs from 1 by more than 1e-12, so that
/// recorded poses keep their bits. It must not be zero.
dquat unit_quaternion(double w, double x, double y, double z);

/// Returns the path of a file that a case names. Relative names are in the folder of the case file.
std::filesystem::path beside_case(const ContactCase& contact_case, const std::string& file);

/// A body of a case, with the whole model of a layout.
struct MadeBody {
  HydroBodyPtr body;
  SensorModelPtr model;        ///< model of a layout, null for a shape
  std::optional<Shape> shape;  ///< shape, not set for a layout
  /// Returns the report on the field of a soft body with tets, otherwise null.
  [[nodiscard]] const FieldReport* field_report() const;
  std::vector<std::string> warnings;
};

/// Builds body `a` or `b` of a case. `name` ("a" or "b") is the body's pointer in messages. Throws Error.
MadeBody make_case_body(const ContactCase& contact_case, const CaseBody& body, const std::string& name);

/// The contact of a case.
struct ContactResult {
  ContactSurface surface;  ///< surface in the frame of a
  Wrench wrench_W;         ///< wrench on a about its origin, world frame
  dvec3 centroid_W{0};     ///< centre of pressure; a's origin without contact
};

/// Evaluates the contact of two bodies at the poses of the case. Velocities affect damping and friction. Throws Error
/// if both bodies are rigid, or both are half-spaces.
void evaluate_contact(const ContactCase& contact_case, const HydroBody& a, const HydroBody& b, ContactResult& out,
                      IntersectWorkspace& workspace);

/// Returns the velocity of body A relative to body B at A's origin, in frame A.
Twist relative_twist(const CaseBody& a, const CaseBody& b);

}  // namespace taxel
