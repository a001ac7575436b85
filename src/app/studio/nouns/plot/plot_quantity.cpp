#include "app/studio/nouns/plot/plot_quantity.h"

#include <algorithm>

namespace taxel::ui {

const QuantityWords& words_of(PlotQuantity quantity) {
  static constexpr QuantityWords kWords[] = {
      {"reading", "Reading", "reading", "Readings of the taxels"},
      {"shear", "Shear", "shear", "Magnitude of the shear of each taxel, in the unit of its readings"},
      {"slip", "Slip", "field that slips", "Share of each taxel's touched field that slips, 0 to 100 %"}};
  return kWords[static_cast<std::size_t>(quantity)];
}

bool has_quantity(const SensorShown& sensor, PlotQuantity quantity) {
  switch (quantity) {
    case PlotQuantity::reading:
      return true;
    case PlotQuantity::shear:
      return !sensor.step->shear.empty();
    case PlotQuantity::slip:
      return !sensor.step->slip.empty();
  }
  return false;
}

ReadingUnit quantity_unit(const SensorShown& sensor, PlotQuantity quantity) {
  return quantity == PlotQuantity::slip ? kSlipUnit : sensor.unit;
}

std::string why_missing(const std::vector<SensorShown>& sensors, PlotQuantity quantity) {
  if (std::ranges::any_of(sensors, [&](const SensorShown& sensor) { return has_quantity(sensor, quantity); }))
    return {};
  return quantity == PlotQuantity::shear ? "The layout reads no shear: switch on Inspector > Readout > Shear"
                                         : "Friction has no memory: set Inspector > Material > Tangential stiffness";
}

PlotQuantity available_quantity(const std::vector<SensorShown>& sensors, PlotQuantity wanted) {
  return why_missing(sensors, wanted).empty() ? wanted : PlotQuantity::reading;
}

std::span<const double> values_of(const TraceRow& row, PlotQuantity quantity) {
  switch (quantity) {
    case PlotQuantity::reading:
      return row.readings;
    case PlotQuantity::shear:
      return row.shear;
    case PlotQuantity::slip:
      return row.slip;
  }
  return {};
}

}  // namespace taxel::ui
