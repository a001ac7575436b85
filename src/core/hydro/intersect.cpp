#include "core/hydro/intersect.h"

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/hydro/clip.h"
#include "core/hydro/surface_builder.h"
#include "core/hydro/triangle_probe.h"

namespace taxel {
namespace {

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

/// Boxes are widened by this part of the body's size: rounding in a pose must not lose what the exact test would keep.
constexpr double kBoxSlack = 1e-12;

/// Half extents of the box that holds a turned box: |R| h.
dvec3 turned_half_extent(const dmat3& R, const dvec3& h) {
  return glm::abs(R[0]) * h.x + glm::abs(R[1]) * h.y + glm::abs(R[2]) * h.z;
}

/// Whether a box in frame B reaches into `other`, given in frame A.
bool box_meets(const Aabb& box_B, const RigidTransform& X_AB, const Aabb& other, double slack) {
  const dvec3 center = X_AB(box_B.center());
  const dvec3 h = turned_half_extent(X_AB.R, 0.5 * box_B.extent()) + slack;
  return Aabb{center - h, center + h}.overlaps(other);
}

/// Whether an edge of the polygon lies in a face of the tet that belongs to a pad's rigid core.
bool ends_at_core(const PressureField& field, const Tet& tet, const ClippedPolygon& polygon) {
  if (!field.report().core) return false;
  constexpr double kOnPlane = 1e-9;  // of the tet's size
  for (int i = 0; i < 4; ++i) {
    if ((polygon.cut_by & (1u << i)) == 0 || tet.neighbour[i] >= 0 || field.is_skin(tet, i)) continue;
    const auto on_face = std::count_if(polygon.span().begin(), polygon.span().end(), [&](const dvec3& x) {
      return std::abs(glm::dot(tet.normal[at(i)], x) + tet.offset[at(i)]) <= kOnPlane * tet.size;
    });
    if (on_face >= 2) return true;
  }
  return false;
}

/// Soft tets (frame S) against the triangles of a rigid mesh (frame R).
void intersect_mesh(const PressureField& field, const MeshIndex& rigid, const RigidTransform& X_SR,
                    SurfaceBuilder& builder, IntersectWorkspace& workspace) {
  const double slack = kBoxSlack * (field.size() + rigid.mesh().bounds().diagonal() + glm::length(X_SR.p));
  workspace.faces.clear();
  rigid.bvh().visit([&](const Aabb& box) { return box_meets(box, X_SR, field.bounds(), slack); },
                    [&](int face) { workspace.faces.push_back(face); });
  std::sort(workspace.faces.begin(), workspace.faces.end());
  ClippedPolygon polygon;
  for (const int face : workspace.faces) {
    const TriMesh& mesh = rigid.mesh();
    const Triangle triangle{X_SR(mesh.vertex(face, 0)), X_SR(mesh.vertex(face, 1)), X_SR(mesh.vertex(face, 2))};
    const dvec3 normal = X_SR.R * mesh.face_normals()[at(face)];
    const TriangleProbe probe(triangle, normal, slack);
    field.bvh().visit(
        [&](const Aabb& box) { return probe.may_meet(box); },
        [&](int index) {
          const Tet& tet = field.tets()[at(index)];
          clip_triangle(triangle, tet, index, polygon);
          if (builder.add(polygon.span(), normal, {tet.gradient, tet.constant}, {index, face, tet.size}) &&
              ends_at_core(field, tet, polygon))
            builder.count_at_core();
        });
  }
}

/// Soft tets (frame S) against the rigid half-space z <= 0 of frame R.
void intersect_plane(const PressureField& field, const RigidTransform& X_SR, SurfaceBuilder& builder) {
  const dvec3 normal = X_SR.R[2];
  const double offset = -glm::dot(normal, X_SR.p);
  const double slack = kBoxSlack * (field.size() + glm::length(X_SR.p));
  const auto straddles = [&](const Aabb& box) {
    return std::abs(glm::dot(normal, box.center()) + offset) <= glm::dot(glm::abs(normal), 0.5 * box.extent()) + slack;
  };
  ClippedPolygon polygon;
  field.bvh().visit(straddles, [&](int index) {
    const Tet& tet = field.tets()[at(index)];
    std::array<dvec3, 4> corners;
    std::array<double, 4> distances;
    for (std::size_t i = 0; i < 4; ++i) {
      corners[i] = field.vertices()[at(tet.vertices[static_cast<int>(i)])];
      distances[i] = glm::dot(normal, corners[i]) + offset;
    }
    slice_tet(corners, tet.vertices, distances, polygon);
    if (builder.add(polygon.span(), normal, {tet.gradient, tet.constant}, {index, -1, tet.size}) &&
        ends_at_core(field, tet, polygon))
      builder.count_at_core();
  });
}

/// The soft half-space z <= 0 of frame S against the triangles of a rigid mesh (frame R).
void intersect_soft_half_space(const SoftHalfSpace& soft, const MeshIndex& rigid, const RigidTransform& X_SR,
                               SurfaceBuilder& builder, IntersectWorkspace& workspace) {
  const TriMesh& mesh = rigid.mesh();
  const double slack = kBoxSlack * (mesh.bounds().diagonal() + glm::length(X_SR.p));
  const auto reaches_below = [&](const Aabb& box) {
    return X_SR(box.center()).z - turned_half_extent(X_SR.R, 0.5 * box.extent()).z <= slack;
  };
  workspace.faces.clear();
  rigid.bvh().visit(reaches_below, [&](int face) { workspace.faces.push_back(face); });
  std::sort(workspace.faces.begin(), workspace.faces.end());
  const LinearPressure pressure{{0, 0, -soft.stiffness}, 0};
  ClippedPolygon polygon;
  for (const int face : workspace.faces) {
    const Triangle triangle{X_SR(mesh.vertex(face, 0)), X_SR(mesh.vertex(face, 1)), X_SR(mesh.vertex(face, 2))};
    clip_triangle_by_plane(triangle, {triangle[0].z, triangle[1].z, triangle[2].z}, polygon);
    const double size = std::sqrt(2.0 * mesh.face_areas()[at(face)]);
    builder.add(polygon.span(), X_SR.R * mesh.face_normals()[at(face)], pressure, {-1, face, size});
  }
}

void check_pair(const HydroBody& a, const HydroBody& b) {
  if (a.soft() == b.soft()) {
    throw Error(fmt::format("'{}' and '{}' are both {}: a contact surface needs one soft and one rigid body", a.name,
                            b.name, a.soft() ? "soft" : "rigid"));
  }
  if (a.half_space() && b.half_space())
    throw Error(fmt::format("'{}' and '{}' are both half-spaces: their contact surface has no end", a.name, b.name));
}

}  // namespace

void intersect(const HydroBody& a, const HydroBody& b, const Pose& X_WA, const Pose& X_WB, ContactSurface& out,
               IntersectWorkspace& workspace) {
  check_pair(a, b);
  const bool soft_is_a = a.soft();
  const HydroBody& soft = soft_is_a ? a : b;
  const HydroBody& rigid = soft_is_a ? b : a;
  const Pose& X_WS = soft_is_a ? X_WA : X_WB;
  const Pose& X_WR = soft_is_a ? X_WB : X_WA;
  // Everything is computed in the frame S of the soft body, whose tree and planes never change.
  const RigidTransform X_SR(X_WS.inverse() * X_WR);
  const RigidTransform X_AS = soft_is_a ? RigidTransform() : RigidTransform(X_WR.inverse() * X_WS);
  SurfaceBuilder builder(out, X_AS, soft_is_a);
  const auto* rigid_mesh = std::get_if<RigidMesh>(&rigid.geometry);
  if (const auto* half_space = std::get_if<SoftHalfSpace>(&soft.geometry)) {
    intersect_soft_half_space(*half_space, *rigid_mesh->index, X_SR, builder, workspace);
    return;
  }
  const PressureField& field = *std::get<SoftBody>(soft.geometry).field;
  if (rigid_mesh != nullptr) {
    intersect_mesh(field, *rigid_mesh->index, X_SR, builder, workspace);
  } else {
    intersect_plane(field, X_SR, builder);
  }
}

}  // namespace taxel
