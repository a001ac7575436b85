// The filters of lists about the scene: which geoms and bodies a text finds, by the names of their body, mesh, class,
// joints and sites.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/run/scene.h"

namespace taxel::ui {

/// Returns whether each word of the filter is part of one of the names, in any case. An empty filter finds everything.
[[nodiscard]] bool finds(const std::string& filter, const std::vector<std::string>& names);

/// Returns the names of a body and of its geoms, joints and sites.
[[nodiscard]] std::vector<std::string> names_of_body(const SimScene& scene, int body);

/// Returns whether a filter finds a geom: by its label, name, class and mesh, and by body, joints and sites.
[[nodiscard]] bool finds_geom(const std::string& filter, const SimScene& scene, const SceneGeom& geom);

/// Returns whether a filter finds a joint: by its own name and the names of its body.
[[nodiscard]] bool finds_joint(const std::string& filter, const SimScene& scene, const std::string& name);

/// Returns whether a filter finds an actuator: by its own name, and as the joint that it drives.
[[nodiscard]] bool finds_actuator(const std::string& filter, const SimScene& scene, const SceneActuator& actuator);

/// Returns the body of the geom that a sensor is on, or -1 for a sensor whose geom is not drawn.
[[nodiscard]] int body_of_sensor(const SimScene& scene, int sensor);

/// Returns whether a filter finds a sensor: by its name, and the names of the body of its geom.
[[nodiscard]] bool finds_sensor(const std::string& filter, const SimScene& scene, std::size_t sensor);

}  // namespace taxel::ui
