// The readings of a run, for plots and bars. Free of MuJoCo.
#pragma once

#include <cstdint>
#include <vector>

#include "core/sensor/sensor_model.h"

namespace taxel {

/// The readings of one recorded row. A sweep has a row for every 0.1 mm, other runs have one for every step.
struct TraceRow {
  double time = 0, travel = 0;   ///< [s], [m]
  std::vector<double> readings;  ///< readings of all sensors, one sensor after the other
  /// Quality of the samples; preview if any sensor used preview samples, which are replaced later.
  SampleQuality quality = SampleQuality::polished;
  /// Magnitude of each taxel's shear, parallel to `readings`; 0 for sensors without shear, empty if no sensor has it.
  std::vector<double> shear = {};
  /// Share of each field that slips, 0 to 1, parallel to `readings`; 0 for sensors whose friction does not stick,
  /// empty if none does.
  std::vector<double> slip = {};
};

/// All rows of a run so far.
struct Trace {
  std::vector<TraceRow> rows;
  /// Changes when rows are removed. Of two copies with the same edition, the longer one continues the shorter one.
  std::uint64_t edition = 0;
};

}  // namespace taxel
