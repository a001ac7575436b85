// Random poses by number: the same on every machine and in every order.
#pragma once

#include "core/base/math.h"
#include "core/base/rng.h"

namespace taxel {

/// Returns a pose whose rotation is uniform over all orientations (Shoemake 1992) and whose position is uniform in a
/// cube of half width `spread` [m].
inline Pose random_pose(std::uint64_t seed, int number, double spread) {
  const CounterRng rng(seed, static_cast<std::uint64_t>(number));
  const double u = rng.uniform(0), a = 2 * kPi * rng.uniform(1), b = 2 * kPi * rng.uniform(2);
  const double r = std::sqrt(1 - u), s = std::sqrt(u);
  const dvec3 p(2 * rng.uniform(3) - 1, 2 * rng.uniform(4) - 1, 2 * rng.uniform(5) - 1);
  return {dquat(s * std::cos(b), r * std::sin(a), r * std::cos(a), s * std::sin(b)), spread * p};
}

}  // namespace taxel
