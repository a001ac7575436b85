// The list of the files from which a scene was loaded.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/sim/scene/loaded_scene.h"

namespace taxel {

/// Returns all files of a scene except its main file: MJCF files that are included or give models (included_files.h),
/// meshes, height fields, skins, textures, and the layouts of the sensors with their meshes. Paths are absolute and
/// sorted, each once. Missing files are omitted. Throws Error as included_files() does.
std::vector<std::string> scene_sources(const std::filesystem::path& scene, const CompiledScene& compiled);

}  // namespace taxel
