// The sensors in a frame: those of a running simulation, or a layout at the origin.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

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

/// Returns the sensors of a frame. The pointers are valid as long as `input.frame` and `input.probe`.
std::vector<SensorView> sensor_views(const SceneInput& input);

/// Returns the centre of pressure over all polygons of a sensor, frame M [m]. Empty without contact.
std::optional<dvec3> center_of_pressure(const SensorStep& state);

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

}  // namespace taxel::ui
