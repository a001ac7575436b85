// Compilation of scenes, from text with files in memory, or from a user's MJCF file with layouts attached to its geoms.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/run/controls.h"
#include "core/sensor/sensor_model.h"
#include "core/sim/mujoco_handles.h"
#include "core/sim/scene/scene_files.h"

namespace taxel {

struct CompiledScene {
  SpecHandle spec;  ///< editable source of `model`
  ModelHandle model;
  std::map<std::string, SensorModelPtr> handed;  ///< sensors to hand over, by name of the plugin instance
  std::vector<std::string> notes;                ///< notes on changes of the scene and on parts that are not supported
};

/// Compiles MJCF text whose files are in memory. `name` is the name in errors. Throws Error with MuJoCo's reason.
CompiledScene compile_scene(const std::string& xml, const std::vector<SceneFile>& files, const std::string& name);

/// Compiles a user's scene. Each attachment adds a `taxel.sensor` on its geom, whose model is in `handed`. MuJoCo's own
/// contact between the geom's body and a touched body is excluded if that removes no other contact. A box that a `cs::`
/// field makes soft gets a `taxel.sensor` if it has none; other soft geoms get a `taxel.contact` (old_fields.h).
/// Attributes that MuJoCo has dropped are removed (dropped_attributes.h). `discardvisual` is ignored, since a skin may
/// be on a geom that is only drawn. Throws Error naming the file, also if two layouts are attached to one geom, or a
/// layout to a geom that already has a sensor.
CompiledScene load_scene(const std::filesystem::path& scene, const std::vector<SceneAttachment>& attachments);

/// Returns the scene as files that can be moved together: assets and layouts are next to the scene, or in `folder` if
/// it is not empty. Throws Error if a file cannot be read.
SceneFiles portable_scene(const CompiledScene& scene, const mjData& data, const std::string& folder = "");

}  // namespace taxel
