// The bodies that sensors touch, as arrays of a saved step: what other models need to read it (core/sim/compare).
//
// Arrays: bodies (count); body<i>/name, kind ("rigid_half_space", "soft_half_space", "soft", "rigid_mesh"), field,
//   material (4: modulus, thickness, dissipation, friction); of a soft half-space half_space (2: stiffness, thickness),
//   of a rigid mesh mesh (number), of a soft body vertices (v, 3), tets (t, 4), pressure (v), core (1: ends on a rigid
//   core), of one that goes on beyond its tets skin (number of a mesh), depth (2: thickness, E/H)
//   sensor<i>/body/... the same arrays, for a soft geom without taxels
//   sensor<i>/touched (t, 5: body or -1, geom, sensor, mirrored, is known), touched_names, touched_pos (t, 3),
//   touched_quat (t, 4), touched_shapes (t texts: "" where it is a sensor), touched_sizes (t, 3), touched_meshes (t)
#pragma once

#include "core/run/bundle/bundle_arrays.h"
#include "core/run/frame.h"

namespace taxel {

/// One body under a prefix.
void write_body(const HydroBody& body, const std::string& prefix, BundledMeshes& meshes, NpzWriter& out);
HydroBodyPtr read_body(const NpzReader& in, const std::string& prefix, const std::vector<TriMeshPtr>& meshes);

void write_touched(const SimScene& scene, BundledMeshes& meshes, NpzWriter& out);
/// Fills scene.touched, which stays empty where the file's version did not write them. `scene` has its geoms and
/// sensors.
void read_touched(const NpzReader& in, const std::vector<TriMeshPtr>& meshes, SimScene& scene);

}  // namespace taxel
