// Functions that read names, poses, shapes and drawn meshes of geoms from a compiled MuJoCo model.
#pragma once

#include <mujoco/mujoco.h>

#include <string>

#include "core/base/math.h"
#include "core/hydro/hydro_body.h"
#include "core/mesh/tri_mesh.h"

namespace taxel {

// MuJoCo's arrays of numbers as our vectors, and back.
inline dvec3 vec3(const mjtNum* p) {
  return {p[0], p[1], p[2]};
}
/// w x y z, as MuJoCo orders them.
inline dquat quat(const mjtNum* q) {
  return {q[0], q[1], q[2], q[3]};
}
inline void put(mjtNum* out, const dvec3& v) {
  for (int i = 0; i < 3; ++i) out[i] = v[i];
}
inline void put(mjtNum* out, const dquat& q) {
  out[0] = q.w, out[1] = q.x, out[2] = q.y, out[3] = q.z;
}

/// Returns the name of any object, or "KIND 7" for an object without a name.
std::string object_name(const mjModel& m, mjtObj type, int id, const char* kind);
/// Returns the name of a geom, or the label of a geom without a name (geom_labels.h). A model does not have the
/// classes.
std::string geom_name(const mjModel& m, int geom);
std::string body_name(const mjModel& m, int body);
/// Returns MJCF's keyword for a type of geom (mjtGeom); empty for types that scenes do not have.
std::string geom_type_word(int type);

/// Returns X_WB of a body in the state that was evaluated last.
Pose body_pose(const mjData& d, int body);

/// Returns X_WG in the state that was evaluated last, from the quaternions of body and geom. The contact is computed
/// from exactly these numbers, so a recorded pose gives the same contact again, bit for bit.
Pose geom_pose(const mjModel& m, const mjData& d, int geom);

/// Returns X_GM, the pose of the frame of the mesh file (after scaling) in the frame of the compiled geom. MuJoCo moves
/// meshes to their centre and principal axes: R(mesh_quat) v + mesh_pos = scale * file, where v is the compiled vertex.
/// Identity for a geom without a mesh. `refpos` and `refquat` of an asset are not in the model, so they must have their
/// default values.
Pose mesh_file_pose(const mjModel& m, int geom);

/// Returns the triangles of a mesh asset, in the frame of the compiled asset, cleaned as by compiled_mesh().
TriMesh mesh_triangles(const mjModel& m, int mesh);

/// Returns the triangles of a mesh geom, frame G. Vertices at the same place are welded, and faces without area are
/// dropped.
TriMesh compiled_mesh(const mjModel& m, int geom);

/// Returns the surface of a height field geom, frame G.
TriMesh height_field_mesh(const mjModel& m, int geom);

/// Returns the shape of a geom, frame G. Height fields and signed distance functions become meshes that can only be
/// rigid. The mesh of a height field is exactly the surface with which MuJoCo collides. The mesh of a signed distance
/// function is its zero level, with edges of `resolution` [m] (0 means a fortieth of the largest extent; see
/// sdf_mesh() in geometry.cpp). Throws Error naming the geom.
Shape geom_shape(const mjModel& m, int geom, double resolution = 0);

/// Returns true if two geoms collide by MuJoCo's rules, without `<exclude>` and `<pair>`: their masks match, and their
/// bodies are neither the same, nor welded together, nor parent and child (unless the parent is the world or the filter
/// is off).
bool would_collide(const mjModel& m, int a, int b);

/// Returns true if the bodies of two geoms allow a collision: the part of would_collide() without the masks.
bool can_bodies_collide(const mjModel& m, int a, int b);

/// Returns true if an `<exclude>` names the bodies of two geoms.
bool are_bodies_excluded(const mjModel& m, int a, int b);

/// Returns true if a geom can take part in collisions at all, other than in a `<pair>`.
bool can_collide(const mjModel& m, int geom);

/// Returns true if MuJoCo lets a geom of the body of `geom` touch the geom `other`: by would_collide() unless the two
/// bodies are excluded, or by a `<pair>`.
bool can_body_touch(const mjModel& m, int geom, int other);

/// Returns the triangles of a geom's surface, frame G, fine enough to appear smooth; null for a geom that is not drawn.
/// They are also compared with the mesh of a layout.
/// A signed distance function has the mesh that MuJoCo built for it.
TriMeshPtr drawn_mesh(const mjModel& m, int geom);

/// Returns the triangles of a sphere, capsule, cylinder, ellipsoid or box (mjtGeom), frame G; null for other types.
TriMeshPtr drawn_primitive(int type, const dvec3& size);

}  // namespace taxel
