// The contact surface of two bodies: the kernel of the pair, depth pieces, and back faces.
//
// Each pair of shapes has its kernel in core/hydro/kernel. A kernel works in the frame of a soft body, whose trees and
// planes then never change; SurfaceWriter turns the polygons to frame A.
//
// Back faces. A plate that is thinner than its depth is inside of the field with both faces, and their pressures would
// nearly cancel. So each polygon counts by a factor of the angle between its normal and the gradient of the pressure, 1
// up to 102.7 degrees and 0 from 122.7 degrees on (front_weight()); between two soft bodies by the product of both
// factors. Pressure and gradient contain the factor, so everything that follows uses the same polygons. Polygons with
// the factor 0 are kept apart, with the reason back_face.
//
// Pitfall: the factor is applied after all polygons are made. Inside of the kernels it would break their checks, which
// compare the areas of polygons with those of facets. Theory: docs/theory/hydro.md, "Back faces".
#include "core/hydro/intersect.h"

#include <fmt/format.h>

#include <span>

#include "core/base/error.h"
#include "core/base/math.h"
#include "core/hydro/contact_surface.h"
#include "core/hydro/hydro_body.h"
#include "core/hydro/kernel/depth_march.h"
#include "core/hydro/kernel/depth_pieces.h"
#include "core/hydro/kernel/kernels.h"
#include "core/hydro/kernel/surface_writer.h"
#include "core/hydro/kernel/workspace.h"

namespace taxel {
namespace {

bool has_rule(const HydroBody& body) {
  return body.soft() && body.material.faces == FaceRule::along_gradient;
}

/// Computes the factors of the polygons of one pair.
class Weights {
 public:
  Weights(const HydroBody& a, const HydroBody& b, const RigidTransform& X_AB)
      : a_(a), b_(b), X_AB_(X_AB), both_soft_(a.soft() && b.soft()) {}

  /// `slope` is that of DepthWorkspace::slopes, or 0.
  [[nodiscard]] double of(const ContactPolygon& p, double slope) const {
    double weight = 1;
    if (has_rule(a_)) weight = front_weight(p.normal, both_soft_ ? gradient_in_a(p) : p.gradient);
    if (has_rule(b_)) weight *= front_weight(-p.normal, both_soft_ ? gradient_in_b(p, slope) : p.gradient);
    return weight;
  }

 private:
  /// The gradient of A's pressure on a polygon between two soft bodies. Polygons have that of A, unless only B has
  /// tets.
  [[nodiscard]] dvec3 gradient_in_a(const ContactPolygon& p) const {
    return a_.half_space() ? in_half_space(a_) : p.gradient;
  }
  [[nodiscard]] dvec3 gradient_in_b(const ContactPolygon& p, double slope) const {
    if (b_.half_space()) return X_AB_.R * in_half_space(b_);
    if (a_.half_space()) return p.gradient;
    if (p.tet_b >= 0) return X_AB_.R * std::get<SoftBody>(b_.geometry).field->tets()[at(p.tet_b)].gradient;
    return p.gradient - slope * p.normal;  // the normal leads to where A's pressure is the larger one
  }
  static dvec3 in_half_space(const HydroBody& body) {
    return {0, 0, -std::get<SoftHalfSpace>(body.geometry).stiffness};
  }

  const HydroBody &a_, &b_;
  const RigidTransform& X_AB_;
  bool both_soft_;
};

/// Moves polygons to the front of a surface whose later part is left out.
class Compaction {
 public:
  explicit Compaction(ContactSurface& surface) : s_(surface) {}

  /// Keeps polygon `from`, whose pressure is multiplied by `weight`.
  void keep(std::size_t from, double weight) {
    ContactPolygon polygon = s_.polygons[from];
    if (weight < 1) {
      leave_out(polygon, 1 - weight);
      polygon.weight = static_cast<float>(weight);
      polygon.pressure *= weight;
      polygon.gradient *= weight;
    }
    const std::size_t first = at(polygon.first), count = at(polygon.count);
    for (std::size_t i = 0; i < count; ++i) {
      s_.vertices[vertices_ + i] = s_.vertices[first + i];
      s_.pressure[vertices_ + i] = weight < 1 ? weight * s_.pressure[first + i] : s_.pressure[first + i];
    }
    polygon.first = static_cast<int>(vertices_);
    vertices_ += count;
    s_.polygons[polygons_++] = polygon;
  }

