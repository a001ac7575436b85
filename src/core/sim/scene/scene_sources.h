// The files that a loaded scene was made from.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/sim/scene/loaded_scene.h"

namespace taxel {

/// Returns the files of a scene besides its own: MJCF that the scene includes or takes models from (included_files.h),
/// meshes, height fields, skins, textures, and the layouts of its sensors with their meshes. Paths are absolute and
/// sorted, each once. Missing files are omitted. Throws Error as included_files() does.
std::vector<std::string> scene_sources(const std::filesystem::path& scene, const CompiledScene& compiled);

}  // namespace taxel
