#include "core/sim/scene/scene_files.h"

#include "core/base/files.h"

namespace taxel {

void write_scene(const std::filesystem::path& xml_file, const SceneFiles& scene) {
  const std::filesystem::path folder = xml_file.parent_path();
  if (!folder.empty()) make_folder(folder);
  for (const SceneFile& file : scene.files) {
    make_folder((folder / file.name).parent_path());
    write_file_atomically(folder / file.name, file.bytes);
  }
  write_file_atomically(xml_file, scene.xml);
}

}  // namespace taxel
