// Colours of the changes by a repair. sRGB, 0 to 1.
#pragma once

#include <algorithm>
#include <glm/glm.hpp>

#include "core/mesh/repair/repair.h"
#include "ui/scene/color_map.h"

namespace taxel::ui {

inline constexpr glm::vec3 kFilledColor{0.20f, 0.74f, 0.30f}, kRemovedColor{0.90f, 0.20f, 0.16f},
    kPartedColor{0.98f, 0.82f, 0.10f};

/// The largest distance between a wrapped surface and the loaded faces [m]; 0 if nothing was wrapped.
inline double largest_distance(const RepairChanges& changes) {
  return changes.distance.empty()
             ? 0.0
             : static_cast<double>(*std::max_element(changes.distance.begin(), changes.distance.end()));
}

/// Returns the colour of a wrapped vertex at a distance [m], on a scale from 0 to `largest` [m].
inline glm::vec3 distance_color(double distance, double largest) {
  return kColorMaps.front().at(largest > 0 ? distance / largest : 0.0);
}

}  // namespace taxel::ui
