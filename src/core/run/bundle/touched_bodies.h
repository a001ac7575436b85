// The bodies that sensors touch, as arrays of a saved step. core/sim/compare needs them to evaluate other models on it.
//
// Arrays: bodies (count); body<i>/name, kind ("rigid_half_space", "soft_half_space", "soft", "rigid_mesh"), field,
//   material (4: modulus, thickness, dissipation, friction)
//     soft half-space: half_space (2: stiffness, thickness)
//     rigid mesh: mesh (number of a mesh)
//     soft body: vertices (v, 3), tets (t, 4), pressure (v), core (1: has a rigid core)
//     soft body whose field continues beyond its tets: skin (number of a mesh), depth (2: thickness, E/H)
//   sensor<i>/body/... the arrays of a body, for a soft geom without taxels
//   sensor<i>/touched (t, 5: body or -1, geom, sensor, mirrored, is known), touched_names, touched_pos (t, 3),
//   touched_quat (t, 4), touched_shapes (t texts: "" for a sensor), touched_sizes (t, 3), touched_meshes (t)
#pragma once

#include "core/run/bundle/bundle_arrays.h"
#include "core/run/frame.h"

namespace taxel {

/// Writes one body as arrays whose names begin with `prefix`.
void write_body(const HydroBody& body, const std::string& prefix, BundledMeshes& meshes, NpzWriter& out);
/// Reads the body that write_body() wrote. Throws Error naming file and array if its kind or field is unknown or an
/// array is not valid.
HydroBodyPtr read_body(const NpzReader& in, const std::string& prefix, const std::vector<TriMeshPtr>& meshes);

/// Writes the bodies that the sensors of a scene touch.
void write_touched(const SimScene& scene, BundledMeshes& meshes, NpzWriter& out);
/// Reads scene.touched, which remains empty if the file is of a version without these arrays. `scene` must have its
/// geoms and sensors.
void read_touched(const NpzReader& in, const std::vector<TriMeshPtr>& meshes, SimScene& scene);

}  // namespace taxel
