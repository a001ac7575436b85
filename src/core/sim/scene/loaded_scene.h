// Compilation of scenes, from text with files in memory, or from a user's MJCF file with layouts attached to its geoms;
// and the files of a compiled scene.
#pragma once

#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/run/controls.h"
#include "core/sensor/sensor_model.h"
#include "core/sim/mujoco_handles.h"
#include "core/sim/scene/scene_names.h"

namespace taxel {

struct SceneFile {
  std::string name;  ///< path relative to the scene's folder
  std::string bytes;
};

/// A scene in memory: its MJCF text and the files that the text names.
struct SceneFiles {
  std::string xml;  ///< MJCF
  std::vector<SceneFile> files;
};

/// Writes the MJCF file, and its files relative to the same folder. Creates missing folders. Throws Error naming the
/// file that cannot be written.
void write_scene(const std::filesystem::path& xml_file, const SceneFiles& scene);

struct CompiledScene {
  SpecHandle spec;  ///< editable source of `model`
  ModelHandle model;
  std::map<std::string, SensorModelPtr> handed;  ///< sensors to hand over, by name of the plugin instance
  std::map<std::string, SensorModelPtr> edited;  ///< models in place of layouts that the file declares
  SceneNames names;                              ///< names of the geoms; empty for a scene in memory
  std::vector<std::string> notes;                ///< notes on changes of the scene and on parts that are not supported
};

/// Compiles MJCF text whose files are in memory. `name` is the name in errors. Throws Error with MuJoCo's reason.
CompiledScene compile_scene(const std::string& xml, const std::vector<SceneFile>& files, const std::string& name);

/// Compiles a user's scene. Each attachment adds a `taxel.sensor` on its geom, whose model is in `handed`. MuJoCo's own
/// contact between the geom's body and a touched body is excluded if that removes no other contact. A box that a `cs::`
/// field makes soft gets a `taxel.sensor` if it has none; other soft geoms get a `taxel.contact` (old_fields.h).
/// Attributes that MuJoCo has dropped are removed (current_mjcf.h). `discardvisual` is ignored, since a skin may
/// be on a geom that is only drawn. Geoms without a name get one (scene_names.h). Attachments with `is_declared`
/// replace layouts of declared sensors; their models are in `edited`. Throws Error naming the file, also if two layouts
/// are attached to one geom, or a layout to a geom that already has a sensor.
CompiledScene load_scene(const std::filesystem::path& scene, const std::vector<SceneAttachment>& attachments);

/// Returns the scene as files that can be moved together: assets and layouts are next to the scene, or in `folder` if
/// it is not empty. Throws Error if a file cannot be read.
SceneFiles portable_scene(const CompiledScene& scene, const mjData& data, const std::string& folder = "");

/// Returns all files of a scene except its main file: MJCF files that are included or give models (mjcf_text.h),
/// meshes, height fields, skins, textures, and the layouts of the sensors with their meshes. Paths are absolute and
/// sorted, each once. Missing files are omitted. Throws Error as included_files() does.
std::vector<std::string> scene_sources(const std::filesystem::path& scene, const CompiledScene& compiled);

/// Returns the plugin keys, as MJCF, on which the size of a handed-over sensor's output and state depends: the number
/// of its taxels and, if its layout has friction that sticks, that friction.
inline std::string hosted_keys(const SensorModel& model) {
  const Material& material = model.layout.material;
  std::string keys = fmt::format(R"(<config key="taxels" value="{}"/>)", model.taxel_count());
  if (material.tangential_stiffness > 0)
    keys += fmt::format(R"(<config key="tangential_stiffness" value="{}"/><config key="bristles" value="{}"/>)",
                        material.tangential_stiffness, material.bristles);
  return keys;
}

}  // namespace taxel
