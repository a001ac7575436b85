#include "core/hydro/intersect.h"

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/hydro/kernel/depth_march.h"
#include "core/hydro/kernel/depth_pieces.h"
#include "core/hydro/kernel/kernels.h"

namespace taxel {
namespace {

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
                      IntersectWorkspace& workspace) {
  const RigidTransform X_AB_full(X_AB);
  workspace.depth.slopes.clear();
  if (a.depth || b.depth) writer.list_core_points(workspace.depth.core_points);
  intersect_tets(*a.index, *b.index, X_AB_full, writer, workspace);
  if (!a.depth && !b.depth) return;
  if (writer.core_count() == 0 && (writer.polygon_count() > 0 || !reaches_core(*a.index, *b.index, X_AB_full))) return;
  writer.clear_core();
  const RigidTransform X_AL = frame_between(X_AB), X_BL = frame_between(X_AB.inverse());
  const PressureAt first(a.depth.get(), *a.index, X_AL), second(b.depth.get(), *b.index, X_BL);
  add_march(first, second, first, X_AL, workspace.piece_size, writer, workspace.depth);
}

/// One soft body with tets and any other. Computed in the frame S of the tets, whose trees and planes never change.
void intersect_field(const SoftBody& body, const HydroBody& other, const RigidTransform& X_SO, SurfaceWriter& writer,
                     IntersectWorkspace& workspace) {
  const FieldIndex& field = *body.index;
  if (const auto* mesh = std::get_if<RigidMesh>(&other.geometry)) {
    intersect_facets(field, *mesh->tree, X_SO, writer, workspace);
    if (!body.depth) return;
    writer.clear_core();
    add_depth_pieces(body.depth, field, *mesh->tree, X_SO, workspace.piece_size, writer, workspace.depth);
    return;
  }
  const Plane plane = ground(X_SO);
  if (const auto* soft = std::get_if<SoftHalfSpace>(&other.geometry)) {
    const LinearPressure pressure{-soft->stiffness * plane.normal, -soft->stiffness * plane.offset};
    if (body.depth) writer.list_core_points(workspace.depth.core_points);
    intersect_soft_half_space(field, pressure, writer, workspace);
    if (!body.depth || writer.core_count() == 0) return;
    writer.clear_core();
    const PressureAt space(soft->stiffness, soft->thickness, inverse(X_SO));
    const PressureAt pad(body.depth.get(), field, RigidTransform());
    add_march(space, pad, pad, RigidTransform(), workspace.piece_size, writer, workspace.depth);
  } else {
    intersect_plane(field, plane.normal, plane.offset, writer, workspace);
    if (!body.depth || writer.core_count() == 0) return;
    writer.clear_core();
    add_depth_pieces(body.depth, field, X_SO, workspace.piece_size, writer, workspace.depth);
  }
}

void finish(SurfaceWriter& writer, const HydroBody& a, const HydroBody& b, const RigidTransform& X_AB,
            std::span<const double> slopes, ContactSurface& out) {
  writer.finish();
  if (writer.any_back_face()) leave_out_back_faces(a, b, X_AB, slopes, out);
}

}  // namespace

void intersect(const HydroBody& a, const HydroBody& b, const Pose& X_WA, const Pose& X_WB, ContactSurface& out,
               IntersectWorkspace& workspace) {
  check_pair(a, b);
  check_pose(a, X_WA);
  check_pose(b, X_WB);
  const auto *field_a = std::get_if<SoftBody>(&a.geometry), *field_b = std::get_if<SoftBody>(&b.geometry);
  const RigidTransform X_AB(X_WA.inverse() * X_WB), X_BA(X_WB.inverse() * X_WA);
  // Triangles have the normal that leads into the body with tets: the surface pushes that body along it, the other one
  // against it. A rigid mesh in a soft half-space has normals that lead into the half-space.
  if (field_a != nullptr && field_b != nullptr) {
    SurfaceWriter writer(out, RigidTransform(), true, BodyOfPair::a);
    intersect_fields(*field_a, *field_b, X_WA.inverse() * X_WB, writer, workspace);
    finish(writer, a, b, X_AB, workspace.depth.slopes, out);
  } else if (field_a != nullptr) {
    SurfaceWriter writer(out, RigidTransform(), false, BodyOfPair::a);
    intersect_field(*field_a, b, X_AB, writer, workspace);
    finish(writer, a, b, X_AB, {}, out);
  } else if (field_b != nullptr) {
    SurfaceWriter writer(out, X_AB, true, BodyOfPair::b);
    intersect_field(*field_b, a, X_BA, writer, workspace);
    finish(writer, a, b, X_AB, {}, out);
  } else {
    const bool soft_is_a = a.soft();
    const auto& soft = std::get<SoftHalfSpace>((soft_is_a ? a : b).geometry);
    const auto& rigid = std::get<RigidMesh>((soft_is_a ? b : a).geometry);
    const BodyOfPair field = soft_is_a ? BodyOfPair::a : BodyOfPair::b;
    SurfaceWriter writer(out, soft_is_a ? RigidTransform() : X_AB, !soft_is_a, field);
    intersect_half_space(soft.stiffness, *rigid.tree, soft_is_a ? X_AB : X_BA, writer, workspace);
    finish(writer, a, b, X_AB, {}, out);
  }
}

}  // namespace taxel
