// The quantities and curves of the plot, the choice among them, and the plot as a page in vectors.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <variant>

#include "app/studio/frame/app.h"
#include "app/studio/nouns/plot/plot_drawing.h"
#include "app/studio/nouns/plot/plot_state.h"
#include "app/studio/nouns/real/real_state.h"
#include "core/base/page/chart.h"
#include "core/layout/generators/mirror.h"
#include "core/run/plot/curve_styles.h"
#include "core/sensor/readout/reading.h"
#include "ui/widgets/plot_curves.h"

namespace taxel::ui {

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

namespace {

double x_of(const TraceRow& row, bool by_travel) {
  return by_travel ? 1e3 * row.travel : row.time;
}

}  // namespace

void update_curves(PlotCurves& curves, const Trace& trace, bool by_travel, PlotQuantity quantity) {
  const std::vector<TraceRow>& rows = trace.rows;
  const bool same = curves.edition == trace.edition && curves.by_travel == by_travel && curves.quantity == quantity &&
                    curves.x.size() <= rows.size();
  const std::size_t plotted_rows = same ? curves.x.size() : 0;
  curves.is_growing = !same || plotted_rows != rows.size();
  if (!curves.is_growing) return;
  if (plotted_rows == 0) {
    curves = {};
    curves.edition = trace.edition;
    curves.by_travel = by_travel;
    curves.quantity = quantity;
    curves.is_growing = true;
    const std::size_t readings = rows.empty() ? 0 : rows.front().readings.size();
    curves.readings.resize(readings);
    curves.peaks.assign(readings, 0.0);
  }
  for (std::size_t r = plotted_rows; r < rows.size(); ++r) {
    const TraceRow& row = rows[r];
    const std::span<const double> values = values_of(row, quantity);
    curves.x.push_back(x_of(row, by_travel));
    for (std::size_t k = 0; k < curves.readings.size(); ++k) {
      curves.readings[k].push_back(k < values.size() ? values[k] : 0.0);
      curves.peaks[k] = std::max(curves.peaks[k], curves.readings[k].back());
    }
    if (r > 0 && rows[r - 1].quality == SampleQuality::preview && row.quality == SampleQuality::polished)
      curves.polished_from = curves.x.back();
  }
  for (const double peak : curves.peaks) curves.largest = std::max(curves.largest, peak);
  curves.drawn.assign(curves.readings.size(), {});
}

const CurvePoints& drawn_curve(PlotCurves& curves, std::size_t reading, double column, double tolerance, double scale) {
  const std::array<double, 3> wanted{column, tolerance, scale};
  if (curves.drawn_for != wanted) {
    curves.drawn_for = wanted;
    for (CurvePoints& drawn : curves.drawn) drawn.x.clear();
  }
  CurvePoints& drawn = curves.drawn[reading];
  if (!drawn.x.empty()) return drawn;
  thin_curve(curves.x, curves.readings[reading], column, tolerance / scale, drawn);
  for (double& y : drawn.y) y *= scale;
  return drawn;
}

bool are_equal_curves(std::span<const double> first, std::span<const double> second) {
  double peak = 0, distance = 0;
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (std::isnan(first[i]) != std::isnan(second[i])) return false;
    if (std::isnan(first[i])) continue;
    peak = std::max(peak, std::abs(second[i]));
    distance = std::max(distance, std::abs(first[i] - second[i]));
  }
  return peak > 0 && distance <= kEqualCurves * peak;
}

const std::vector<int>& leaders_among(PlotCurves& curves, const std::vector<std::size_t>& readings,
                                      const std::function<std::vector<int>()>& twins) {
  constexpr double kFewRows = 1.1;  // growth of the rows before a new search, which costs time for every row
  const auto rows = static_cast<double>(curves.x.size()), looked_at = static_cast<double>(curves.paired_rows);
  const bool is_recent = rows == looked_at || (curves.is_growing && rows > looked_at && rows < kFewRows * looked_at);
  if (curves.paired == readings && is_recent) return curves.leaders;
  std::vector<std::span<const double>> lines;
  for (const std::size_t reading : readings) lines.emplace_back(curves.readings[reading]);
  curves.leaders = find_leaders(lines, twins ? twins() : std::vector<int>{});
  curves.equals = curves.leaders;
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (const int leader = curves.equals[i];
        leader >= 0 && !are_equal_curves(lines[static_cast<std::size_t>(leader)], lines[i]))
      curves.equals[i] = -1;
  curves.paired = readings;
  curves.paired_rows = curves.x.size();
  return curves.leaders;
}

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
  for (std::size_t i = 0; i < chosen.size(); ++i) chosen[i].twin = curves.equals[i];
}

}  // namespace

