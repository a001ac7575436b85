// The drawing of the heat map: cells, names, axis of time, and scale of colours.
#pragma once

#include <imgui.h>

#include <array>

#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/heat/heat_state.h"

namespace taxel::ui {

/// The map in this frame. Places are pixels of the window.
struct HeatFrame {
  const HistoryLanes& lanes;
  const std::vector<SensorShown>& sensors;
  const std::vector<PressureRange>& ranges;  ///< parallel to `sensors`
  const std::vector<HeatRow>& rows;
  const HeatPlaces& places;
  HeatCells cells;
  ImVec2 origin;    ///< upper left corner of the first cell
  float width = 0;  ///< width of all cells

  [[nodiscard]] float x(std::size_t column) const {
    return origin.x + width * static_cast<float>(column) / static_cast<float>(cells.columns);
  }
  [[nodiscard]] float x_of_step(std::size_t row) const {
    return origin.x + width * (static_cast<float>(row) + 0.5f) / static_cast<float>(lanes.rows());
  }
};

/// Returns the width of the names left of the cells, and of the ids in it. Ids need rows as high as text.
[[nodiscard]] std::array<float, 2> heat_label_widths(const std::vector<SensorShown>& sensors,
                                                     const std::vector<HeatRow>& rows, const HeatPlaces& places);

/// Draws the scale of colours into the rest of the row, if it fits: the lower end, the colours, and the upper end with
/// its unit.
void draw_heat_scale(const WindowUi& ui, const PressureRange& range, const ReadingUnit& unit);

/// Draws the cells between the heights y0 and y1. Returns the number of rectangles of the whole map.
std::size_t draw_heat_cells(const HeatFrame& frame, float y0, float y1);

/// Draws the names of the sensors from `left`, and ids if their width is not 0. Marks selected taxels.
void draw_heat_labels(WindowUi& ui, const Selection& selection, const HeatFrame& frame, float left, float ids);

/// Draws the axis of time below the cells.
void draw_heat_axis(const WindowUi& ui, const HeatFrame& frame, float y);

/// Draws a line at a recorded step.
void draw_heat_cursor(const WindowUi& ui, const HeatFrame& frame, std::uint64_t step, float y0, float y1);

}  // namespace taxel::ui
