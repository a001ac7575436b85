// Compiling scenes: from text with files in memory, or a user's MJCF with a layout attached to one of its geoms.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/sim/mujoco_handles.h"
#include "core/sim/scene/scene_files.h"

namespace taxel {

struct CompiledScene {
  SpecHandle spec;  ///< what `model` was compiled from
  ModelHandle model;
};

/// Compiles MJCF text whose files are in memory. `name` stands in errors. Throws Error with MuJoCo's reason.
CompiledScene compile_scene(const std::string& xml, const std::vector<SceneFile>& files, const std::string& name);

/// Compiles a user's scene. With `layout` (a file) and `geom`, a `taxel.sensor` on that geom is added, and MuJoCo's
/// own contact of the bodies it touches is excluded where that takes away no other contact. Throws Error naming the
/// file.
CompiledScene load_scene(const std::filesystem::path& scene, const std::string& layout, const std::string& geom);

/// The scene as files that can be moved together: assets and layouts copied beside scene.xml. Throws Error.
SceneFiles portable_scene(const CompiledScene& scene, const mjData& data);

}  // namespace taxel
