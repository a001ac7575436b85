// A linear pressure over a flat patch, of which every mean is known.
#pragma once

#include "core/sensor/sensor_model.h"

namespace taxel {

/// A thin plate with 7 x 7 taxels on its upper face, away from its edges. A pressure that is linear in x has a mean
/// over any disc that is its value at the centre.
struct FlatPatch {
  static constexpr double kHalf = 0.010, kThickness = 0.0005;  ///< of the plate [m]
  static constexpr double kRadius = 0.003;                     ///< of a taxel [m]
  static constexpr int kTaxels = 49;
  static constexpr double kSlope = 0.6 / kHalf;  ///< p = base (1 + slope x): 0.4 to 1.6 times the base [1/m]

  /// With about `samples` in each taxel.
  static Layout layout(double samples, std::uint64_t seed, SampleWeights weights);
  static SensorModelPtr model(const Layout& layout);
};

}  // namespace taxel
