// One step of a simulation as a file: with its scene, its layouts and their meshes, so that it opens on another machine
// and shows the same numbers, bit for bit. `*.taxelframe`, an archive that NumPy opens (numpy.load).
//
// Arrays, SI units, quaternions w x y z, world frame unless said otherwise:
//   format "taxel-frame", version (1), title, step, time, travel, timestep, duration
//   geom_names, geom_bodies (g texts); geom_rgba (g, 4), geom_plane, geom_sensor, geom_mesh (g: number of a mesh),
//   geom_pos (g, 3), geom_quat (g, 4); meshes (count); mesh<i>/vertices (n, 3), mesh<i>/faces (m, 3)
//   path (p, 3); sensor_geoms (s texts)
//   sensor<i>/layout (JSON text), mesh (number), quality, pos, quat, force, uncovered, readings,
//   shear (taxels, 2: along e1 and e2; where the layout asks for it)
//   sensor<i>/rays (count), hit_rays (h), hit_surface_polygon (h, 2), hit_depth_pressure (h, 2): of the rays that hit
//   sensor<i>/surfaces (count); sensor<i>/surface<k>/... in the frame of the mesh file: vertices (v, 3), pressure (v),
//   polygons (p, 5: first, count, tet, tet_b, face), planes (p, 11: normal, area, centroid, pressure, gradient),
//   rejected (reasons, 3: count, area, force), filtered (f, 3: reason, first, count), filtered_vertices (w, 3)
//   what the sensors touch: touched_bodies.h
// and beside them the files picture.png and state.json, where the caller has them.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "core/run/frame.h"
#include "core/run/recording/npz.h"

namespace taxel {

inline constexpr const char* kFrameBundleExtension = ".taxelframe";

/// Files for people, beside the arrays: name and bytes.
using BundledFiles = std::vector<std::pair<std::string, std::string>>;

/// The archive's bytes. Needs a scene. Throws Error when the archive cannot be made.
std::string frame_to_bundle(const SimFrame& frame, const BundledFiles& files = {});

/// The frame again, paused, with a history of this one step. Layouts are compiled anew. Throws Error naming file and
/// array for what is missing, of another shape or out of range, and for samples that this version makes in another
/// number; Cancelled through `how.progress`.
SimFramePtr read_frame_bundle(const std::filesystem::path& path, const SensorBuild& how = {});
/// The same of an archive that is open.
SimFramePtr read_frame_bundle(const NpzReader& in, const SensorBuild& how = {});

}  // namespace taxel
