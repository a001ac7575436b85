// The files that a loaded scene was made of.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/sim/scene/loaded_scene.h"

namespace taxel {

/// Beside the scene's own file: MJCF that it includes or takes models from, and what that does; meshes, height fields,
/// skins, textures; layouts that its sensors name, with their meshes. Absolute, sorted, each once. What cannot be found
/// any more is left out.
std::vector<std::string> scene_sources(const std::filesystem::path& scene, const CompiledScene& compiled);

/// The MJCF of these: named by `<include file="...">` and `<model file="...">`, as MuJoCo looks for it: beside the
/// scene first, then beside the file that names it. (mju_getXMLDependencies ends the program where a file is gone.)
/// Throws Error naming the file if a named one is a pipe, a device or a folder.
std::vector<std::filesystem::path> included_files(const std::filesystem::path& scene);

}  // namespace taxel
