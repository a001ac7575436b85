// The files of a patched scene: which included files need a copy, the paths in a scene that moves to another folder,
// and the layouts next to the scene.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/run/controls.h"
#include "core/sensor/sensor_model.h"
#include "core/sim/scene/loaded_scene.h"
#include "core/sim/scene/mjcf_source.h"

namespace taxel {

/// Returns the path from a folder to a file, with links resolved and "/" between names.
std::string path_from(const std::filesystem::path& folder, const std::filesystem::path& file);

/// Returns the texts of the scene and of the included files that need a copy next to `output`, by their names there;
/// the scene's own name is that of `output`. Changes the names in `<include>`, `<model>` and, for meshes of a URDF, in
/// `<mesh>`. `folders` are the folders of assets that the scene has: the `<compiler>` for them is the caller's.
std::map<std::string, std::string> texts_next_to(const MjcfSource& source, MjcfChanges& changes,
                                                 const std::filesystem::path& output);

/// Returns the lines of a `<compiler>` that lets a scene in the folder of `output` find its assets; empty if there is
/// nothing to find, or the folder is the same. `meshdir` and `texturedir` are those of the parsed scene.
std::vector<std::string> compiler_lines(const MjcfSource& source, const std::filesystem::path& output,
                                        const std::string& meshdir, const std::string& texturedir);

/// The layouts of a patched scene.
class LayoutFiles {
 public:
  explicit LayoutFiles(std::filesystem::path output) : output_(std::move(output)) {}

  /// Adds the layout of a model that was read from `attachment.layout`. Returns its name next to the scene: that of the
  /// file, or with the scene's name before it if another file has that name. A mesh that is in no file becomes one.
  std::string add(const SceneAttachment& attachment, const SensorModel& model, const std::string& geom);
  /// Returns the path of the mesh of the layout that was added last.
  [[nodiscard]] const std::filesystem::path& mesh() const { return mesh_; }
  /// Files that have to be written.
  [[nodiscard]] const std::vector<SceneFile>& files() const { return files_; }

 private:
  std::string put(const std::string& name, const std::string& bytes);

  std::filesystem::path output_, mesh_;
  std::vector<SceneFile> files_;
};

}  // namespace taxel
