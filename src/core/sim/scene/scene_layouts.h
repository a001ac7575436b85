// The layouts of a MuJoCo scene: of the plugin, of touch sites, and of MuJoCo's own tactile sensors; and the mesh files
// of its bodies, for layouts that are generated on many links at once.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/math.h"
#include "core/layout/file/imported_layout.h"

namespace taxel {

/// Returns the layouts of a scene and of the files that it includes. Those of the plugin are read from the text. If
/// there are <touch> or <tactile> sensors, the scene is compiled, so that classes, frames, angles and MuJoCo's own
/// shapes count: one layout for each body with touch sites, and one for each tactile sensor, with a taxel at each
/// vertex of its mesh. Positions are in the frame of the mesh file of the body's only mesh geom or of the sensor's
/// geom, otherwise in that of the body. Throws Error naming the file: it cannot be read, MuJoCo cannot compile it, or
/// there is no layout.
std::vector<ImportedLayout> read_scene_layouts(const std::filesystem::path& scene);

/// A mesh file with its scale, and the bodies that have it.
struct BodyMesh {
  std::string name;  ///< name of the mesh in the scene
  std::filesystem::path file;
  dvec3 scale{1};  ///< factors from the file to metres
  std::vector<std::string> bodies;
};

struct BodyMeshes {
  std::vector<BodyMesh> meshes;    ///< in the order of their first bodies; each file with one scale once
  std::vector<std::string> notes;  ///< sentences on bodies that are left out
};

/// Loads a scene and returns the mesh of each body in `bodies`, or of each body that has one if `bodies` is empty. If a
/// body has several meshes, only those that touch nothing (contype and conaffinity 0) count. Throws Error naming the
/// scene: it cannot be loaded, has no such body, a named body has no mesh file or several, or no body has one.
BodyMeshes read_body_meshes(const std::filesystem::path& scene, const std::vector<std::string>& bodies);

}  // namespace taxel
