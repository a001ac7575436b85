// The cells of the tables with the values of a taxel in the displayed step: its reading, its shear and its slip.
#pragma once

#include <string_view>

#include "app/studio/frame/window_ui.h"
#include "core/sensor/sensor_step.h"
#include "ui/widgets/format.h"

namespace taxel::ui {

/// The columns of values that the displayed sensors have in addition to readings.
struct ValueColumns {
  bool shear = false, slip = false;
  [[nodiscard]] int count() const { return (shear ? 1 : 0) + (slip ? 1 : 0); }
  /// Adds the columns of another sensor.
  void include(const SensorStep& step) {
    shear = shear || !step.shear.empty();
    slip = slip || !step.slip.empty();
  }
};

inline constexpr const char* kShearTitle = "Shear";
inline constexpr const char* kSlipTitle = "Slip";

/// Returns the tooltip of a column with this title, or "" if it needs none.
[[nodiscard]] const char* value_tip(std::string_view title);

/// Width below which a table leaves out the samples, in heights of text: their numbers would be cut off.
inline constexpr float kNarrowTable = 24;

/// Draws the cells of the reading, and of shear and slip if there are these columns. Values that the sensor does not
/// have are empty cells.
void draw_values(const WindowUi& ui, const SensorStep* step, std::size_t taxel, const ReadingUnit& unit,
                 const ValueColumns& columns);

}  // namespace taxel::ui
