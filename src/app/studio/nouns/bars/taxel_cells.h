// The readings of many taxels as a heat map: a cell for each taxel, in rows by sensor.
#pragma once

#include <imgui.h>

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "app/studio/nouns/bars/pressure_bars.h"

namespace taxel::ui {

/// Sizes that cells are placed with [pixels].
struct CellSizes {
  float name = 0;   ///< width of the names at the left of the cells, with a gap
  float line = 0;   ///< height of a line of text, which is the least height of a sensor
  float least = 3;  ///< least width and height of a cell
};

/// The cells of one sensor, relative to the upper left corner of all cells [pixels].
struct SensorCells {
  float x = 0, y = 0;       ///< upper left corner of the first cell; the name is at the left of it
  float top = 0;            ///< upper end of the name
  float height = 0;         ///< height of the name or of all lines of cells, the larger one
  std::size_t columns = 1;  ///< number of cells in a line
};

/// The places of all cells. A sensor has a name and to its right one or more lines of cells.
struct CellPlan {
  float width = 0, height = 0;       ///< width and height of a cell
  float total_height = 0;            ///< height of everything
  std::vector<SensorCells> sensors;  ///< parallel to the counts

  /// Returns the rectangle of a cell for an upper left corner of all cells.
  [[nodiscard]] Rect cell(const ImVec2& origin, std::size_t sensor, std::size_t taxel) const;
};

/// Places `counts` cells of each sensor in one or more columns of sensors, so that cells are as large as possible and
/// at most 1.6 times as wide as high. The sensors of a chain of bodies stay in one column if they fit. If cells would
/// be smaller than `sizes.least`, everything is higher than the room. Cost: O(sensors).
[[nodiscard]] CellPlan place_cells(std::span<const std::size_t> counts, std::span<const int> chains, ImVec2 room,
                                   const CellSizes& sizes);

/// Draws the readings of the groups as cells in the colours of their ranges into an area of `size` at the cursor, which
/// scrolls if they are higher. The cell under the pointer has a tooltip, selected cells have an outline. Records the
/// visible cells in `shown`. Returns the clicked taxel, if any.
std::optional<ClickedBar> draw_taxel_cells(WindowUi& ui, const Viewer& viewer, BarsShown& shown,
                                           const std::vector<BarGroup>& groups, ImVec2 size);

}  // namespace taxel::ui
