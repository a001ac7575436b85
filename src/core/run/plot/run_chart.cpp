#include "core/run/plot/run_chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <span>

#include "core/base/error.h"
#include "core/layout/file/layout_json.h"
#include "core/layout/generators/mirror.h"
#include "core/run/plot/curve_styles.h"
#include "core/run/plot/plotted_run.h"
#include "core/run/recording/recording.h"

namespace taxel {
namespace {

bool has_several_sensors(const PlottedRun& run) {
  return std::count_if(run.sensors.begin(), run.sensors.end(),
                       [](const PlottedSensor& sensor) { return !sensor.taxel_ids.empty(); }) > 1;
}

std::string taxel_word(const PlottedRun& run, const PlottedTaxel& taxel) {
  const PlottedSensor& sensor = run.sensors[taxel.sensor];
  return (has_several_sensors(run) ? sensor.geom + "/" : "") + std::to_string(sensor.taxel_ids[taxel.taxel]);
}

std::string label_of(const PlottedRun& run, const PlottedTaxel& taxel, bool has_names) {
  const std::string& name = run.sensors[taxel.sensor].taxel_names[taxel.taxel];
  const std::string word = taxel_word(run, taxel);
  if (!has_names || has_several_sensors(run)) return has_names && !name.empty() ? word + " " + name : word;
  return name.empty() ? "taxel " + word : word + " " + name;
}

/// Returns true if a user's word is the id of a taxel, with its sensor or without, or its name.
bool is_named(const PlottedRun& run, const PlottedTaxel& taxel, const std::string& word) {
  const PlottedSensor& sensor = run.sensors[taxel.sensor];
  const std::string id = std::to_string(sensor.taxel_ids[taxel.taxel]), name = sensor.taxel_names[taxel.taxel];
  const bool is_own = word == id || (!name.empty() && word == name);
  return is_own || word == sensor.geom + "/" + id || (!name.empty() && word == sensor.geom + "/" + name);
}

std::vector<PlottedTaxel> named_taxels(const PlottedRun& run, const std::vector<std::string>& words,
                                       const std::vector<PlottedTaxel>& all) {
  std::vector<bool> is_chosen(all.size(), false);
  for (const std::string& word : words) {
    bool is_known = false;
    for (std::size_t i = 0; i < all.size(); ++i)
      if (is_named(run, all[i], word)) is_chosen[i] = is_known = true;
    if (is_known) continue;
    std::string names;
    for (std::size_t i = 0; i < std::min<std::size_t>(all.size(), 12); ++i)
      names += (i == 0 ? "" : ", ") + taxel_word(run, all[i]);
    throw Error(run.file, fmt::format("has no taxel \"{}\"; its taxels are {}{}", word, names,
                                      all.size() > 12 ? fmt::format(" and {} more", all.size() - 12) : ""));
  }
  std::vector<PlottedTaxel> chosen;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (is_chosen[i]) chosen.push_back(all[i]);
  return chosen;
}

}  // namespace

std::vector<std::size_t> chosen_sensors(const PlottedRun& run, const RunChartOptions& options) {
  std::vector<std::size_t> sensors;
  std::string names;
  for (std::size_t i = 0; i < run.sensors.size(); ++i) {
    if (run.sensors[i].taxel_ids.empty()) continue;
    names += (names.empty() ? "" : ", ") + run.sensors[i].geom;
    if (options.sensor.empty() || run.sensors[i].geom == options.sensor) sensors.push_back(i);
  }
  if (names.empty() && sensors.empty()) throw Error(run.file, "has no sensor with taxels");
  if (sensors.empty()) throw Error(run.file, fmt::format("has no sensor \"{}\", but {}", options.sensor, names));
  return sensors;
}

std::vector<PlottedTaxel> taxels_of(const PlottedRun& run, const RunChartOptions& options, bool has_names) {
  std::vector<PlottedTaxel> taxels;
  for (const std::size_t s : chosen_sensors(run, options))
    for (std::size_t t = 0; t < run.sensors[s].taxel_ids.size(); ++t) {
      PlottedTaxel taxel{s, t, "", 0, 0};
      taxel.label = label_of(run, taxel, has_names);
      const std::vector<double>& readings = run.sensors[s].readings[t];
      for (std::size_t row = 0; row < readings.size(); ++row)
        if (std::abs(readings[row]) > std::abs(taxel.peak)) taxel.peak = readings[row], taxel.peak_row = row;
      taxels.push_back(taxel);
    }
  return taxels;
}

std::vector<PlottedTaxel> chosen_taxels(const PlottedRun& run, const RunChartOptions& options,
                                        const std::vector<PlottedTaxel>& all, const std::vector<double>& peaks) {
  if (!options.taxels.empty()) return named_taxels(run, options.taxels, all);
  if (options.has_all_taxels) return all;
  std::map<std::string, double> largest;
  for (std::size_t i = 0; i < all.size(); ++i) {
    double& value = largest[run.sensors[all[i].sensor].unit];
    value = std::max(value, std::abs(peaks[i]));
  }
  std::vector<PlottedTaxel> chosen;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (std::abs(peaks[i]) > kResponds * largest[run.sensors[all[i].sensor].unit]) chosen.push_back(all[i]);
  return chosen;
}

namespace {

constexpr std::size_t kMaxNamedRows = 24;  // rows of a heat map that are labelled by names, not only by ids
constexpr std::size_t kMaxCellColumns = 400;

/// Returns true if the travel grows from nearly every row to the next, and never decreases.
bool moves_always(const std::vector<double>& travel) {
  if (!std::is_sorted(travel.begin(), travel.end())) return false;
  std::size_t growing = 0;
  for (std::size_t i = 1; i < travel.size(); ++i) growing += travel[i] > travel[i - 1] ? 1 : 0;
  return growing > 0 && 100 * growing >= 99 * (travel.size() - 1);
}

/// The axis x of all panels, and the rows on it.
struct RowAxis {
  ChartAxis axis;
  std::vector<double> x;  ///< travel [mm] or time [s] of each row
  bool is_travel = false;
};

RowAxis row_axis(const PlottedRun& run, PlotAxis over) {
  RowAxis rows;
  rows.is_travel = over == PlotAxis::travel || (over == PlotAxis::automatic && moves_always(run.travel));
  rows.x = rows.is_travel ? run.travel : run.time;
  if (rows.is_travel)
    for (double& x : rows.x) x *= 1e3;
  const auto [low, high] = std::minmax_element(rows.x.begin(), rows.x.end());
  rows.axis = {*low, *high, rows.is_travel ? "travel (mm)" : "time (s)", true};
  if (!(rows.axis.high > rows.axis.low)) rows.axis.low -= 1, rows.axis.high += 1;
  return rows;
}

/// Returns the axis of values: from 0, or below the lowest value, to above the highest.
ChartAxis value_axis(double lowest, double highest, const std::string& name) {
  constexpr double kAbove = 0.08;  // room above the highest value, as a fraction of the axis
  const double low = std::min(0.0, lowest), high = std::max(0.0, highest);
  const double span = high - low;
  if (!(span > 0)) return {0, 1, name, true};
  return {low < 0 ? low - kAbove * span : 0, high > 0 ? high + kAbove * span : 0, name, true};
}

/// Returns the leaders among the curves of taxels. The curves of a sensor whose layout is known are in a pair only with
/// that of their twin.
std::vector<int> leaders_among(const PlottedRun& run, const std::vector<PlottedTaxel>& taxels) {
  std::vector<int> leaders(taxels.size(), -1);
  for (std::size_t s = 0; s < run.sensors.size(); ++s) {
    const PlottedSensor& sensor = run.sensors[s];
    std::vector<std::size_t> places, own;
    std::vector<std::span<const double>> spans;
    for (std::size_t i = 0; i < taxels.size(); ++i)
      if (taxels[i].sensor == s)
        places.push_back(i), own.push_back(taxels[i].taxel), spans.emplace_back(sensor.readings[taxels[i].taxel]);
    std::vector<int> twins;
    if (!sensor.layout_json.empty()) twins = mirror_twins(parse_layout(sensor.layout_json, run.file), own);
    const std::vector<int> found = find_leaders(spans, twins);
    for (std::size_t i = 0; i < places.size(); ++i)
      if (found[i] >= 0) leaders[places[i]] = static_cast<int>(places[static_cast<std::size_t>(found[i])]);
  }
  return leaders;
}

/// Adds curves of values times `scale` and their legend to a panel. `leaders` as of find_leaders().
void add_curves(ChartPanel& panel, const std::vector<double>& x, const std::vector<const std::vector<double>*>& values,
                double scale, const std::vector<std::string>& labels, const std::vector<int>& leaders) {
  const std::vector<LineStyle> styles = paired_styles(leaders);
  for (std::size_t i = 0; i < values.size(); ++i) {
    panel.legend.push_back({labels[i], styles[i]});
    if (leaders[i] >= 0 && styles[i].width < styles[static_cast<std::size_t>(leaders[i])].width)
      panel.legend.back().below = styles[static_cast<std::size_t>(leaders[i])];
  }
  for (const std::size_t i : paired_order(leaders)) {
    ChartCurve curve{{x, *values[i]}, styles[i]};
    for (double& y : curve.points.y) y *= scale;
    panel.curves.push_back(std::move(curve));
  }
}

/// The taxels of one unit, which share a panel.
struct UnitGroup {
  std::string unit;
  std::vector<PlottedTaxel> taxels;
  double lowest = 0, highest = 0;

