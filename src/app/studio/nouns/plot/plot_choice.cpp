#include "app/studio/nouns/plot/plot_choice.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <variant>

#include "core/layout/generators/mirror.h"
#include "core/sensor/readout/reading.h"

namespace taxel::ui {

namespace {

bool has_key(const std::vector<TaxelKey>& keys, const TaxelKey& key) {
  return std::find(keys.begin(), keys.end(), key) != keys.end();
}

/// Returns the unit of the selected sensor, or of the first one that has the quantity.
ReadingUnit chosen_unit(const std::vector<SensorShown>& sensors, const Selection& selection, PlotQuantity quantity) {
  std::vector<SensorShown> having;
  for (const SensorShown& sensor : sensors)
    if (has_quantity(sensor, quantity)) having.push_back(sensor);
  const SensorShown& unit_of = having.empty() ? sensors.front() : having.front();
  for (const SensorShown& sensor : having)
    if (sensor.index == selection.sensor) return quantity_unit(sensor, quantity);
  return quantity_unit(unit_of, quantity);
}

/// Returns the places of the mirror twins of curves, or -1; see mirror_twins().
std::vector<int> twins_among(const std::vector<SensorShown>& sensors, const std::vector<ChosenCurve>& chosen) {
  std::vector<int> twins(chosen.size(), -1);
  for (const SensorShown& sensor : sensors) {
    std::vector<std::size_t> places, taxels;
    for (std::size_t i = 0; i < chosen.size(); ++i)
      if (chosen[i].key.sensor == sensor.index) places.push_back(i), taxels.push_back(chosen[i].reading - sensor.first);
    const std::vector<int> own = mirror_twins(sensor.model->layout, taxels);
    for (std::size_t i = 0; i < places.size(); ++i)
      if (own[i] >= 0) twins[places[i]] = static_cast<int>(places[static_cast<std::size_t>(own[i])]);
  }
  return twins;
}

/// Sets the places of curves of twins that lie on each other.
void place_pairs(PlotCurves& curves, const std::vector<SensorShown>& sensors, std::vector<ChosenCurve>& chosen) {
  std::vector<std::size_t> readings;
  for (const ChosenCurve& curve : chosen) readings.push_back(curve.reading);
  const auto twins = [&] { return twins_among(sensors, chosen); };
  const std::vector<int> leaders = leaders_among(curves, readings, twins);
  for (std::size_t i = 0; i < chosen.size(); ++i)
    if (leaders[i] >= 0) chosen[i].place = chosen[static_cast<std::size_t>(leaders[i])].of++;
  for (std::size_t i = 0; i < chosen.size(); ++i)
    if (leaders[i] >= 0) chosen[i].of = chosen[static_cast<std::size_t>(leaders[i])].of;
}

}  // namespace

std::optional<TaxelKey> stopped_taxel(const RunView& run, const std::vector<SensorShown>& sensors) {
  if (!run.frame || !run.frame->stop) return std::nullopt;
  return std::visit(
      [&](const auto& stop) -> std::optional<TaxelKey> {
        for (const SensorShown& sensor : sensors)
          if (sensor.index == stop.sensor && stop.taxel >= 0 && stop.taxel < static_cast<int>(sensor.taxels().size()))
            return TaxelKey{stop.sensor, sensor.taxels()[static_cast<std::size_t>(stop.taxel)].id};
        return std::nullopt;
      },
      *run.frame->stop);
}

PlotChoice choose_curves(PlotCurves& curves, const std::vector<SensorShown>& sensors, const Selection& selection,
                         const PlotOptions& options, const std::optional<TaxelKey>& jumped) {
  PlotChoice choice;
  choice.quantity = curves.quantity;
  choice.unit = chosen_unit(sensors, selection, curves.quantity);
  choice.relative = options.relative && curves.quantity != PlotQuantity::slip;
  const auto readings_of = [&](const SensorShown& sensor) {
    return std::min(sensor.taxels().size(), curves.peaks.size() - std::min(sensor.first, curves.peaks.size()));
  };
  const auto shares_axis = [&](const SensorShown& sensor) {
    return same_unit(quantity_unit(sensor, curves.quantity), choice.unit);
  };
  for (const SensorShown& sensor : sensors) {
    if (!shares_axis(sensor)) continue;
    for (std::size_t k = 0; k < readings_of(sensor); ++k)
      choice.largest = std::max(choice.largest, curves.peaks[sensor.first + k]);
  }
  for (const SensorShown& sensor : sensors) {
    if (!options.all_sensors && sensor.index != selection.sensor) continue;
    if (!has_quantity(sensor, curves.quantity)) {
      ++choice.without;
      continue;
    }
    if (!shares_axis(sensor)) {
      ++choice.other_units;
      continue;
    }
    for (std::size_t k = 0; k < readings_of(sensor); ++k) {
      ChosenCurve curve;
      curve.key = {sensor.index, sensor.taxels()[k].id};
      curve.reading = sensor.first + k;
      curve.selected = is_selected(selection, curve.key);
      curve.jumped = jumped == curve.key;
      const bool responds = curves.peaks[curve.reading] > kTaxelResponds * choice.largest;
      if (options.responding_only && !responds && !curve.selected && !curve.jumped) continue;
      curve.label = taxel_label(sensors, sensor, curve.key.id);
      curve.color = sensor.model->color(static_cast<int>(k));
      choice.curves.push_back(std::move(curve));
    }
  }
  place_pairs(curves, sensors, choice.curves);
  return choice;
}

std::vector<TaxelKey> focus_of(const std::vector<ChosenCurve>& curves, const std::optional<TaxelKey>& hovered,
                               const std::vector<TaxelKey>& isolated) {
  const std::vector<TaxelKey> wanted = hovered ? std::vector{*hovered} : isolated;
  std::vector<TaxelKey> focus;
  for (const ChosenCurve& curve : curves)
    if (has_key(wanted, curve.key)) focus.push_back(curve.key);
  return focus;
}

void click_isolated(std::vector<TaxelKey>& isolated, const TaxelKey& key, bool shift) {
  const bool was = has_key(isolated, key);
  if (!shift) isolated.clear();
  was ? void(std::erase(isolated, key)) : isolated.push_back(key);
}

CurveStyle style_of(const ChosenCurve& curve, const std::vector<TaxelKey>& focus) {
  constexpr double kLine = 1.8, kStrong = 3.0, kWider = 1.7;  // [pixels], and the factor below dashes
  constexpr double kDash = 5;                                 // [pixels]
  const bool focused = has_key(focus, curve.key);
  CurveStyle style;
  style.dimmed = !focus.empty() && !focused;
  const bool strong = curve.selected || curve.jumped || focused;
  style.width = style.dimmed ? 1.0 : strong ? kStrong : kLine;
  if (curve.dashed) style.dashes = DashLengths{kDash, kDash};
  if (curve.dashed || curve.of < 2 || style.dimmed || focus.size() == 1) return style;
  if (curve.place == 0) {
    style.width *= kWider;
    return style;
  }
  const double period = kDash * curve.of;
  style.dashes = DashLengths{kDash, period - kDash, period - kDash * curve.place};
  return style;
}

std::vector<std::size_t> drawing_order(const std::vector<ChosenCurve>& curves, const std::vector<TaxelKey>& focus) {
  std::vector<std::size_t> order(curves.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto rank = [&](std::size_t i) {
    const bool focused = has_key(focus, curves[i].key);
    return (focused ? 2 : 0) + (curves[i].place > 0 ? 1 : 0);
  };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return rank(a) < rank(b); });
  return order;
}

