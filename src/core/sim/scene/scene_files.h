// A scene in memory: its MJCF text and the files that the text names.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace taxel {

struct SceneFile {
  std::string name;  ///< path relative to the scene's folder
  std::string bytes;
};

struct SceneFiles {
  std::string xml;  ///< MJCF
  std::vector<SceneFile> files;
};

/// Writes the MJCF file, and its files relative to the same folder. Creates missing folders. Throws Error naming the
/// file that cannot be written.
void write_scene(const std::filesystem::path& xml_file, const SceneFiles& scene);

}  // namespace taxel
