// The sensors of a picture, wherever they come from: a running simulation, or a layout alone at the origin.
#pragma once

#include <algorithm>
#include <vector>

#include "ui/scene/scene_input.h"

namespace taxel::ui {

struct SensorView {
  int index = 0;                      ///< index of the sensor
  SensorModelPtr model;               ///< never null
  const SensorStep* state = nullptr;  ///< state in the step; null for a layout without a simulation
  Pose X_WM;
  int selected_taxel = -1;           ///< the active one; -1: none, or in another sensor
  std::vector<int> selected_taxels;  ///< all of them, the active one among them; ascending
  std::vector<int> hidden_taxels;    ///< ascending

  [[nodiscard]] bool hidden(int taxel) const {
    return std::binary_search(hidden_taxels.begin(), hidden_taxels.end(), taxel);
  }
  [[nodiscard]] bool selected(int taxel) const {
    return std::binary_search(selected_taxels.begin(), selected_taxels.end(), taxel);
  }
};

/// The pointers live as long as `input.frame` and `input.probe`.
std::vector<SensorView> sensor_views(const SceneInput& input);

/// Where the contact pushes: centroid of the pressure over all polygons of a sensor, frame M. False without contact.
bool pressure_centroid(const SensorStep& state, dvec3& centroid);

/// Returns the box around the sensors in the world [m].
Aabb sensor_bounds(const SceneInput& input);

/// Returns the box around everything that is drawn except planes, in the world [m].
Aabb scene_bounds(const SceneInput& input);

/// The ground of a scene: its first plane geom, else z = 0, or lower where the scene begins lower.
struct SceneGround {
  Pose X_WP;
  bool plane = false;
};
SceneGround scene_ground(const SceneInput& input);

}  // namespace taxel::ui
