#include "ui/tools/plot_curves.h"

#include <algorithm>

namespace taxel::ui {

void update_curves(PlotCurves& curves, const std::vector<TraceRow>& trace, bool by_travel) {
  if (curves.trace == &trace && curves.rows == trace.size()) return;
  const auto x_of = [&](const TraceRow& row) { return by_travel ? 1e3 * row.travel : row.time; };
  const std::size_t readings = trace.empty() ? 0 : trace.front().readings.size();
  curves.trace = &trace;
  curves.rows = trace.size();
  curves.x.resize(trace.size());
  curves.readings.resize(readings);
  for (std::vector<double>& of_taxel : curves.readings) of_taxel.assign(trace.size(), 0.0);
  curves.polished_from.reset();
  for (std::size_t r = 0; r < trace.size(); ++r) {
    const TraceRow& row = trace[r];
    curves.x[r] = x_of(row);
    for (std::size_t k = 0; k < std::min(readings, row.readings.size()); ++k) curves.readings[k][r] = row.readings[k];
    if (r > 0 && trace[r - 1].quality == SampleQuality::preview && row.quality == SampleQuality::polished)
      curves.polished_from = curves.x[r];
  }
  curves.peaks.clear();
  for (const std::vector<double>& of_taxel : curves.readings)
    curves.peaks.push_back(of_taxel.empty() ? 0.0 : *std::max_element(of_taxel.begin(), of_taxel.end()));
  curves.largest = 0;
  for (const double peak : curves.peaks) curves.largest = std::max(curves.largest, peak);
  curves.drawn.assign(readings, {});
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

}  // namespace taxel::ui
