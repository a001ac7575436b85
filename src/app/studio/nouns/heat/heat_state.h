// The heat map of readings: its rows, its cells of taxel and time with their colours, its option, and the map as it was
// drawn.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/studio/frame/feature.h"
#include "app/studio/frame/sensors_shown.h"
#include "core/run/history/lanes.h"
#include "ui/widgets/ui.h"

namespace taxel::ui {

/// A row of the heat map: a taxel.
struct HeatRow {
  TaxelKey key;
  std::string label;
  std::size_t sensor = 0;   ///< index among the displayed sensors
  std::size_t reading = 0;  ///< index in a row of recorded steps
};

/// Returns the rows, sensor by sensor. With `responding_only` a taxel is left out if its largest recorded reading is
/// not above kTaxelResponds of the largest one of all taxels with its unit, unless the taxel is selected.
[[nodiscard]] std::vector<HeatRow> heat_rows(const HistoryLanes& lanes, const std::vector<SensorShown>& sensors,
                                             const Selection& selection, bool responding_only);

/// The places of the rows from top to bottom, with a gap between sensors [pixels].
struct HeatPlaces {
  std::vector<float> tops, heights;  ///< upper end and height of each row
  float row = 0;                     ///< least height of a row
  float height = 0;                  ///< height of all rows

  /// Returns the row at a height, or empty in a gap and outside.
  [[nodiscard]] std::optional<std::size_t> row_at(float y) const;
};

/// Divides `height` among the rows. A row is between `least` and `most` pixels high. The rows of a sensor fill at least
/// `name`, so that names do not overlap. All rows together may be higher than `height`.
[[nodiscard]] HeatPlaces place_rows(const std::vector<HeatRow>& rows, float height, float least, float most, float gap,
                                    float name = 0);

/// The cells: rows x columns. A column has one recorded step or several.
struct HeatCells {
  std::size_t columns = 0;
  std::vector<std::uint32_t> steps;  ///< rows x columns: row of the recorded steps with the cell's largest reading

  [[nodiscard]] std::size_t step(std::size_t row, std::size_t column) const { return steps[row * columns + column]; }
};

/// Returns the cells of at most `columns` columns. The reading of a cell is the largest one in its steps, so that a
/// short spike is visible. Needs a recorded step.
[[nodiscard]] HeatCells heat_cells(const HistoryLanes& lanes, const std::vector<HeatRow>& rows, std::size_t columns);

inline constexpr int kHeatLevels = 96;  ///< number of colours above the lowest one

/// Returns the colour level of a reading: 0 up to range.lo, otherwise 1 to kHeatLevels.
[[nodiscard]] int heat_level(const PressureRange& range, double reading);

/// A rectangle of one colour: columns [first, last) of a row.
struct HeatRun {
  std::size_t row = 0, first = 0, last = 0;
  int level = 0;
};

/// Returns the cells whose level is above 0, joined along the rows. `ranges` are parallel to the displayed sensors.
[[nodiscard]] std::vector<HeatRun> heat_runs(const HistoryLanes& lanes, const std::vector<HeatRow>& rows,
                                             const HeatCells& cells, const std::vector<PressureRange>& ranges);

/// The cell under the pointer.
struct HeatHover {
  TaxelKey key;
  std::string label;
  std::uint64_t step = 0;  ///< recorded step that the cell shows
  double time = 0;         ///< time of the step [s]
  double reading = 0;      ///< in SI units
};

/// The heat map as it was drawn in the last frame; empty if the panel is closed.
struct HeatShown {
  std::vector<HeatRow> rows;
  HeatPlaces places;
  std::size_t columns = 0, runs = 0;  ///< number of columns, and of drawn rectangles
  std::uint64_t first_step = 0, last_step = 0;
  Rect cells;  ///< the visible cells [pixels]
  std::optional<HeatHover> hover;
};

struct HeatState {
  bool responding_only = true;
  HeatShown shown;
};

/// The panel that draws readings as colours over taxels and time.
extern const Feature kHeatMap;
/// Sets "heat": the rows, their place, and the cell under the pointer.
void dump_heat_map(const App& app, nlohmann::ordered_json& state);

}  // namespace taxel::ui
