#include "ui/tools/plot_curves.h"

#include <algorithm>

namespace taxel::ui {

namespace {

/// Rows looked at to know that a trace goes on from the one before: more than a simulation that goes on from an
/// earlier step makes anew between two pictures.
constexpr std::size_t kLookBack = 1000;

double x_of(const TraceRow& row, bool by_travel) {
  return by_travel ? 1e3 * row.travel : row.time;
}

/// Whether the rows that are known are the first ones of the trace.
bool goes_on(const PlotCurves& curves, const std::vector<TraceRow>& trace, bool by_travel) {
  const std::size_t known = curves.x.size();
  if (known == 0 || known > trace.size() || trace.front().readings.size() != curves.readings.size()) return false;
  if (curves.x.front() != x_of(trace.front(), by_travel)) return false;
  for (std::size_t r = known - std::min(known, kLookBack); r < known; ++r) {
    if (curves.x[r] != x_of(trace[r], by_travel)) return false;
    for (std::size_t k = 0; k < curves.readings.size(); ++k)
      if (curves.readings[k][r] != trace[r].readings[k]) return false;
  }
  return true;
}

}  // namespace

void update_curves(PlotCurves& curves, const std::vector<TraceRow>& trace, bool by_travel) {
  if (curves.trace == &trace && curves.rows == trace.size()) return;
  const std::size_t readings = trace.empty() ? 0 : trace.front().readings.size();
  if (!goes_on(curves, trace, by_travel)) {
    curves = {};
    curves.readings.resize(readings);
    curves.peaks.assign(readings, 0.0);
  }
  const std::size_t known = curves.x.size();
  curves.trace = &trace;
  curves.rows = trace.size();
  for (std::size_t r = known; r < trace.size(); ++r) {
    const TraceRow& row = trace[r];
    curves.x.push_back(x_of(row, by_travel));
    for (std::size_t k = 0; k < readings; ++k) {
      curves.readings[k].push_back(k < row.readings.size() ? row.readings[k] : 0.0);
      curves.peaks[k] = std::max(curves.peaks[k], curves.readings[k].back());
    }
    if (r > 0 && trace[r - 1].quality == SampleQuality::preview && row.quality == SampleQuality::polished)
      curves.polished_from = curves.x.back();
  }
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
