// The recorded steps as columns of numbers, one row per step, which a timeline draws and searches. Free of MuJoCo.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace taxel {

/// A column of numbers that grows at its end and shrinks at its front: a vector whose first values can be removed at a
/// constant mean cost per value.
template <class T>
class Column {
 public:
  Column() = default;
  Column(std::vector<T> values) : all_(std::move(values)) {}  // NOLINT: implicit, as both are lists of values

  [[nodiscard]] std::size_t size() const { return all_.size() - forgotten_; }
  [[nodiscard]] bool empty() const { return size() == 0; }
  [[nodiscard]] std::size_t capacity() const { return all_.capacity(); }
  [[nodiscard]] T* data() { return all_.data() + forgotten_; }
  [[nodiscard]] const T* data() const { return all_.data() + forgotten_; }
  [[nodiscard]] T* begin() { return data(); }
  [[nodiscard]] T* end() { return data() + size(); }
  [[nodiscard]] const T* begin() const { return data(); }
  [[nodiscard]] const T* end() const { return data() + size(); }
  T& operator[](std::size_t i) { return data()[i]; }
  const T& operator[](std::size_t i) const { return data()[i]; }
  [[nodiscard]] const T& front() const { return *begin(); }
  [[nodiscard]] T& back() { return all_.back(); }
  [[nodiscard]] const T& back() const { return all_.back(); }

  void push_back(const T& value) { all_.push_back(value); }
  void append(const T* first, const T* last) { all_.insert(all_.end(), first, last); }
  void forget_front(std::size_t count) {
    forgotten_ += count;
    if (forgotten_ <= size()) return;
    all_.erase(all_.begin(), all_.begin() + static_cast<std::ptrdiff_t>(forgotten_));
    forgotten_ = 0;
  }
  void forget_back(std::size_t count) { all_.resize(all_.size() - count); }
  void clear() { all_.clear(), forgotten_ = 0; }

 private:
  std::vector<T> all_;
  std::size_t forgotten_ = 0;
};

/// The limits of the history; the limit that is reached first applies.
struct StepHistoryLimits {
  std::size_t steps = 8000;
  std::size_t bytes = std::size_t{1} << 30;
  bool operator==(const StepHistoryLimits&) const = default;
};

/// A range of steps, including its ends.
struct StepRange {
  std::uint64_t first = 0, last = 0;
  bool operator==(const StepRange&) const = default;
};

/// An event of a step; a step may have several.
enum class StepEvent : std::uint8_t {
  contact_begins = 1,
  contact_ends = 2,
  jump = 4,                 ///< a taxel jumped by more than the threshold (SensorSummary::is_jump)
  jump_at_equal_force = 8,  ///< a taxel jumped while the force was equal
  other_layout = 16,        ///< the layout differs from that of the previous step
  disagreement = 32         ///< samples and surface disagree; only with that breakpoint
};

/// A step in the timeline.
struct StepMark {
  std::uint64_t step = 0;
  double time = 0, travel = 0;  ///< [s], [m]
  std::uint8_t events = 0;      ///< sum of StepEvent values
  [[nodiscard]] bool has(StepEvent event) const { return (events & static_cast<std::uint8_t>(event)) != 0; }
  bool operator==(const StepMark&) const = default;
};

/// The summary of one sensor at one step.
struct SensorSummary {
  double force = 0;             ///< magnitude of the contact force [N]
  double area = 0;              ///< area of the contact surfaces [m^2]
  double smallest_polygon = 0;  ///< area of the smallest polygon [m^2]; 0 without polygons
  double largest_jump = 0;      ///< largest change of a reading since the previous step [its unit]
  double largest_reading = 0;   ///< largest reading of all taxels in the run so far [its unit]
  int polygons = 0;
  /// Index of the taxel with the largest relative change, as breakpoints measure it, or -1 if no taxel changed.
  int jumped_taxel = -1;
  /// Whether the change of that taxel is a jump: above Breakpoints::jump of the largest reading in the run so far. A
  /// jump of a small reading is none any more when the reading has grown, as for an explanation of the step.
  bool is_jump = false;
};

/// The columns of all recorded steps. The step number grows by one from row to row.
struct HistoryLanes {
  Column<StepMark> steps;
  std::size_t sensor_count = 0, reading_count = 0;  ///< numbers per row
  Column<SensorSummary> sensors;                    ///< rows x sensor_count
  Column<double> readings;                          ///< rows x reading_count, sensor by sensor
  /// Changes when a row is changed or removed at the end. Within one edition rows are only added, and removed at the
  /// front.
  std::uint64_t edition = 0;
  /// Largest magnitude of each reading in the rows that were removed at the front, and the number of those rows in
  /// which the reading was not 0. Empty if no row was removed.
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
  /// Returns the row of a step, or the nearest row. Needs a row.
  [[nodiscard]] std::size_t row_of(std::uint64_t step) const {
    const std::uint64_t first = steps.front().step, last = steps.back().step;
    return static_cast<std::size_t>(std::clamp(step, first, last) - first);
  }
};

/// Returns the largest magnitude of one reading (index below reading_count) in the run so far.
inline double largest_reading(const HistoryLanes& lanes, std::size_t reading) {
  double largest = reading < lanes.forgotten_largest.size() ? lanes.forgotten_largest[reading] : 0.0;
  for (std::size_t row = 0; row < lanes.rows(); ++row)
    largest = std::max(largest, std::abs(lanes.readings[row * lanes.reading_count + reading]));
  return largest;
}

/// The change of one reading from a recorded step to the next.
struct ReadingChange {
  std::size_t row = 0;           ///< row of the later step
  std::size_t reading = 0;       ///< index in the readings of a row
  double before = 0, after = 0;  ///< values in the row before and in `row` [unit of the reading]
};

/// Returns the largest change of a reading between neighbouring rows, the first one if several are as large. Empty if
/// no reading changed.
inline std::optional<ReadingChange> largest_change(const HistoryLanes& lanes) {
  std::optional<ReadingChange> largest;
  for (std::size_t row = 1; row < lanes.rows(); ++row) {
    const std::span<const double> before = lanes.readings_of(row - 1), after = lanes.readings_of(row);
    for (std::size_t k = 0; k < after.size(); ++k) {
      const double most = largest ? std::abs(largest->after - largest->before) : 0.0;
      if (std::abs(after[k] - before[k]) > most) largest = ReadingChange{row, k, before[k], after[k]};
    }
  }
  return largest;
}

/// Returns the row whose time or travel is nearest to x; the first one if several are. Needs a row.
inline std::size_t nearest_row(const HistoryLanes& lanes, double StepMark::*what, double x) {
  const auto nearer = [&](const StepMark& a, const StepMark& b) {
    return std::abs(a.*what - x) < std::abs(b.*what - x);
  };
  return static_cast<std::size_t>(std::min_element(lanes.steps.begin(), lanes.steps.end(), nearer) -
                                  lanes.steps.begin());
}

/// Returns the next step with an event after `step` (direction 1) or before it (-1), or `step` if there is none.
inline std::uint64_t next_event(const HistoryLanes& lanes, std::uint64_t step, int direction) {
  if (lanes.steps.empty()) return step;
  const auto rows = static_cast<std::ptrdiff_t>(lanes.rows());
  const auto from = static_cast<std::ptrdiff_t>(lanes.row_of(step));
  for (std::ptrdiff_t row = from + direction; row >= 0 && row < rows; row += direction)
    if (lanes.steps[static_cast<std::size_t>(row)].events != 0) return lanes.steps[static_cast<std::size_t>(row)].step;
  return step;
}

}  // namespace taxel
