// A compliant body's pressure field: linear on tetrahedra, zero on the skin, growing inward (Elandt et al. 2019).
// Here are the field with its report, and the functions that make the fields of pads, stars and MuJoCo's primitives.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/base/material.h"
#include "core/mesh/query/bvh.h"
#include "core/mesh/repair/repair_recipe.h"
#include "core/mesh/tri_mesh.h"

namespace taxel {

/// Returns the pressure p = E d/H at a depth below the skin of a layer on a rigid core [Pa]. Depth and thickness in
/// metres, modulus in pascals.
inline double elastic_pressure(double depth, double thickness, double modulus) {
  return modulus * depth / thickness;
}

/// One tetrahedron with all values that the kernel needs, in the frame of the body.
struct Tet {
  ivec4 vertices{0};               ///< positively oriented
  std::array<dvec3, 4> normal;     ///< inward unit normal of the face opposite to vertex i
  std::array<double, 4> offset{};  ///< inside: dot(normal, x) + offset >= 0
  ivec4 neighbour{-1};             ///< tet across the face opposite to vertex i, -1 at the boundary
  dvec3 gradient{0};               ///< g [Pa/m]
  double constant = 0;             ///< c [Pa]: p(x) = dot(g, x) + c
  double size = 0;                 ///< longest edge: the scale of tolerances [m]
};

/// A set of faces of the skin, and the place of its worst face.
struct SkinPart {
  int faces = 0;
  double area = 0;  ///< [m^2]
  Aabb bounds;
  int worst_face = -1;   ///< index in the user's mesh, or -1
  dvec3 worst_place{0};  ///< middle of the worst face [m]
};

/// Quality of a field, displayed and tested. Stiffness is |g| at the skin, weighted by area [Pa/m].
struct FieldReport {
  int tets = 0;
  int inverted = 0;  ///< tets of negative volume before orientation, or of a fold
  int zero_gradient = 0;
  double thickness_limited_fraction = 0;  ///< fraction of the skin area with less than H
  double stiffness_cv = 0;                ///< standard deviation divided by mean
  double stiffness_mean = 0, stiffness_min = 0, stiffness_max = 0;
  double skin_area = 0;     ///< area of the mesh, with and without tets below it [m^2]
  double thickness = 0;     ///< requested H (pads) [m]
  double deepest = 0;       ///< half of the body's smallest extent, an upper bound of the depth (pads) [m]
  double least_part = 1;    ///< smallest ratio of an offset to the offset required by H
  SkinPart limited;         ///< faces with less than H; the worst one has the smallest ratio
  SkinPart bare;            ///< faces without prism; the worst one is the largest
  int two_layer_faces = 0;  ///< number of faces whose prism has two layers (pads)
  double depth_error_mean = 0, depth_error_rms = 0;  ///< error p/E - min(depth, H)/H over the pad (pad_error.h)
  int refined_faces = 0;                             ///< number of faces added by refinement of the skin (pads)
  int caps = 0;                                      ///< number of faces with a cap (pads, pad_field.h)
  /// Error of a press of a fraction of the thickness, over the skin (pads).
  struct PressError {
    double part = 0;          ///< depth of the press divided by the thickness
    double mean = 1;          ///< area-weighted mean of p H/(E d), over skin with tets at this depth
    double deviation = 0;     ///< standard deviation of p H/(E d)
    double without_tets = 0;  ///< fraction of the skin without tets at this depth (uses depth pieces)
  };
  std::vector<PressError> press_errors;
  bool core = false;  ///< the field ends on a rigid core (pads)
  std::vector<std::string> notes;
};

class PressureField {
 public:
  /// Builds the field. A face shared by two tets has one plane, negated exactly for the second tet, so no point between
  /// them is lost or counted twice. Tets of negative volume are reversed and counted in the report; `inverted` and
  /// `notes` of the report may already have values of the caller, and the rest of the report is measured here. Throws
  /// Error naming the tet or vertex if a tet has no volume, an index is out of range, a pressure is negative or not
  /// finite, or three tets share a face.
  PressureField(std::vector<dvec3> vertices, std::vector<ivec4> tets, std::vector<double> vertex_pressure,
                FieldReport report);

  [[nodiscard]] const std::vector<dvec3>& vertices() const { return vertices_; }
  [[nodiscard]] const std::vector<double>& vertex_pressure() const { return vertex_pressure_; }
  [[nodiscard]] const std::vector<Tet>& tets() const { return tets_; }
  /// Returns the gradients of all tets [Pa/m], contiguous in memory for code that needs only the gradients of scattered
  /// tets.
  [[nodiscard]] const std::vector<dvec3>& gradients() const { return gradients_; }
  [[nodiscard]] const Aabb& bounds() const { return bounds_; }
  [[nodiscard]] double max_pressure() const { return max_pressure_; }
  [[nodiscard]] double size() const { return size_; }  ///< diagonal of the bounds: the scale of tolerances [m]
  [[nodiscard]] const FieldReport& report() const { return report_; }
  /// Returns true if the face opposite to this corner is on the skin: it is at the boundary, and the pressure at its
  /// vertices is 0.
  [[nodiscard]] bool is_skin(const Tet& tet, int corner) const;
  /// Completes the report of a pad. Called only by make_pad_field(), because the errors need the finished field.
  void set_press_errors(std::vector<FieldReport::PressError> errors) { report_.press_errors = std::move(errors); }

