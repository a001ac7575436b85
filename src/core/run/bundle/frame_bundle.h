// Files of one saved step (`*.taxelframe`): the step with its scene, its layouts and their meshes. On another machine
// the file gives the same numbers, bit for bit. The file is an archive that NumPy opens (numpy.load).
//
// Arrays, SI units, quaternions w x y z, world frame unless said otherwise:
//   format "taxel-frame", version (1), title, step, time, travel, timestep, duration
//   geom_names, geom_bodies (g texts); geom_rgba (g, 4), geom_plane, geom_sensor, geom_mesh (g: number of a mesh),
//   geom_pos (g, 3), geom_quat (g, 4); meshes (count); mesh<i>/vertices (n, 3), mesh<i>/faces (m, 3)
//   path (p, 3); sensor_geoms (s texts)
//   sensor<i>/layout (JSON text), mesh (number), quality, pos, quat, force, uncovered, readings,
//   shear (taxels, 2: along e1 and e2; only if the layout has shear readings),
//   slip (taxels; only if friction sticks)
//   sensor<i>/sticking<k> (roots, 12; only if friction sticks), for each surface: place and normal of a root, the area
//   that it bears, its traction, 1 if it slips, and the length of the shares, which is the same for all
//   sensor<i>/rays (count), hit_rays (h), hit_surface_polygon (h, 2), hit_depth_pressure (h, 2): the h rays that hit
//   sensor<i>/surfaces (count); sensor<i>/surface<k>/... in the frame of the mesh file: vertices (v, 3), pressure (v),
//   polygons (p, 5: first, count, tet, tet_b, face), planes (p, 11: normal, area, centroid, pressure, gradient),
//   rejected (reasons, 3: count, area, force), filtered (f, 3: reason, first, count), filtered_vertices (w, 3)
//   arrays of the bodies that the sensors touch: see touched_bodies.h
// The archive also has the files picture.png and state.json if the caller gives them.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "core/run/frame.h"
#include "core/run/recording/recording_files.h"

namespace taxel {

inline constexpr const char* kFrameBundleExtension = ".taxelframe";

/// Files for people, stored in addition to the arrays: name and bytes.
using BundledFiles = std::vector<std::pair<std::string, std::string>>;

/// Returns the bytes of the archive. `frame` must have a scene. Throws Error if the archive cannot be made.
std::string frame_to_bundle(const SimFrame& frame, const BundledFiles& files = {});

/// Reads a saved step. The frame is paused and its history has this one step; the layouts are compiled again. Throws
/// Error naming file and array if an array is missing, has another shape or a value out of range, or if this version
/// makes another number of samples; throws Cancelled if `how.progress` is cancelled.
SimFramePtr read_frame_bundle(const std::filesystem::path& path, const SensorBuild& how = {});
/// Reads a saved step from an open archive. Throws as above.
SimFramePtr read_frame_bundle(const NpzReader& in, const SensorBuild& how = {});

}  // namespace taxel
