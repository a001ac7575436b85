// A scene with sensors attached to its geoms, as a patch of the files on disk. mj_saveXML prints a model again, without
// comments, includes and defaults; a patch keeps every byte of the scene and adds only the text that the sensors need.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/run/controls.h"
#include "core/sim/scene/loaded_scene.h"

namespace taxel {

/// A sensor that a patch has added.
struct PatchedSensor {
  std::string geom;    ///< name of the geom, which the patch may have given
  std::string body;    ///< name of the geom's body
  std::string sensor;  ///< name of the entry under `<sensor>`
  std::string layout;  ///< layout file, relative to the folder of the patched scene
  int taxels = 0;      ///< number of taxels
};

struct PatchedScene {
  SceneFiles scene;  ///< the MJCF text, and the files that have to be written next to it: write_scene()
  std::vector<PatchedSensor> sensors;
  std::vector<std::string> notes;  ///< changes of the text other than the additions at its end
};

/// Returns the text of the scene file with the additions for its attached sensors, to be written as `output`:
/// - at the end of the file an instance of `taxel.sensor` and an entry under `<sensor>` for each attachment;
/// - names of the sensors' geoms that have none: that of the body;
/// - contype and conaffinity 0 of these geoms and of those that lie within the skins, whose bits the instance gets;
/// - `<exclude>` if the attachment names the touched geoms;
/// - the key `layout` of the declared sensors in `attached.edited` whose layouts differ from the declared ones;
/// - paths, if `output` is in another folder: a `<compiler>` with meshdir and texturedir, and names of included files.
/// All else keeps its bytes. An included file that needs a change becomes a file next to `output`. The layouts of
/// `attached.handed` and `attached.edited` are written next to `output`, except those that are there already with the
/// same content, and declared ones that are unchanged. No file of the scene that was loaded changes.
///
/// `attached` is the result of load_scene() with the same scene and attachments; its models in `handed` may have been
/// replaced by newer ones. The patch is compiled, and compared with `attached`. Throws Error naming the scene and the
/// reason if no patch gives the same model: a geom that is made by `<replicate>`, `<composite>` or `<attach>` needs a
/// change, the scene has fields `cs::`, or MuJoCo refuses the text.
PatchedScene patched_scene(const std::filesystem::path& scene, const std::vector<SceneAttachment>& attachments,
                           const CompiledScene& attached, const std::filesystem::path& output);

/// Returns the files of a scene, by path, that change if its sensors on `geoms` read the layout `file`, which exists,
/// instead of the ones that they declare. All else keeps its bytes. The changed scene is compiled. Throws Error naming
/// the scene and the reason, as if a sensor is made by `<replicate>` or `<attach>`.
std::map<std::filesystem::path, std::string> with_layout_file(const std::filesystem::path& scene,
                                                              const std::vector<std::string>& geoms,
                                                              const std::filesystem::path& file);

}  // namespace taxel
