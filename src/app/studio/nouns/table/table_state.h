// The state of the table of taxels: the filter, the order of the rows, and the cell in edit.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/studio/frame/feature.h"
#include "app/studio/frame/sensors_shown.h"

namespace taxel::ui {

enum class TableColumn : std::uint8_t { id, name, x, y, z, nx, ny, nz, radius, samples, reading, sensor, shear, slip };

struct TableCell {
  int id = 0;
  TableColumn column = TableColumn::name;
  bool begins = true;               ///< whether the field does not have the keyboard yet
  std::optional<bool> leaves_back;  ///< whether Tab leaves the cell to the left; empty without Tab
};

/// A row of the table of several sensors.
struct SensorRow {
  std::size_t sensor = 0;  ///< index among the displayed sensors
  std::size_t taxel = 0;   ///< index in the layout of the sensor
  bool operator==(const SensorRow&) const = default;
};

/// A line of the table of several sensors in their order: the heading of a sensor, or a row.
struct SensorLine {
  bool is_heading = false;
  SensorRow row;          ///< the row; of a heading, the first row of its sensor
  std::size_t count = 0;  ///< number of rows of the sensor; of a heading only
  bool operator==(const SensorLine&) const = default;
};

/// The state of the table, its filter and its order.
struct TableState {
  std::string filter;
  std::optional<TableColumn> sorted;  ///< sorted column; empty for the order of the layout
  bool descending = false;
  std::vector<int> rows;               ///< indices of the displayed taxels, in display order
  std::vector<SensorRow> sensor_rows;  ///< rows in display order if several sensors are listed; otherwise empty
  std::vector<int> folded;             ///< indices in the simulation of sensors that only show their heading; ascending
  std::optional<TaxelKey> followed;    ///< selected taxel that the table of several sensors has scrolled to
  std::optional<TableCell> cell;       ///< cell with the text field, if any
  std::optional<TableCell> left;       ///< cell that the user left in this frame, if any
  float name_width = 0;                ///< width of the column of names in LAYOUT that was fitted last [pixels]
};

/// The table of all taxels of the displayed layout, with their readings.
extern const Feature kTaxelTable;
/// Sets "table": the rows in displayed order, and whether a cell is being edited.
void dump_table(const App& app, nlohmann::ordered_json& state);

}  // namespace taxel::ui
