// The names of a scene's geoms. Geoms without a name get one before the scene is compiled: those with an attached
// layout that of their sensor, all others their label, so that every message of MuJoCo, of the plugin and of this
// program calls them by the same name, which files and commands accept too.
#pragma once

#include <mujoco/mujoco.h>

#include <set>
#include <string>
#include <vector>

#include "core/base/text/geom_labels.h"

namespace taxel {

/// The geoms of a parsed scene, in the order of their ids.
struct SceneNames {
  std::vector<GeomParts> geoms;           ///< names as the scene has them
  std::vector<std::string> labels;        ///< geom_labels()
  std::vector<std::string> sensor_names;  ///< geom_sensor_names()
  std::vector<std::string> names;         ///< names in the compiled scene
  std::set<std::string> bodies;

  /// Returns the geom that a text names: by its name, its label, the name that it has with a sensor, its label without
  /// its class as the plugin of other programs has it, or "geom 7"; -1 if there is none.
  [[nodiscard]] int find(const std::string& text) const;
  /// Returns the name in the compiled scene of the geom that a text names, after the geom got the name of its sensor if
  /// it had none. Returns the text itself if there is no such geom.
  std::string name_for_sensor(const std::string& text);
  /// Returns mesh_geom(). Throws Error naming `file` if there is no such body, or no such mesh, or several.
  [[nodiscard]] int mesh_geom_of_body(const std::string& body, const std::string& file) const;
  /// Returns true if the compiled scene has its own name for the geom, and the file has none.
  [[nodiscard]] bool is_label(std::size_t geom) const {
    return geoms[geom].name.empty() && names[geom] == labels[geom];
  }
};

SceneNames read_scene_names(mjSpec* spec);

/// Returns the geoms in the order of their ids: bodies and geoms are in a model in the same order as in the scene,
/// depth first.
std::vector<mjsElement*> geoms_of_spec(mjSpec* spec);

/// Gives the names of the compiled scene to the geoms without one.
void name_geoms(mjSpec* spec, const SceneNames& names);
/// Takes the labels away from geoms that have no name in the file, or gives them again.
void set_labels(mjSpec* spec, const SceneNames& names, bool are_given);

}  // namespace taxel
