// The readings of a run so far, as plots and bars need them. Free of MuJoCo.
#pragma once

#include <cstdint>
#include <vector>

#include "core/sensor/sensor_model.h"

namespace taxel {

/// A taxel's values of the past, one entry per recorded row (every 0.1 mm in a sweep, every step otherwise).
struct TraceRow {
  double time = 0, travel = 0;   ///< [s], [m]
  std::vector<double> readings;  ///< all sensors, one after the other
  /// preview: some of them are of samples that were replaced since.
  SampleQuality quality = SampleQuality::polished;
};

/// All rows of a run so far.
struct Trace {
  std::vector<TraceRow> rows;
  /// Copies of one trace have the same until rows are taken away from it: of those, the longer goes on where the
  /// shorter ends.
  std::uint64_t edition = 0;
};

}  // namespace taxel
