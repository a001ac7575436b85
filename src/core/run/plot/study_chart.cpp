// The runs of a study as small panels.
#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/run/plot/chosen_taxels.h"
#include "core/run/plot/curve_styles.h"
#include "core/run/plot/plot_units.h"
#include "core/run/plot/run_chart.h"

namespace taxel {
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