void find_twins(PlotCurves& curves, std::vector<ChosenCurve>& chosen) {
  std::vector<std::size_t> readings;
  for (const ChosenCurve& curve : chosen) readings.push_back(curve.reading);
  leaders_among(curves, readings);
  for (std::size_t i = 0; i < chosen.size(); ++i) chosen[i].twin = curves.equals[i];
}

std::vector<LegendEntry> legend_entries(const std::vector<ChosenCurve>& curves) {
  std::vector<LegendEntry> entries;
  std::vector<std::size_t> entry_of(curves.size(), 0);
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const ChosenCurve& curve = curves[i];
    if (curve.twin < 0) {
      entry_of[i] = entries.size();
      entries.push_back({curve.label, {i}});
      continue;
    }
    entry_of[i] = entry_of[static_cast<std::size_t>(curve.twin)];
    LegendEntry& entry = entries[entry_of[i]];
    entry.label += " = " + curve.label;
    entry.curves.push_back(i);
  }
  return entries;
}

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
  for (const LegendEntry& entry : legend_entries(curves)) {
    const bool stands_out =
        std::ranges::any_of(entry.curves, [&](std::size_t i) { return has_key(wanted, curves[i].key); });
    if (!stands_out) continue;
    for (const std::size_t i : entry.curves) focus.push_back(curves[i].key);
  }
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
  const std::vector<LegendEntry> entries = legend_entries(choice.curves);
  std::vector<std::size_t> order(entries.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto value = [&](std::size_t i) {
    return curves.readings[choice.curves[entries[i].curves.front()].reading][row];
  };
  const auto rank = [&](std::size_t i) {
    int best = 2;
    for (const std::size_t k : entries[i].curves) {
      const ChosenCurve& curve = choice.curves[k];
      best = std::min(best, has_key(focus, curve.key) ? 0 : curve.selected || curve.jumped ? 1 : 2);
    }
    return best;
  };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return rank(a) != rank(b) ? rank(a) < rank(b) : value(a) > value(b);
  });
  for (const std::size_t i : order) {
    if (readout.lines.size() == most) break;
    const ChosenCurve& curve = choice.curves[entries[i].curves.front()];
    readout.lines.push_back({curve.key, entries[i].label, curve.color, value(i)});
  }
  readout.omitted = entries.size() - readout.lines.size();
  return readout;
}

PageColor page_color(int number, bool dimmed) {
  const ImVec4 shown = curve_color(number, false);
  glm::vec3 c(shown.x, shown.y, shown.z);
  if (dimmed) c = glm::mix(glm::vec3(1), c, kDimmedAlpha);
  return {static_cast<double>(c.x), static_cast<double>(c.y), static_cast<double>(c.z)};
}

namespace {

constexpr double kPageWidth = 432;  // smallest width of the page [points]

/// Returns the look of a curve on paper. Pixels of the window are 0.6 points.
LineStyle paper_style(const ChosenCurve& curve, const CurveStyle& style) {
  constexpr double kPointsPerPixel = 0.6;
  LineStyle line{page_color(curve.color, style.dimmed), kPointsPerPixel * style.width, {}, 0};
  if (!style.dashes) return line;
  line.dashes = {kPointsPerPixel * style.dashes->dash, kPointsPerPixel * style.dashes->gap};
  line.dash_start = kPointsPerPixel * style.dashes->start;
  return line;
}

}  // namespace

PlotAxes plot_axes(const RunView& run, const PlotChoice& choice, bool relative) {
  const SimScene& scene = *run.frame->scene;
  constexpr double kAbove = 1.08;  // height of the axis, as a factor of the largest reading
  PlotAxes axes;
  axes.x_end = run.by_travel() ? 1e3 * scene.duration * run.scenario.as<scenarios::Sweep>().speed
                               : std::max(1.0, scene.duration > 0 ? scene.duration : run.frame->time);
  const double largest = choice.quantity == PlotQuantity::slip ? 1.0 : choice.largest;  // slip ends at 100 %
  axes.y_end = kAbove * (relative || !(largest > 0) ? 1.0 : choice.unit.scale * largest);
  axes.x_name = run.by_travel() ? "travel (mm)" : "time (s)";
  const char* name = words_of(choice.quantity).axis;
  axes.y_name = relative ? fmt::format("{} / largest", name) : fmt::format("{} ({})", name, choice.unit.text);
  return axes;
}