  void drop(std::size_t from) {
    const ContactPolygon& polygon = s_.polygons[from];
    leave_out(polygon, 1);
    s_.filtered.push_back({Rejection::back_face, static_cast<int>(s_.filtered_vertices.size()), polygon.count});
    const auto first = s_.vertices.begin() + polygon.first;
    s_.filtered_vertices.insert(s_.filtered_vertices.end(), first, first + polygon.count);
  }

  void finish() {
    s_.polygons.resize(polygons_);
    s_.vertices.resize(vertices_);
    s_.pressure.resize(vertices_);
  }

 private:
  void leave_out(const ContactPolygon& polygon, double part) {
    RejectedPolygons& rejected = s_.rejected[static_cast<std::size_t>(Rejection::back_face)];
    ++rejected.count;
    rejected.area += part * polygon.area;
    rejected.force += part * polygon.area * polygon.pressure;
  }

  ContactSurface& s_;
  std::size_t polygons_ = 0, vertices_ = 0;
};

/// Multiplies the pressure of each polygon by its factors for the soft bodies whose material asks for it, and moves
/// polygons without pressure to those that are left out, with the reason back_face. X_AB is the pose of b in a.
/// `slopes` are those of the last polygons, which two soft bodies have beyond their tets (DepthWorkspace::slopes).
void leave_out_back_faces(const HydroBody& a, const HydroBody& b, const RigidTransform& X_AB,
                          std::span<const double> slopes, ContactSurface& surface) {
  if (!has_rule(a) && !has_rule(b)) return;
  const Weights weights(a, b, X_AB);
  Compaction compaction(surface);
  const std::size_t count = surface.polygons.size(), first_slope = count - slopes.size();
  for (std::size_t i = 0; i < count; ++i) {
    const double weight = weights.of(surface.polygons[i], i < first_slope ? 0.0 : slopes[i - first_slope]);
    if (weight > 0) {
      compaction.keep(i, weight);
    } else {
      compaction.drop(i);
    }
  }
  compaction.finish();
}

void check_pose(const HydroBody& body, const Pose& X_W) {
  constexpr double kUnit = 1e-6;  // error of quaternions from single-precision files and drifting integrators
  const double length = glm::length(X_W.q);
  if (!is_finite(X_W.p) || !(std::abs(length - 1) <= kUnit))
    throw Error(fmt::format("'{}' has no valid pose: position {} {} {}, quaternion of length {}", body.name, X_W.p.x,
                            X_W.p.y, X_W.p.z, length));
}

void check_pair(const HydroBody& a, const HydroBody& b) {
  if (!a.soft() && !b.soft()) {
    throw Error(
        fmt::format("'{}' and '{}' are both rigid: a contact surface needs at least one soft body", a.name, b.name));
  }
  if (a.half_space() && b.half_space())
    throw Error(fmt::format("'{}' and '{}' are both half-spaces: their contact surface has no end", a.name, b.name));
}

/// The plane z = 0 of the frame with pose X_SR, in S: normal . x + offset.
struct Plane {
  dvec3 normal;
  double offset;
};
Plane ground(const RigidTransform& X_SR) {
  return {X_SR.R[2], -glm::dot(X_SR.R[2], X_SR.p)};
}

RigidTransform inverse(const RigidTransform& X) {
  RigidTransform out;
  out.R = glm::transpose(X.R);
  out.p = -(out.R * X.p);
  return out;
}

/// Two soft bodies with tets. The normal is that of growing pB - pA: it leads into B.
void intersect_fields(const SoftBody& a, const SoftBody& b, const Pose& X_AB, SurfaceWriter& writer,
                      KernelMemory& memory) {
  const RigidTransform X_AB_full(X_AB);
  memory.depth.slopes.clear();
  if (a.depth || b.depth) writer.list_core_points(memory.depth.core_points);
  intersect_tets(*a.index, *b.index, X_AB_full, writer, memory);
  if (!a.depth && !b.depth) return;
  if (writer.core_count() == 0 && (writer.polygon_count() > 0 || !reaches_core(*a.index, *b.index, X_AB_full))) return;
  writer.clear_core();
  const RigidTransform X_AL = frame_between(X_AB), X_BL = frame_between(X_AB.inverse());
  const PressureAt first(a.depth.get(), *a.index, X_AL), second(b.depth.get(), *b.index, X_BL);
  add_march(first, second, first, X_AL, memory.piece_size, writer, memory.depth);
}

/// One soft body with tets and any other. Computed in the frame S of the tets, whose trees and planes never change.
void intersect_field(const SoftBody& body, const HydroBody& other, const RigidTransform& X_SO, SurfaceWriter& writer,
                     KernelMemory& memory) {
  const FieldIndex& field = *body.index;
  if (const auto* mesh = std::get_if<RigidMesh>(&other.geometry)) {
    intersect_facets(field, *mesh->tree, X_SO, writer, memory);
    if (!body.depth) return;
    writer.clear_core();
    add_depth_pieces(body.depth, field, *mesh->tree, X_SO, memory.piece_size, writer, memory.depth);
    return;
  }
  const Plane plane = ground(X_SO);
  if (const auto* soft = std::get_if<SoftHalfSpace>(&other.geometry)) {
    const LinearPressure pressure{-soft->stiffness * plane.normal, -soft->stiffness * plane.offset};
    if (body.depth) writer.list_core_points(memory.depth.core_points);
    intersect_soft_half_space(field, pressure, writer, memory);
    if (!body.depth || writer.core_count() == 0) return;
    writer.clear_core();
    const PressureAt space(soft->stiffness, soft->thickness, inverse(X_SO));
    const PressureAt pad(body.depth.get(), field, RigidTransform());
    add_march(space, pad, pad, RigidTransform(), memory.piece_size, writer, memory.depth);
  } else {
    intersect_plane(field, plane.normal, plane.offset, writer, memory);
    if (!body.depth || writer.core_count() == 0) return;
    writer.clear_core();
    add_depth_pieces(body.depth, field, X_SO, memory.piece_size, writer, memory.depth);
  }
}

void finish(SurfaceWriter& writer, const HydroBody& a, const HydroBody& b, const RigidTransform& X_AB,
            std::span<const double> slopes, ContactSurface& out) {
  writer.finish();
  if (writer.back_faces().any) leave_out_back_faces(a, b, X_AB, slopes, out);
}

}  // namespace

IntersectWorkspace::IntersectWorkspace() : kernel(std::make_unique<KernelMemory>()) {}
IntersectWorkspace::~IntersectWorkspace() = default;

void intersect(const HydroBody& a, const HydroBody& b, const Pose& X_WA, const Pose& X_WB, ContactSurface& out,
               IntersectWorkspace& workspace) {
  check_pair(a, b);
  check_pose(a, X_WA);
  check_pose(b, X_WB);
  const auto *field_a = std::get_if<SoftBody>(&a.geometry), *field_b = std::get_if<SoftBody>(&b.geometry);
  KernelMemory& memory = *workspace.kernel;
  const RigidTransform X_AB(X_WA.inverse() * X_WB), X_BA(X_WB.inverse() * X_WA);
  // Triangles have the normal that leads into the body with tets: the surface pushes that body along it, the other one
  // against it. A rigid mesh in a soft half-space has normals that lead into the half-space.
  if (field_a != nullptr && field_b != nullptr) {
    SurfaceWriter writer(out, RigidTransform(), true, BodyOfPair::a);
    intersect_fields(*field_a, *field_b, X_WA.inverse() * X_WB, writer, memory);
    finish(writer, a, b, X_AB, memory.depth.slopes, out);
  } else if (field_a != nullptr) {
    SurfaceWriter writer(out, RigidTransform(), false, BodyOfPair::a);
    intersect_field(*field_a, b, X_AB, writer, memory);
    finish(writer, a, b, X_AB, {}, out);
  } else if (field_b != nullptr) {
    SurfaceWriter writer(out, X_AB, true, BodyOfPair::b);
    intersect_field(*field_b, a, X_BA, writer, memory);
    finish(writer, a, b, X_AB, {}, out);
  } else {
    const bool soft_is_a = a.soft();
    const auto& soft = std::get<SoftHalfSpace>((soft_is_a ? a : b).geometry);
    const auto& rigid = std::get<RigidMesh>((soft_is_a ? b : a).geometry);
    const BodyOfPair field = soft_is_a ? BodyOfPair::a : BodyOfPair::b;
    SurfaceWriter writer(out, soft_is_a ? RigidTransform() : X_AB, !soft_is_a, field);
    intersect_half_space(soft.stiffness, *rigid.tree, soft_is_a ? X_AB : X_BA, writer, memory);
    finish(writer, a, b, X_AB, {}, out);
  }
}

}  // namespace taxel