  [[nodiscard]] double largest() const { return std::max(-lowest, highest); }
};

std::vector<UnitGroup> groups_by_unit(const PlottedRun& run, const std::vector<PlottedTaxel>& taxels) {
  std::vector<UnitGroup> groups;
  for (const PlottedTaxel& taxel : taxels) {
    const PlottedSensor& sensor = run.sensors[taxel.sensor];
    auto at = std::find_if(groups.begin(), groups.end(), [&](const UnitGroup& g) { return g.unit == sensor.unit; });
    if (at == groups.end()) at = groups.insert(at, {sensor.unit, {}, 0, 0});
    at->taxels.push_back(taxel);
    for (const double value : sensor.readings[taxel.taxel])
      at->lowest = std::min(at->lowest, value), at->highest = std::max(at->highest, value);
  }
  if (groups.empty()) groups.push_back({run.sensors.front().unit, {}, 0, 0});
  return groups;
}

/// Adds whiskers of the error bars of one curve, at most kMostWhiskers, evenly among its rows with bars. Those of
/// several curves are at different rows.
void add_whiskers(ChartPanel& panel, const std::vector<double>& x, const std::vector<double>& values,
                  const std::vector<double>& errors, double scale, const LineStyle& style, std::size_t curve) {
  constexpr std::size_t kMostWhiskers = 20, kCurves = 5;
  const LineStyle thin{style.color, 0.6};
  std::vector<std::size_t> rows;
  for (std::size_t row = 0; row < x.size(); ++row)
    if (errors[row] > 0) rows.push_back(row);
  const std::size_t every = std::max<std::size_t>(1, (rows.size() + kMostWhiskers - 1) / kMostWhiskers);
  for (std::size_t i = curve % kCurves * every / kCurves; i < rows.size(); i += every) {
    const std::size_t row = rows[i];
    panel.curves.push_back(
        {{{x[row], x[row]}, {scale * (values[row] - errors[row]), scale * (values[row] + errors[row])}}, thin});
  }
}

ChartPanel readings_panel(const PlottedRun& run, const RowAxis& rows, const UnitGroup& group, bool is_normalised) {
  const double largest = group.largest();
  const PlotUnit unit = plot_unit(group.unit, largest);
  const double scale = is_normalised ? (largest > kMinPlotted ? 1 / largest : 1) : unit.scale;
  ChartPanel panel;
  panel.x = rows.axis;
  panel.y = value_axis(scale * group.lowest, scale * group.highest,
                       is_normalised ? "reading / largest reading" : named_with_unit("reading", unit.text));
  std::vector<const std::vector<double>*> values;
  std::vector<std::string> labels;
  for (const PlottedTaxel& taxel : group.taxels) {
    values.push_back(&run.sensors[taxel.sensor].readings[taxel.taxel]);
    labels.push_back(taxel.label);
  }
  add_curves(panel, rows.x, values, scale, labels, leaders_among(run, group.taxels));
  for (std::size_t i = 0; i < group.taxels.size(); ++i) {
    const PlottedSensor& sensor = run.sensors[group.taxels[i].sensor];
    if (!sensor.errors.empty())
      add_whiskers(panel, rows.x, *values[i], sensor.errors[group.taxels[i].taxel], scale, panel.legend[i].style, i);
  }
  return panel;
}

/// Returns the ends of the columns of cells: the middles between rows, or even steps if there are too many rows.
std::vector<double> cell_edges(const RowAxis& rows) {
  std::vector<double> edges{rows.axis.low};
  const std::size_t n = rows.x.size();
  if (n <= kMaxCellColumns) {
    for (std::size_t i = 1; i < n; ++i) edges.push_back(0.5 * (rows.x[i - 1] + rows.x[i]));
  } else {
    for (std::size_t i = 1; i < kMaxCellColumns; ++i)
      edges.push_back(rows.axis.low +
                      (rows.axis.high - rows.axis.low) * static_cast<double>(i) / static_cast<double>(kMaxCellColumns));
  }
  edges.push_back(rows.axis.high);
  return edges;
}

/// Returns the value of the largest size in each column of cells. A column without a row has the value of the row
/// before.
std::vector<double> cell_values(const std::vector<double>& x, const std::vector<double>& values,
                                const std::vector<double>& edges) {
  if (x.size() + 1 == edges.size()) return values;
  std::vector<double> cells;
  std::size_t row = 0;
  for (std::size_t column = 0; column + 1 < edges.size(); ++column) {
    double value = row > 0 ? values[row - 1] : values[0];
    const bool is_last = column + 2 == edges.size();
    for (bool is_first = true; row < x.size() && (x[row] < edges[column + 1] || is_last); ++row, is_first = false)
      if (is_first || std::abs(values[row]) > std::abs(value)) value = values[row];
    cells.push_back(value);
  }
  return cells;
}

ChartPanel heat_map_panel(const PlottedRun& run, const RowAxis& rows, const UnitGroup& group) {
  if (!std::is_sorted(rows.x.begin(), rows.x.end()))
    throw Error(run.file, "travel", "must not decrease in a heat map: choose --over time");
  const PlotUnit unit = plot_unit(group.unit, group.largest());
  ChartPanel panel;
  panel.x = rows.axis;
  panel.y.name = "taxel";
  ChartCells cells;
  cells.edges = cell_edges(rows);
  cells.low = unit.scale * group.lowest;
  cells.high = group.highest > group.lowest ? unit.scale * group.highest : cells.low + 1;
  cells.name = named_with_unit("reading", unit.text);
  for (const PlottedTaxel& taxel : group.taxels) {
    cells.rows.push_back(taxel.label);
    cells.values.push_back(cell_values(rows.x, run.sensors[taxel.sensor].readings[taxel.taxel], cells.edges));
    for (double& value : cells.values.back()) value *= unit.scale;
  }
  panel.cells = std::move(cells);
  return panel;
}

/// Returns the forces on the plotted sensors: the parts and the size of the force on one sensor, or the sizes of
/// several.
ChartPanel forces_panel(const PlottedRun& run, const RowAxis& rows, const RunChartOptions& options) {
  const std::vector<std::size_t> sensors = chosen_sensors(run, options);
  std::vector<std::vector<double>> values;
  std::vector<std::string> labels;
  for (const std::size_t s : sensors) {
    const std::vector<dvec3>& forces = run.sensors[s].force_W;
    if (forces.empty()) throw Error(run.file, "has no columns force_x, force_y and force_z");
    if (sensors.size() == 1) {
      for (int axis = 0; axis < 3; ++axis) {
        labels.push_back(fmt::format("force {}", "xyz"[axis]));
        values.emplace_back();
        for (const dvec3& force : forces) values.back().push_back(force[axis]);
      }
    }
    labels.push_back(sensors.size() == 1 ? "magnitude" : run.sensors[s].geom);
    values.emplace_back();
    for (const dvec3& force : forces) values.back().push_back(glm::length(force));
  }
  double lowest = 0, highest = 0;
  std::vector<const std::vector<double>*> pointers;
  for (const std::vector<double>& one : values) {
    pointers.push_back(&one);
    for (const double value : one) lowest = std::min(lowest, value), highest = std::max(highest, value);
  }
  const PlotUnit unit = plot_unit("N", std::max(-lowest, highest));
  ChartPanel panel;
  panel.x = rows.axis;
  panel.y = value_axis(unit.scale * lowest, unit.scale * highest,
                       named_with_unit(sensors.size() == 1 ? "force" : "magnitude of the force", unit.text));
  std::vector<std::span<const double>> spans(values.begin(), values.end());
  add_curves(panel, rows.x, pointers, unit.scale, labels,
             sensors.size() > 1 ? find_leaders(spans) : std::vector<int>(values.size(), -1));
  return panel;
}

/// Removes the texts of the axis x from panels that have the same axis below them.
void share_x_axis(Chart& chart) {
  for (std::size_t i = 0; i + chart.columns < chart.panels.size(); ++i) chart.panels[i].x.has_texts = false;
}

std::vector<double> peaks_of(const std::vector<PlottedTaxel>& taxels) {
  std::vector<double> peaks;
  for (const PlottedTaxel& taxel : taxels) peaks.push_back(taxel.peak);
  return peaks;
}

/// Returns the taxels of the heat map: those that the user names, otherwise all.
std::vector<PlottedTaxel> heat_map_taxels(const PlottedRun& run, RunChartOptions options) {
  options.has_all_taxels = true;
  for (const bool has_names : {true, false}) {
    const std::vector<PlottedTaxel> all = taxels_of(run, options, has_names);
    const std::vector<PlottedTaxel> chosen = chosen_taxels(run, options, all, peaks_of(all));
    if (!has_names || chosen.size() <= kMaxNamedRows) return chosen;
  }
  return {};
}

/// Adds a heat map for each unit. Many taxels make the axes higher.
void add_heat_maps(const PlottedRun& run, const RowAxis& rows, const RunChartOptions& options, RunChart& made) {
  constexpr double kRow = 4, kMost = 420;  // height of a taxel and of the axes [points]
  const std::vector<PlottedTaxel> taxels = heat_map_taxels(run, options);
  if (made.taxels.empty()) made.taxels = taxels;
  for (const UnitGroup& group : groups_by_unit(run, taxels)) {
    made.chart.panels.push_back(heat_map_panel(run, rows, group));
    made.chart.axes.y = std::max(made.chart.axes.y, std::min(kMost, kRow * static_cast<double>(group.taxels.size())));
  }
}

}  // namespace

RunChart run_chart(const PlottedRun& run, const RunChartOptions& options) {
  RunChart made;
  made.notes = run.notes;
  const RowAxis rows = row_axis(run, options.over);
  made.is_over_travel = rows.is_travel;
  made.chart.title = run.file;
  made.chart.max_legend_columns = 3;
  const bool has_readings =
      options.has_readings || !(options.has_normalised || options.has_heat_map || options.has_forces);
  if (has_readings || options.has_normalised) {
    const std::vector<PlottedTaxel> all = taxels_of(run, options, true);
    made.taxels = chosen_taxels(run, options, all, peaks_of(all));
    if (made.taxels.empty()) made.notes.emplace_back("no taxel responds: all readings are 0");
    if (made.taxels.size() > kCurveStyles)
      made.notes.push_back(fmt::format(
          "the looks of {} curves repeat: --heat-map shows many taxels, --taxels chooses some", made.taxels.size()));
    for (const UnitGroup& group : groups_by_unit(run, made.taxels)) {
      if (options.has_normalised) made.chart.panels.push_back(readings_panel(run, rows, group, true));
      if (has_readings) made.chart.panels.push_back(readings_panel(run, rows, group, false));
    }
  }
  if (options.has_heat_map) add_heat_maps(run, rows, options, made);
  if (options.has_forces) made.chart.panels.push_back(forces_panel(run, rows, options));
  share_x_axis(made.chart);
  return made;
}

namespace {

constexpr PagePoint kSmallAxes{170, 110};  // axes of one run [points]

void expect_same_taxels(const PlottedRun& run, const PlottedRun& first) {
  const auto is_same = [](const PlottedSensor& a, const PlottedSensor& b) {
    return a.geom == b.geom && a.unit == b.unit && a.taxel_ids == b.taxel_ids;
  };
  if (!std::equal(run.sensors.begin(), run.sensors.end(), first.sensors.begin(), first.sensors.end(), is_same))
    throw Error(run.file, "has other taxels or units than " + first.file);
}

/// The taxels of a study and the ends of the axes of all runs.
struct StudyExtent {
  std::vector<PlottedTaxel> taxels;
  double lowest = 0, highest = 0;  ///< smallest and largest reading
  double x_low = 0, x_high = 0;    ///< ends of time [s] or travel [m]
};

StudyExtent extent_of(const std::vector<StudiedRun>& runs, const RunChartOptions& options, bool is_travel) {
  const PlottedRun& first = runs.front().run;
  const std::vector<PlottedTaxel> all = taxels_of(first, options, true);
  std::vector<double> peaks(all.size(), 0);
  StudyExtent extent;
  extent.x_low = is_travel ? first.travel.front() : first.time.front();
  extent.x_high = extent.x_low;
  for (const StudiedRun& one : runs) {
    expect_same_taxels(one.run, first);
    const std::vector<double>& x = is_travel ? one.run.travel : one.run.time;
    const auto [low, high] = std::minmax_element(x.begin(), x.end());
    extent.x_low = std::min(extent.x_low, *low), extent.x_high = std::max(extent.x_high, *high);
    const std::vector<PlottedTaxel> own = taxels_of(one.run, options, true);
    for (std::size_t i = 0; i < all.size(); ++i) peaks[i] = std::max(peaks[i], std::abs(own[i].peak));
  }
  extent.taxels = chosen_taxels(first, options, all, peaks);
  for (const PlottedTaxel& taxel : extent.taxels) {
    if (first.sensors[taxel.sensor].unit != first.sensors[extent.taxels.front().sensor].unit)
      throw Error(first.file, "has sensors of different units: choose one with --sensor");
    for (const StudiedRun& one : runs)
      for (const double value : one.run.sensors[taxel.sensor].readings[taxel.taxel])
        extent.lowest = std::min(extent.lowest, value), extent.highest = std::max(extent.highest, value);
  }
  if (!(extent.x_high > extent.x_low)) extent.x_high = extent.x_low + 1;
  return extent;
}

}  // namespace

RunChart study_chart(const std::vector<StudiedRun>& runs, std::size_t columns, const RunChartOptions& options) {
  constexpr double kAbove = 1.08;
  RunChart made;
  made.is_over_travel = options.over == PlotAxis::travel;
  const StudyExtent extent = extent_of(runs, options, made.is_over_travel);
  made.taxels = extent.taxels;
  made.notes = runs.front().run.notes;
  if (made.taxels.empty()) made.notes.emplace_back("no taxel responds: all readings are 0");
  Chart& chart = made.chart;
  chart.title = runs.front().run.file;
  chart.columns = std::max<std::size_t>(1, columns);
  chart.axes = kSmallAxes;
  chart.max_legend_columns = 3;
  const double largest = std::max(-extent.lowest, extent.highest);
  const std::string si = extent.taxels.empty() ? "" : runs.front().run.sensors[extent.taxels.front().sensor].unit;
  const PlotUnit unit =
      options.has_normalised ? PlotUnit{"", largest > kMinPlotted ? 1 / largest : 1} : plot_unit(si, largest);
  const double x_scale = made.is_over_travel ? 1e3 : 1;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    ChartPanel panel;
    panel.title = runs[i].title;
    panel.x = {x_scale * extent.x_low, x_scale * extent.x_high, made.is_over_travel ? "travel (mm)" : "time (s)",
               i + chart.columns >= runs.size()};
    panel.y = {
        kAbove * unit.scale * extent.lowest, largest > 0 ? kAbove * unit.scale * std::max(0.0, extent.highest) : 1,
        options.has_normalised ? "reading / largest" : named_with_unit("reading", unit.text), i % chart.columns == 0};
    for (std::size_t k = 0; k < extent.taxels.size(); ++k) {
      const PlottedTaxel& taxel = extent.taxels[k];
      ChartCurve curve{{made.is_over_travel ? runs[i].run.travel : runs[i].run.time,
                        runs[i].run.sensors[taxel.sensor].readings[taxel.taxel]},
                       numbered_style(k)};
      for (double& x : curve.points.x) x *= x_scale;
      for (double& y : curve.points.y) y *= unit.scale;
      panel.curves.push_back(std::move(curve));
      if (i == std::min(runs.size(), chart.columns) - 1) panel.legend.push_back({taxel.label, numbered_style(k)});
    }
    chart.panels.push_back(std::move(panel));
  }
  return made;
}

}  // namespace taxel
