#include "core/run/fit/fit_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/run/plot/curve_styles.h"

namespace taxel {
namespace {

constexpr double kMillimetres = 1e3;
constexpr std::size_t kColumns = 2;

/// The points of one taxel in a panel.
struct Series {
  CurvePoints measured, fitted;
};

/// Sets an axis to the range of some values with a margin.
void fit_axis(ChartAxis& axis, const std::vector<Series>& all, std::vector<double> CurvePoints::*values) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Series& series : all)
    for (const CurvePoints* points : {&series.measured, &series.fitted})
      for (const double value : points->*values) low = std::min(low, value), high = std::max(high, value);
  if (!(high > low)) low = low < high ? low : 0, high = low + 1;
  const double margin = 0.04 * (high - low);
  axis.low = low - margin, axis.high = high + margin;
}

ChartPanel panel_of(const RunAgreement& run, const PressedRecording& recording, const std::vector<Series>& all,
                    const std::string& x, const std::string& y) {
  ChartPanel panel;
  panel.title = fmt::format("{}{}: R2 {:.4f}", std::filesystem::path(recording.file).filename().string(),
                            run.is_held_out ? " (held out)" : "", run.r2);
  panel.x.name = x, panel.y.name = y;
  fit_axis(panel.x, all, &CurvePoints::x);
  fit_axis(panel.y, all, &CurvePoints::y);
  for (std::size_t t = 0; t < all.size(); ++t) {
    const LineStyle style = numbered_style(t);
    panel.rings.push_back({all[t].measured, style.color});
    const std::string taxel = fmt::format("taxel {}", run.taxels[t].taxel);
    LegendEntry entry{taxel + " recorded", style};
    entry.is_ring = true;
    panel.legend.push_back(entry);
    if (all[t].fitted.x.empty()) continue;
    panel.curves.push_back({all[t].fitted, style});
    panel.legend.push_back({taxel + " fitted", style});
  }
  return panel;
}

template <class PanelOf>
Chart chart_of(const RecordingFit& fit, const std::vector<PressedRecording>& recordings, const char* title,
               const PanelOf& panel) {
  Chart chart;
  chart.title = title;
  chart.columns = std::min(kColumns, fit.runs.size());
  for (std::size_t r = 0; r < fit.runs.size(); ++r) chart.panels.push_back(panel(fit.runs[r], recordings[r]));
  return chart;
}

/// The last point of each press of a taxel, ordered by place.
std::vector<const FitPoint*> tops_of(const RunAgreement& run, std::size_t taxel, int lateral) {
  std::vector<const FitPoint*> tops;
  for (const FitPoint& point : run.points) {
    if (point.taxel != taxel) continue;
    if (tops.empty() || tops.back()->press != point.press) tops.push_back(&point);
    tops.back() = &point;
  }
  std::stable_sort(tops.begin(), tops.end(), [&](const FitPoint* a, const FitPoint* b) {
    return a->displacement[lateral] < b->displacement[lateral];
  });
  return tops;
}

}  // namespace

Chart bells_chart(const RecordingFit& fit, const std::vector<PressedRecording>& recordings) {
  return chart_of(fit, recordings, "Readings across the taxels",
                  [&](const RunAgreement& run, const PressedRecording& recording) {
                    std::vector<Series> all(run.taxels.size());
                    for (std::size_t t = 0; t < all.size(); ++t)
                      for (const FitPoint* top : tops_of(run, t, recording.lateral_axis)) {
                        const double x = kMillimetres * top->displacement[recording.lateral_axis];
                        all[t].measured.x.push_back(x), all[t].measured.y.push_back(top->measured);
                        all[t].fitted.x.push_back(x), all[t].fitted.y.push_back(top->fitted);
                      }
                    return panel_of(run, recording, all, "place of the press [mm]", "value at the end of a press");
                  });
}

Chart loading_chart(const RecordingFit& fit, const std::vector<PressedRecording>& recordings, int axis) {
  return chart_of(
      fit, recordings, "Readings over the travel of a press",
      [&](const RunAgreement& run, const PressedRecording& recording) {
        std::vector<Series> all(run.taxels.size());
        for (std::size_t t = 0; t < all.size(); ++t) {
          const FitPoint* largest = nullptr;
          for (const FitPoint& point : run.points)
            if (point.taxel == t && (largest == nullptr || std::abs(point.measured) > std::abs(largest->measured)))
              largest = &point;
          for (const FitPoint& point : run.points) {
            if (point.taxel != t || point.press != largest->press) continue;
            const double x = kMillimetres * point.displacement[axis];
            all[t].measured.x.push_back(x), all[t].measured.y.push_back(point.measured);
            all[t].fitted.x.push_back(x), all[t].fitted.y.push_back(point.fitted);
          }
        }
        return panel_of(run, recording, all, "displacement along the press [mm]", "value");
      });
}

Chart residuals_chart(const RecordingFit& fit, const std::vector<PressedRecording>& recordings) {
  return chart_of(fit, recordings, "Errors over recorded values",
                  [&](const RunAgreement& run, const PressedRecording& recording) {
                    std::vector<Series> all(run.taxels.size());
                    for (const FitPoint& point : run.points) {
                      CurvePoints& of = all[point.taxel].measured;
                      of.x.push_back(100 * point.measured / run.largest);
                      of.y.push_back(100 * (point.measured - point.fitted) / run.largest);
                    }
                    return panel_of(run, recording, all, "recorded, % of the largest", "error, % of the largest");
                  });
}

std::string points_csv(const RecordingFit& fit, const std::vector<PressedRecording>& recordings) {
  std::string text = "run,press,row,x,y,z,taxel,measured,fitted,residual\n";
  auto out = std::back_inserter(text);
  for (std::size_t r = 0; r < fit.runs.size(); ++r)
    for (const FitPoint& p : fit.runs[r].points)
      fmt::format_to(out, "{},{},{},{},{},{},{},{},{},{}\n", r, p.press, p.row, p.displacement.x, p.displacement.y,
                     p.displacement.z, recordings[r].taxel_ids[p.taxel], p.measured, p.fitted, p.measured - p.fitted);
  return text;
}

}  // namespace taxel
