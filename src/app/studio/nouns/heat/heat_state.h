// The heat map: its option, and the map as it was drawn.
#pragma once

#include <optional>
#include <string>

#include "app/studio/nouns/heat/heat_cells.h"
#include "ui/widgets/widget_registry.h"

namespace taxel::ui {

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

}  // namespace taxel::ui