void fit_to_contact(PlotAxes& axes, const RunView& run) {
  constexpr double kMargin = 0.05;  // of the contact's part, at both of its ends
  const HistoryLanes* lanes = run.frame ? run.frame->history.lanes.get() : nullptr;
  if (lanes == nullptr) return;
  const auto touches = [&](std::size_t row) {
    for (std::size_t s = 0; s < lanes->sensor_count; ++s)
      if (lanes->sensor(row, s).area > 0) return true;
    return false;
  };
  std::size_t first = 0, end = lanes->rows();
  while (first < end && !touches(first)) ++first;
  while (end > first && !touches(end - 1)) --end;
  if (end - first < 2) return;
  const auto x_of_row = [&](std::size_t row) {
    return run.by_travel() ? 1e3 * lanes->steps[row].travel : lanes->steps[row].time;
  };
  const double low = x_of_row(first), high = x_of_row(end - 1), margin = kMargin * (high - low);
  if (!(high > low)) return;  // the object of a sweep waits
  axes.x_begin = std::max(axes.x_begin, low - margin);
  axes.x_end = std::min(axes.x_end, high + margin);
}

bool fits_contact(const App& app) {
  const bool goes_on = app.shown->run.playing && app.shown->run.replay == 0 && !app.shown->run.loop;
  return app.viewer->mode == Mode::analyse && !app.get<PlotState>().options.whole_run && !goes_on;
}

void carry_out(const ToggleWholeRun&, App& app) {
  bool& whole = app.get<PlotState>().options.whole_run;
  whole = !whole;
}

Page plot_page(PlotCurves& curves, const PlotChoice& choice, const std::vector<TaxelKey>& focus, const PlotAxes& axes,
               bool relative, const std::string& title, std::vector<ChartRings> rings) {
  ChartPanel panel;
  panel.x = {axes.x_begin, axes.x_end, axes.x_name, true};
  panel.y = {0, axes.y_end, axes.y_name, true};
  const double scale = plot_scale(choice, relative);
  for (const std::size_t i : drawing_order(choice.curves, focus)) {
    const ChosenCurve& curve = choice.curves[i];
    ChartCurve drawn{{curves.x, curves.readings[curve.reading]}, paper_style(curve, style_of(curve, focus))};
    for (double& y : drawn.points.y) y = std::max(0.0, scale * y);
    panel.curves.push_back(std::move(drawn));
  }
  for (const LegendEntry& entry : legend_entries(choice.curves)) {
    const ChosenCurve &first = choice.curves[entry.curves.front()], &last = choice.curves[entry.curves.back()];
    panel.legend.push_back({entry.label, paper_style(last, style_of(last, focus))});
    if (entry.curves.size() > 1) panel.legend.back().below = paper_style(first, style_of(first, focus));
  }
  if (!rings.empty()) panel.legend.push_back({"real recording", {}, {}, true});
  panel.rings = std::move(rings);
  Chart chart;
  chart.title = title;
  chart.min_width = kPageWidth;
  chart.panels.push_back(std::move(panel));
  return chart_page(chart);
}

std::optional<Page> displayed_plot(const RunView& run, const Selection& selection, PlotState& plot, RealState& real,
                                   const std::string& title) {
  const std::vector<SensorShown> sensors = sensors_shown(run);
  if (sensors.empty() || !run.frame->trace || run.frame->trace->rows.empty()) return std::nullopt;
  update_curves(plot.curves, *run.frame->trace, run.by_travel(), available_quantity(sensors, plot.quantity));
  PlotChoice choice = choose_curves(plot.curves, sensors, selection, plot.options, stopped_taxel(run, sensors));
  part_twins(choice.curves, real);
  return plot_page(plot.curves, choice, focus_of(choice.curves, std::nullopt, plot.isolated),
                   plot_axes(run, choice, choice.relative), choice.relative, title,
                   real_rings(selection, run, real, plot, choice, sensors));
}

}  // namespace taxel::ui
