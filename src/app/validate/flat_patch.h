// A linear pressure over a flat patch, whose means are known exactly.
#pragma once

#include "core/sensor/sensor_model.h"

namespace taxel {

/// A thin plate with 7 x 7 taxels on its upper face, away from its edges. The mean of a pressure that is linear in x
/// over any disc equals the pressure at the centre.
struct FlatPatch {
  static constexpr double kHalf = 0.010, kThickness = 0.0005;  ///< half width and thickness of the plate [m]
  static constexpr double kRadius = 0.003;                     ///< radius of a taxel [m]
  static constexpr int kTaxels = 49;
  /// p = base (1 + slope x) is 0.4 to 1.6 times the base [1/m].
  static constexpr double kSlope = 0.6 / kHalf;

  /// Builds the plate with about `samples` samples in each taxel.
  static Layout layout(double samples, std::uint64_t seed, SampleWeights weights);
  static SensorModelPtr model(const Layout& layout);
};

}  // namespace taxel
