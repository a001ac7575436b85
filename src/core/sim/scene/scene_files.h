// A scene as text with the files it names.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace taxel {

struct SceneFile {
  std::string name;  ///< relative to the scene's folder
  std::string bytes;
};

struct SceneFiles {
  std::string xml;  ///< MJCF
  std::vector<SceneFile> files;
};

/// Writes scene.xml and its files into `folder`, which is made where it is missing. Throws Error naming the file.
void write_scene(const std::filesystem::path& folder, const SceneFiles& scene);

}  // namespace taxel
