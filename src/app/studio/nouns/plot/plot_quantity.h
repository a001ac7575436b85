// The quantities of a taxel that the plot can show: its reading, its shear, and the share of its field that slips.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "app/studio/frame/sensors_shown.h"
#include "core/run/trace.h"

namespace taxel::ui {

enum class PlotQuantity : std::uint8_t { reading, shear, slip };

inline constexpr PlotQuantity kPlotQuantities[] = {PlotQuantity::reading, PlotQuantity::shear, PlotQuantity::slip};

/// A quantity in words.
struct QuantityWords {
  const char* key;    ///< word in the dump
  const char* label;  ///< button of the plot
  const char* axis;   ///< name of the vertical axis
  const char* tip;    ///< tooltip of the button
};
[[nodiscard]] const QuantityWords& words_of(PlotQuantity quantity);

/// Returns whether a sensor has the quantity in the displayed step.
[[nodiscard]] bool has_quantity(const SensorShown& sensor, PlotQuantity quantity);

/// Returns the unit of a sensor's quantity: that of its readings, or percent for slip.
[[nodiscard]] ReadingUnit quantity_unit(const SensorShown& sensor, PlotQuantity quantity);

/// Returns why no sensor has the quantity, and how it gets it. Empty if a sensor has it.
[[nodiscard]] std::string why_missing(const std::vector<SensorShown>& sensors, PlotQuantity quantity);

/// Returns the wanted quantity if a sensor has it, otherwise readings.
[[nodiscard]] PlotQuantity available_quantity(const std::vector<SensorShown>& sensors, PlotQuantity wanted);

/// Returns the values of a quantity in a row, for the taxels of all sensors in order. Empty if the row has none.
[[nodiscard]] std::span<const double> values_of(const TraceRow& row, PlotQuantity quantity);

}  // namespace taxel::ui
