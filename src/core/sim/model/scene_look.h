// The appearance of a compiled MuJoCo model as the plain values of core/run: materials, textures, lights, sky; and the
// geoms that coincide with the skin of a sensor.
#pragma once

#include <mujoco/mujoco.h>

#include <vector>

#include "core/run/scene.h"

namespace taxel {

/// Sets the look of a scene, and the material of each of its geoms. `spec` is the source of the model, and `drawn` are
/// the numbers of scene.geoms in the model.
void add_look(const mjSpec& spec, const mjModel& m, const std::vector<int>& drawn, SimScene& scene);

/// Largest distance of a geom's surface from the skin that covers it, as a fraction of the diagonal of the skin's box.
inline constexpr double kCoveredDistance = 0.01;
/// Smallest fraction of the geom's surface that the skin has to cover.
inline constexpr double kCoveredPart = 0.9;

/// Sets SceneGeom::covered_by. A geom is covered if it is fixed to the geom of a sensor, and at least kCoveredPart of
/// its surface is within kCoveredDistance of the skin, so that both surfaces would flicker through each other. Bodies
/// have their poses in `d`; `sensor_geoms` are the geoms of scene.sensors. Cost: at most 256 nearest points on the
/// skin for each geom.
void mark_covered_geoms(const mjModel& m, const mjData& d, const std::vector<int>& drawn,
                        const std::vector<int>& sensor_geoms, SimScene& scene);

}  // namespace taxel
