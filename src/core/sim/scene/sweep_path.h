// Where the sweep is at which step.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "core/sim/scene/sweep_scene.h"

namespace taxel {

/// The sweep's clock: where the mocap body is in each step, and which steps are recorded.
struct SweepPath {
  SweepScene scene;
  double steps_per_metre = 1;
  double steps_per_row = 1;
  std::uint64_t last_step = 0;

  SweepPath(SweepScene s, const SweepScenario& scenario)
      : scene(std::move(s)),
        steps_per_metre(whole(1.0 / (scenario.speed * scenario.timestep))),
        steps_per_row(whole(scenario.record_every * steps_per_metre)),
        last_step(static_cast<std::uint64_t>(std::ceil(whole(scene.distance * steps_per_metre)))) {}

  /// A number that is meant to be whole, freed of its rounding.
  static double whole(double x) {
    const double nearest = std::round(x);
    return std::abs(x - nearest) <= 1e-9 * nearest ? nearest : x;
  }
  [[nodiscard]] double travel(std::uint64_t step) const {
    return std::min(scene.distance, static_cast<double>(step) / steps_per_metre);
  }
  /// Rows that are due up to and including this step, less one.
  [[nodiscard]] double rows(std::uint64_t step) const { return std::floor(static_cast<double>(step) / steps_per_row); }
};

}  // namespace taxel
