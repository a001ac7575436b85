// Compiling scenes: from text with files in memory, or a user's MJCF with layouts attached to its geoms.
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
  SpecHandle spec;  ///< what `model` was compiled from
  ModelHandle model;
  std::map<std::string, SensorModelPtr> handed;  ///< to be handed over to the instances of these names
  std::vector<std::string> notes;                ///< what was made of it, and could not be
};

/// Compiles MJCF text whose files are in memory. `name` stands in errors. Throws Error with MuJoCo's reason.
CompiledScene compile_scene(const std::string& xml, const std::vector<SceneFile>& files, const std::string& name);

/// Compiles a user's scene. Each attachment adds a `taxel.sensor` on its geom, to be handed over, and takes MuJoCo's
/// own contact of the bodies it touches away where that takes away no other contact. Boxes that `cs::` fields make
/// soft, and that no other sensor is on, get one as well; other soft geoms get a `taxel.contact` (old_fields.h).
/// Attributes that MuJoCo has dropped are left out (dropped_attributes.h). Throws Error naming the file: also where two
/// layouts are attached to one geom, or one to a geom that has a sensor.
CompiledScene load_scene(const std::filesystem::path& scene, const std::vector<SceneAttachment>& attachments);

/// The scene as files that can be moved together: assets and layouts copied beside it, into `folder` where one is
/// named. Throws Error.
SceneFiles portable_scene(const CompiledScene& scene, const mjData& data, const std::string& folder = "");

}  // namespace taxel
