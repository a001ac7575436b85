// What a compiled MuJoCo model says about its geoms: names, poses, shapes.
#pragma once

#include <mujoco/mujoco.h>

#include <string>

#include "core/base/math.h"
#include "core/hydro/hydro_body.h"
#include "core/mesh/tri_mesh.h"

namespace taxel {

/// The name of any object, or "KIND 7" for one without.
std::string object_name(const mjModel& m, mjtObj type, int id, const char* kind);
/// The geom's name, or "geom 7" for one without.
std::string geom_name(const mjModel& m, int geom);
std::string body_name(const mjModel& m, int body);

/// X_WB of a body in the state last evaluated.
Pose body_pose(const mjData& d, int body);

/// X_WG in the state last evaluated, from the quaternions of body and geom. The contact is computed from exactly these
/// numbers, so whoever records them can compute it again, bit for bit.
Pose geom_pose(const mjModel& m, const mjData& d, int geom);

/// X_GM: from the frame of the mesh file (after scaling) to that of the compiled geom. MuJoCo moves meshes to their
/// centre and principal axes: R(mesh_quat) v + mesh_pos = scale * file, v being the compiled vertex. Identity for a
/// geom without a mesh. `refpos` and `refquat` of an asset are not in the model and must be left at their defaults.
Pose mesh_file_pose(const mjModel& m, int geom);

/// The triangles of a mesh asset, in the frame that it was compiled to; as compiled_mesh().
TriMesh mesh_triangles(const mjModel& m, int mesh);

/// The triangles of a mesh geom, frame G; vertices at one place welded, faces without area dropped.
TriMesh compiled_mesh(const mjModel& m, int geom);

/// The surface of a height field geom, frame G.
TriMesh height_field_mesh(const mjModel& m, int geom);

/// The shape of a geom, frame G. Height fields and signed distance functions become meshes that can only be rigid:
/// the former exactly what MuJoCo collides with, the latter where the function of the geom's plugin is zero, with edges
/// of `resolution` (0: a fortieth of the largest extent; see sdf_mesh.h). Throws Error naming the geom.
Shape geom_shape(const mjModel& m, int geom, double resolution = 0);

/// MuJoCo's own rules of which geoms collide, but for `<exclude>` and `<pair>`: masks meet; not one body, not welded
/// together, not parent and child (unless the parent is the world or the filter is off).
bool would_collide(const mjModel& m, int a, int b);

}  // namespace taxel
