#include "app/studio/nouns/plot/plot_curves.h"

#include <algorithm>

#include "core/run/recording/curve_pairs.h"

namespace taxel::ui {

namespace {

double x_of(const TraceRow& row, bool by_travel) {
  return by_travel ? 1e3 * row.travel : row.time;
}

}  // namespace

void update_curves(PlotCurves& curves, const Trace& trace, bool by_travel, PlotQuantity quantity) {
  const std::vector<TraceRow>& rows = trace.rows;
  const bool same = curves.edition == trace.edition && curves.by_travel == by_travel && curves.quantity == quantity &&
                    curves.x.size() <= rows.size();
  const std::size_t known = same ? curves.x.size() : 0;
  curves.is_growing = !same || known != rows.size();
  if (!curves.is_growing) return;
  if (known == 0) {
    curves = {};
    curves.edition = trace.edition;
    curves.by_travel = by_travel;
    curves.quantity = quantity;
    curves.is_growing = true;
    const std::size_t readings = rows.empty() ? 0 : rows.front().readings.size();
    curves.readings.resize(readings);
    curves.peaks.assign(readings, 0.0);
  }
  for (std::size_t r = known; r < rows.size(); ++r) {
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

const std::vector<int>& leaders_among(PlotCurves& curves, const std::vector<std::size_t>& readings,
                                      const std::function<std::vector<int>()>& twins) {
  constexpr double kFewRows = 1.1;  // growth of the rows before a new search, which costs time for every row
  const auto rows = static_cast<double>(curves.x.size()), looked_at = static_cast<double>(curves.paired_rows);
  const bool is_recent = rows == looked_at || (curves.is_growing && rows > looked_at && rows < kFewRows * looked_at);
  if (curves.paired == readings && is_recent) return curves.leaders;
  std::vector<std::span<const double>> lines;
  for (const std::size_t reading : readings) lines.emplace_back(curves.readings[reading]);
  curves.leaders = find_leaders(lines, twins ? twins() : std::vector<int>{});
  curves.paired = readings;
  curves.paired_rows = curves.x.size();
  return curves.leaders;
}

}  // namespace taxel::ui
