#include "core/sim/scene/scene_files.h"

#include "core/base/files.h"

namespace taxel {

void write_scene(const std::filesystem::path& folder, const SceneFiles& scene) {
  make_folder(folder);
  for (const SceneFile& file : scene.files) write_file_atomically(folder / file.name, file.bytes);
  write_file_atomically(folder / "scene.xml", scene.xml);
}

}  // namespace taxel
