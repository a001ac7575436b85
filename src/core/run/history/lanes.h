// The recorded steps as columns of numbers, one row a step: what a timeline draws and searches. Free of MuJoCo.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "core/run/history/column.h"

namespace taxel {

/// How much is kept; what is reached first counts.
struct StepHistoryLimits {
  std::size_t steps = 2000;
  std::size_t bytes = std::size_t{1} << 30;
  bool operator==(const StepHistoryLimits&) const = default;
};

/// Steps from one to another, both of them.
struct StepRange {
  std::uint64_t first = 0, last = 0;
  bool operator==(const StepRange&) const = default;
};

/// What happened in a step; a step may have several.
enum class StepEvent : std::uint8_t {
  contact_begins = 1,
  contact_ends = 2,
  jump = 4,                 ///< a taxel jumped by more than the threshold
  jump_at_equal_force = 8,  ///< likewise while the force stayed
  other_layout = 16,        ///< read by another layout than the step before
  disagreement = 32         ///< samples and surface disagree; looked for only where it is to stop
};

/// A step in the timeline.
struct StepMark {
  std::uint64_t step = 0;
  double time = 0, travel = 0;  ///< [s], [m]
  std::uint8_t events = 0;      ///< StepEvent, added up
  [[nodiscard]] bool has(StepEvent event) const { return (events & static_cast<std::uint8_t>(event)) != 0; }
};

/// One sensor in one step.
struct SensorSummary {
  double force = 0;             ///< magnitude of the contact force [N]
  double area = 0;              ///< of the contact surfaces [m^2]
  double smallest_polygon = 0;  ///< area of the smallest polygon [m^2]; 0: there is none
  double largest_jump = 0;      ///< largest change of a reading since the step before [its unit]
  double largest_reading = 0;   ///< of all its taxels in the run so far [its unit]
  int polygons = 0;
  /// Number of the taxel that changed by the largest part of what breakpoints measure it against; -1: none changed.
  int jumped_taxel = -1;
};

/// Rows ascend by one step each.
struct HistoryLanes {
  Column<StepMark> steps;
  std::size_t sensor_count = 0, reading_count = 0;  ///< of each row
  Column<SensorSummary> sensors;                    ///< rows x sensor_count
  Column<double> readings;                          ///< rows x reading_count: all sensors, one after the other
  /// Of the history that they are of: in one edition a step's row stays as it is, new ones follow, the first are
  /// forgotten.
  std::uint64_t edition = 0;
  /// Of the rows that were forgotten because others came, by reading: the largest magnitude, and the number of rows in
  /// which it was not 0. Empty if none was forgotten.
  std::vector<double> forgotten_largest;
  std::vector<int> forgotten_touched;

  [[nodiscard]] std::size_t rows() const { return steps.size(); }
  [[nodiscard]] const SensorSummary& sensor(std::size_t row, std::size_t sensor) const {
    return sensors[row * sensor_count + sensor];
  }
  [[nodiscard]] std::span<const double> readings_of(std::size_t row) const {
    return {readings.data() + row * reading_count, reading_count};
  }
  void forget_front(std::size_t rows) {
    steps.forget_front(rows);
    sensors.forget_front(rows * sensor_count);
    readings.forget_front(rows * reading_count);
  }
  void forget_back(std::size_t rows) {
    steps.forget_back(rows);
    sensors.forget_back(rows * sensor_count);
    readings.forget_back(rows * reading_count);
  }
  /// Row of a step, or of the nearest there is. Needs a row.
  [[nodiscard]] std::size_t row_of(std::uint64_t step) const {
    const std::uint64_t first = steps.front().step, last = steps.back().step;
    return static_cast<std::size_t>(std::clamp(step, first, last) - first);
  }
};

/// The largest magnitude of one reading of a row (index below reading_count) in the run as far as it is known.
inline double largest_reading(const HistoryLanes& lanes, std::size_t reading) {
  double largest = reading < lanes.forgotten_largest.size() ? lanes.forgotten_largest[reading] : 0.0;
  for (std::size_t row = 0; row < lanes.rows(); ++row)
    largest = std::max(largest, std::abs(lanes.readings[row * lanes.reading_count + reading]));
  return largest;
}

/// Row whose time, or travel, is nearest to x; of equal ones the first. Needs a row.
inline std::size_t nearest_row(const HistoryLanes& lanes, double StepMark::*what, double x) {
  const auto nearer = [&](const StepMark& a, const StepMark& b) {
    return std::abs(a.*what - x) < std::abs(b.*what - x);
  };
  return static_cast<std::size_t>(std::min_element(lanes.steps.begin(), lanes.steps.end(), nearer) -
                                  lanes.steps.begin());
}

/// The next step after `step` (direction 1) or before it (-1) in which something happened; `step` where nothing did.
inline std::uint64_t next_event(const HistoryLanes& lanes, std::uint64_t step, int direction) {
  if (lanes.steps.empty()) return step;
  const auto rows = static_cast<std::ptrdiff_t>(lanes.rows());
  const auto from = static_cast<std::ptrdiff_t>(lanes.row_of(step));
  for (std::ptrdiff_t row = from + direction; row >= 0 && row < rows; row += direction)
    if (lanes.steps[static_cast<std::size_t>(row)].events != 0) return lanes.steps[static_cast<std::size_t>(row)].step;
  return step;
}

}  // namespace taxel