double plot_scale(const PlotChoice& choice, bool relative) {
  if (!relative) return choice.unit.scale;
  return choice.largest > 0 ? 1 / choice.largest : 1.0;
}

std::optional<PlotReadout> read_curves(const PlotCurves& curves, const PlotChoice& choice,
                                       const std::vector<TaxelKey>& focus, double x, std::size_t most) {
  if (curves.x.empty()) return std::nullopt;
  auto at = std::lower_bound(curves.x.begin(), curves.x.end(), x);
  if (at == curves.x.end() || (at != curves.x.begin() && x - *(at - 1) <= *at - x)) --at;
  const auto row = static_cast<std::size_t>(at - curves.x.begin());
  PlotReadout readout;
  readout.x = *at;
  std::vector<std::size_t> order(choice.curves.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto value = [&](std::size_t i) { return curves.readings[choice.curves[i].reading][row]; };
  const auto rank = [&](std::size_t i) {
    const ChosenCurve& curve = choice.curves[i];
    return has_key(focus, curve.key) ? 0 : curve.selected || curve.jumped ? 1 : 2;
  };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return rank(a) != rank(b) ? rank(a) < rank(b) : value(a) > value(b);
  });
  for (const std::size_t i : order) {
    if (readout.lines.size() == most) break;
    const ChosenCurve& curve = choice.curves[i];
    readout.lines.push_back({curve.key, curve.label, curve.color, value(i)});
  }
  readout.omitted = choice.curves.size() - readout.lines.size();
  return readout;
}

}  // namespace taxel::ui
