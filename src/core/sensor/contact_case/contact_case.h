// One contact between two bodies at given poses: the `contact-case` file, and what comes out of it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/hydro/contact_surface.h"
#include "core/hydro/hydro_body.h"
#include "core/hydro/intersect.h"
#include "core/hydro/traction.h"
#include "core/mesh/make/height_field.h"
#include "core/sensor/sensor_model.h"

namespace taxel {

/// A shape as MuJoCo names it; a mesh comes from a file.
struct CaseShape {
  ShapeType type = ShapeType::sphere;
  dvec3 size{0};                            ///< [m]; as Shape::size
  std::string file;                         ///< of a mesh or of tets: relative to the case file, or absolute
  dvec3 scale{1.0};                         ///< of the mesh file's coordinates
  std::optional<HeightField> height_field;  ///< instead of all of these: a rigid mesh made of it
  double resolution = 0;  ///< target edge length of the tessellation [m]; 0: a tenth of the smallest extent
};

/// A body of a case: a shape with a material, or a layout (its mesh and material). Neither: to be given by the caller.
struct CaseBody {
  std::optional<CaseShape> shape;
  std::string layout;  ///< layout file: relative to the case file, or absolute
  Material material;   ///< of a shape
  Pose X_WB;           ///< of the shape, or of the mesh-file frame of the layout
  Twist V_WB;          ///< velocity of the body's origin, angular velocity; world frame [m/s], [rad/s]
};

struct ContactCase {
  CaseBody a, b;
  std::string file;  ///< where it came from: for messages and relative paths
};

/// Parses version 1 of `contact-case`. Throws Error(file, JSON pointer, message): wrong JSON, unknown key or word,
/// wrong type or length, size <= 0, a zero quaternion, another version. A quaternion is normalised only where its
/// squared length is off by more than 1e-12, so that recorded poses keep their bits.
ContactCase parse_contact_case(const std::string& text, const std::string& file = "");
ContactCase read_contact_case(const std::filesystem::path& path);

/// Where a file that a case names lies: relative names stand beside the case file.
std::filesystem::path beside_case(const ContactCase& contact_case, const std::string& file);

/// A body with what else came along: a layout brings its whole model.
struct MadeBody {
  HydroBodyPtr body;
  SensorModelPtr model;  ///< null for a shape
  /// Of a soft body that has tets: what its field is worth. Null for others.
  [[nodiscard]] const FieldReport* field_report() const;
  std::vector<std::string> warnings;
};

/// Makes body `a` or `b` of a case; `name` ("a" or "b") stands in messages as its pointer. Throws Error.
MadeBody make_case_body(const ContactCase& contact_case, const CaseBody& body, const std::string& name);

/// Everything `taxel contact` tells. World frame.
struct ContactResult {
  ContactSurface surface;  ///< frame of a
  Wrench wrench_W;         ///< on a, about a's origin
  dvec3 centroid_W{0};     ///< of the pressure; a's origin where nothing touches
};

/// The contact of two bodies placed as the case says; velocities enter damping and friction. Throws Error where both
/// are rigid, or both half-spaces.
void evaluate_contact(const ContactCase& contact_case, const HydroBody& a, const HydroBody& b, ContactResult& out,
                      IntersectWorkspace& workspace);

/// Velocity of body A relative to body B at A's origin, in frame A.
Twist relative_twist(const CaseBody& a, const CaseBody& b);

}  // namespace taxel
