// The parts of a frame: its sensors, those of a running simulation or a layout at the origin; its extent and ground;
// places of bodies, joints, geoms, sites and cameras; and the solid bodies that a ray meets.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "core/mesh/query/bvh.h"
#include "ui/scene/scene_input.h"

namespace taxel::ui {

struct SensorView {
  int index = 0;                      ///< index of the sensor
  SensorModelPtr model;               ///< model; never null
  const SensorStep* state = nullptr;  ///< state in the step; null for a layout without a simulation
  Pose X_WM;
  int selected_taxel = -1;           ///< active taxel; -1 if there is none in this sensor
  std::vector<int> selected_taxels;  ///< all selected taxels, also the active one; ascending
  std::vector<int> hidden_taxels;    ///< hidden taxels, ascending

  [[nodiscard]] bool hidden(int taxel) const {
    return std::binary_search(hidden_taxels.begin(), hidden_taxels.end(), taxel);
  }
  [[nodiscard]] bool selected(int taxel) const {
    return std::binary_search(selected_taxels.begin(), selected_taxels.end(), taxel);
  }
};

/// Returns the short name of a sensor, such as "index"; "sensor 3" if it has no name.
std::string label_of_sensor(const SimScene& scene, std::size_t sensor);

/// Returns the sensors of a frame. The pointers are valid as long as `input.frame` and `input.probe`.
std::vector<SensorView> sensor_views(const SceneInput& input);

/// Returns the centre of pressure over all polygons of a sensor, frame M [m]. Empty without contact.
std::optional<dvec3> center_of_pressure(const SensorStep& state);

/// Returns whether the coverage of a sensor is drawn: its overlay is on, and its areas are computed. The skin is then
/// opaque.
[[nodiscard]] bool shows_coverage(const SceneInput& input, const SensorModelPtr& model);

/// Returns whether the skins are opaque, which the overlays decide, or a coverage that is drawn.
[[nodiscard]] bool shows_opaque_skins(const SceneInput& input);

/// Returns spheres around the contacts of the sensors, centre and radius in the world [m]: at most `most`, the largest
/// ones.
[[nodiscard]] std::vector<glm::vec4> contact_spheres(const SceneInput& input, std::size_t most);

/// Returns the box around the sensors in the world [m].
Aabb sensor_bounds(const SceneInput& input);

/// Returns the box around everything that is drawn except planes, in the world [m].
Aabb scene_bounds(const SceneInput& input);

/// The ground of a scene: its first plane geom, or, without one, z = 0 or the lowest point of the scene if it is lower.
struct SceneGround {
  Pose X_WP;
  bool plane = false;
};
SceneGround scene_ground(const SceneInput& input);

/// Returns X_WS in the step of a frame, or nothing if the step was saved without bodies.
[[nodiscard]] std::optional<Pose> site_pose(const SimFrame& frame, const SceneSite& site);

/// Returns the frames that overlays.frames selects; geoms and sites only if their group is shown.
[[nodiscard]] std::vector<Pose> shown_frames(const SceneInput& input);

struct NamedPlace {
  const std::string* name = nullptr;  ///< name, valid as long as the input's frame
  dvec3 p_W{0};
};
/// Returns the places of the parts that overlays.labels selects, in the order of the parts. The world has no label.
[[nodiscard]] std::vector<NamedPlace> labelled_places(const SceneInput& input);

struct GeomHit {
  int geom = -1;  ///< index in scene->geoms
  double t = 0;   ///< distance along the ray [m]
};

/// Returns the first geom, except sensors, that the ray intersects. Tests every triangle of each geom whose box the ray
/// intersects.
std::optional<GeomHit> cast_geoms(const SceneInput& input, const Ray& ray_W);

/// Returns a ray in an inner frame F.
Ray in_frame(const Pose& X_WF, const Ray& ray_W);

}  // namespace taxel::ui