 private:
  void measure_skin_stiffness();

  std::vector<dvec3> vertices_;
  std::vector<double> vertex_pressure_;
  std::vector<Tet> tets_;
  std::vector<dvec3> gradients_;
  Aabb bounds_;
  double max_pressure_ = 0, size_ = 0;
  FieldReport report_;
};

using PressureFieldPtr = std::shared_ptr<const PressureField>;

/// Returns a tree over the tets, with one tet per leaf.
Bvh tree_of_tets(const PressureField& field);

/// Number of layers of prisms in a pad.
enum class PadLayering {
  automatic,  ///< two layers where the skin's normals diverge (pad_field.h), otherwise one
  one,
  two  ///< two layers wherever prisms are well shaped
};

/// Builds a pad of thickness H and modulus E over a rigid core, on any closed mesh. It consists of prisms from the skin
/// inward, with three tets per prism and layer. H is limited by the local thickness of the body. `face_numbers` are the
/// user's numbers of the faces, for the report; if empty, the faces have their own numbers. `refine` is the longest
/// edge, in H, of faces whose pad would be uneven (pad_field.h); with 0 the skin is not refined. Throws Error for an
/// open mesh (naming the places), H <= 0, E <= 0 or refine < 0.
PressureFieldPtr make_pad_field(const TriMeshPtr& mesh, double modulus, double thickness,
                                const std::vector<int>& face_numbers = {},
                                PadLayering layering = PadLayering::automatic, double refine = kDefaultRefine);

/// Builds tets from the volume centroid to every face, with p = E at the centroid, as in the paper's code. Inverted
/// tets are reported.
PressureFieldPtr make_star_field(const TriMeshPtr& mesh, double modulus);

/// Builds a sphere with its medial-axis field p = E (1 - r/R) (A1 of contact.md), from an icosphere whose edges are at
/// most edge_length, scaled to the true volume.
PressureFieldPtr make_sphere_field(double radius, double modulus, double edge_length);

/// A field whose tets are parts of those of another field.
struct DividedField {
  PressureFieldPtr field;
  std::vector<int> parents;  ///< for each tet, the tet of the other field that contains it
};
/// Returns the field with the pressures E f(p/E) of `field`, E the modulus and f a table of straight pieces. Each tet
/// in which a piece ends is divided there, so the new field is linear in each tet and continuous.
DividedField divide_field(const PressureField& field, const PressureLaw& table, double modulus);

/// Returns the quality of a field in sentences for the user, for `file` and JSON pointer `pointer`, in this order:
///   note    field_report             tets, stiffness and how much it varies over the skin; of a pad also layers,
///                                    error, refined faces, caps, presses, and skin served by depth pieces
///   warning field_inverted           tets turned inside out: folds, where the pressure is counted twice
///   warning field_zero_gradient      tets without a pressure that pushes
///   warning field_thicker_than_body  a pad that no place of the body has room for
///   note    field_thickness_limited  where the body is too thin for the pad, or too bent
///   note    field_bare               faces without tets, where depth pieces serve contact
///   warning field_uneven             a pad whose stiffness varies by more than 6 %
///   note    field_note               anything else that the maker of the field said
Problems field_problems(const FieldReport& report, const std::string& file, const std::string& pointer);

// Pressure fields of MuJoCo's primitives: p = E depth/H, with H the depth of the medial axis where p = E.
// All functions throw Error if a size, the modulus or the edge length is not positive. Round ones are tessellated with
// edges of at most edge_length, and scaled to the true volume.

/// H = smallest half size. Exact.
PressureFieldPtr make_box_field(const dvec3& half_size, double modulus);
/// H = radius; the axis is a segment of z.
PressureFieldPtr make_capsule_field(double radius, double half_length, double modulus, double edge_length);
/// H = min(radius, half_length); the axis is a segment of z, or of a flat cylinder, radius > half_length, a disc.
PressureFieldPtr make_cylinder_field(double radius, double half_length, double modulus, double edge_length);
/// p = E (1 - |x/semi-axes|): not the depth, but linear from the skin to the centre.
PressureFieldPtr make_ellipsoid_field(const dvec3& semi_axes, double modulus, double edge_length);

}  // namespace taxel
