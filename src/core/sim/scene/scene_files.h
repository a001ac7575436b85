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

/// Writes the MJCF file and, beside it, its files; folders are made where they are missing. Throws Error naming the
/// file.
void write_scene(const std::filesystem::path& xml_file, const SceneFiles& scene);

}  // namespace taxel
