// A body for the contact kernel: geometry in its own frame, with a material. Immutable. Here are the shapes that bodies
// are made of, the repair of their meshes, and the depth of points behind their skins.
#pragma once

#include <memory>
#include <string>
#include <variant>

#include "core/base/material.h"
#include "core/hydro/fields/pressure_field.h"
#include "core/hydro/fields/tet_mesh.h"
#include "core/mesh/repair/repair.h"
#include "core/mesh/repair/repair_recipe.h"

namespace taxel {

class DepthField;
class FacetTree;
class FieldIndex;
class MatchedFields;
class MeshIndex;

struct SoftBody {
  explicit SoftBody(PressureFieldPtr f, std::shared_ptr<const DepthField> d = nullptr);
  PressureFieldPtr field;
  std::shared_ptr<const DepthField> depth;  ///< field of a pad beyond its tets; null if the field ends with its tets
  std::shared_ptr<const FieldIndex> index;  ///< field in the form that the kernel reads
  std::shared_ptr<MatchedFields> matched;   ///< fields for pairs with a pressure law (law_match.h)
};
/// The half-space z <= 0 with the pressure p = stiffness * depth.
struct SoftHalfSpace {
  double stiffness = 0;  ///< E/H [Pa/m]
  double thickness = 0;  ///< H [m]
};
struct RigidMesh {
  explicit RigidMesh(std::shared_ptr<const MeshIndex> i);
  std::shared_ptr<const MeshIndex> index;  ///< closed mesh with outward faces
  std::shared_ptr<const FacetTree> tree;
};
struct RigidHalfSpace {};  ///< half-space z <= 0

struct HydroBody {
  std::variant<RigidHalfSpace, SoftHalfSpace, SoftBody, RigidMesh> geometry;
  Material material;
  std::string name;                  ///< name for messages
  std::vector<double> law_levels{};  ///< strains at which polygons are divided (law_levels()); empty if linear
  [[nodiscard]] bool soft() const { return geometry.index() == 1 || geometry.index() == 2; }
  [[nodiscard]] bool half_space() const { return geometry.index() < 2; }
};
using HydroBodyPtr = std::shared_ptr<const HydroBody>;

/// MuJoCo's geom types and sizes.
enum class ShapeType { plane, sphere, capsule, ellipsoid, cylinder, box, mesh, tets };

struct Shape {
  ShapeType type = ShapeType::sphere;
  dvec3 size{0};              ///< sphere [r], capsule and cylinder [r, half length], box and ellipsoid half sizes
  TriMeshPtr mesh = nullptr;  ///< for type mesh
  double resolution = 0;      ///< edge length of the tessellation [m]; 0: a tenth of the smallest extent
  TetMeshPtr tets = nullptr;  ///< for type tets
  const char* rigid_only = nullptr;    ///< name of a shape that can only be rigid, such as "a height field", or null
  std::vector<int> face_numbers = {};  ///< the user's numbers of the faces; empty if the mesh has its own
  double refine = kDefaultRefine;      ///< longest edge of a soft mesh's skin, in thicknesses of its pad
};

/// Returns the target length of the edges of a round shape: its resolution, or a tenth of its smallest extent [m].
double tessellation_edge(const Shape& shape);

/// Builds the body of a shape, which is soft if material.modulus > 0. Rigid planes and boxes are exact; round shapes
/// are tessellated and scaled to their true volume. A soft mesh gets a pad on its outer shells (thickness 0: an eighth
/// of the smallest extent) or a star. A soft primitive gets its medial-axis field, or a pad if the material names pad
/// and a thickness. Soft tets get their own field, rigid tets become their boundary. Throws Error that names the
/// unsupported combination or the value out of range (size <= 0, pad on an open mesh, ...).
HydroBodyPtr make_body(const Shape& shape, const Material& material, const std::string& name);

/// Builds a body like make_body(shape, material, name). If another body of the same shape and material exists, a
/// primitive shares its geometry, so a thousand equal spheres are built once. May be called from any thread.
HydroBodyPtr share_body(const Shape& shape, const Material& material, const std::string& name);

// Bodies whose middle is behind the pad of a soft body: they fell through its skin, or began there.

/// Returns a point in the material of a body, frame of the body: the middle of its bounds or, if the body is hollow
/// there (a ring, a cup), the vertex that is nearest to it. The origin for a half-space, which is behind no skin.
dvec3 inner_point(const HydroBody& body);

/// How far a point is behind a skin.
struct BehindSkin {
  double depth = 0;      ///< distance to the skin, negative outside [m]
  double thickness = 0;  ///< thickness of the pad [m]
  [[nodiscard]] bool beyond_the_pad() const { return depth > thickness; }
};

/// Returns the depth of a point in the frame of a body: 0 and 0 unless the body has a pad or is a soft half-space.
/// O(log n).
BehindSkin behind_skin(const HydroBody& body, const dvec3& x);

/// Repairs the mesh of a shape that a skin touches. A soft mesh is repaired by the default
/// recipe of layouts, which may wrap it, a rigid one by exact steps alone; an open sheet without an inside becomes
/// two-sided if it is rigid. `exact` never wraps, and `off` changes nothing. face_numbers remain those of the faces
/// before the repair, with -1 for filled faces. Shapes that are not a mesh, height fields and signed distance functions
/// do not change. Returns the repaired mesh with its report, or null if nothing was changed. Throws Error with the
/// place and the remedy if no inside is found.
RepairedMeshPtr repair_touched_mesh(Shape& shape, const Material& material, TouchedRepair repair);

}  // namespace taxel
