// Curves of long traces: no row is omitted, and the drawn curve contains every extreme value.
#include "app/studio/nouns/plot/plot_state.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/rng.h"

namespace taxel::ui {
namespace {

constexpr double kStep = 1e-3;  // [s]

/// Returns slow waves with occasional spikes of one row.
Trace trace_with_spikes(std::size_t rows, std::size_t taxels) {
  const CounterRng rng(7);
  std::uint64_t n = 0;
  Trace trace;
  trace.rows.resize(rows);
  for (std::size_t r = 0; r < rows; ++r) {
    TraceRow& row = trace.rows[r];
    row.time = kStep * static_cast<double>(r);
    row.travel = 2 * row.time;
    for (std::size_t k = 0; k < taxels; ++k) {
      const bool spike = rng.uniform(n++) < 1e-4;
      row.readings.push_back(100 * (1 + std::sin(0.3 * row.time + static_cast<double>(k))) +
                             (spike ? 5000 * rng.uniform(n++) : 0));
    }
  }
  return trace;
}

TEST(PlotCurves, DrawEveryExtremeOfALongTrace) {
  constexpr std::size_t kRows = 100000, kTaxels = 3;
  const Trace trace = trace_with_spikes(kRows, kTaxels);
  PlotCurves curves;
  update_curves(curves, trace, false);
  ASSERT_EQ(curves.x.size(), kRows);
  constexpr int kColumns = 600;
  const double column = trace.rows.back().time / kColumns, tolerance = 0.1, scale = 1e-3;
  for (std::size_t k = 0; k < kTaxels; ++k) {
    const CurvePoints& drawn = drawn_curve(curves, k, column, 1e-3 * tolerance, scale);
    EXPECT_LE(drawn.x.size(), 4U * (kColumns + 1));
    std::vector<double> highest(kColumns + 1, 0), shown(kColumns + 1, 0);
    const auto column_of = [&](double x) { return static_cast<std::size_t>(std::floor(x / column)); };
    for (const TraceRow& row : trace.rows) {
      double& most = highest[column_of(row.time)];
      most = std::max(most, row.readings[k]);
    }
    for (std::size_t i = 0; i < drawn.x.size(); ++i) {
      double& most = shown[column_of(drawn.x[i])];
      most = std::max(most, drawn.y[i] / scale);
    }
    double peak = 0;
    for (std::size_t c = 0; c < highest.size(); ++c) {
      if (highest[c] > 250) {
        EXPECT_NEAR(shown[c], highest[c], tolerance + 1e-9) << "spike in column " << c;
      }
      peak = std::max(peak, highest[c]);
    }
    EXPECT_EQ(curves.peaks[k], peak);
  }
  EXPECT_EQ(curves.largest, *std::max_element(curves.peaks.begin(), curves.peaks.end()));
}

TEST(PlotCurves, AreRebuiltForOtherRowsAndOtherAxes) {
  Trace trace = trace_with_spikes(50, 1);
  PlotCurves curves;
  update_curves(curves, trace, true);
  EXPECT_EQ(curves.x.back(), 1e3 * trace.rows.back().travel);
  const double first = drawn_curve(curves, 0, 1e-6, 0, 1).y.back();
  EXPECT_EQ(first, trace.rows.back().readings[0]);
  EXPECT_EQ(drawn_curve(curves, 0, 1e-6, 0, 2).y.back(), 2 * first);
  trace.rows.push_back({1, 2, {7}});
  update_curves(curves, trace, true);
  EXPECT_EQ(drawn_curve(curves, 0, 1e-6, 0, 2).y.back(), 14);
  update_curves(curves, trace, false);
  EXPECT_EQ(curves.x.back(), 1);
}

/// A run that continues adds rows. A run that resumes from an earlier step replaces the last rows.
TEST(PlotCurves, GiveTheSameCurveForAddedAndReplacedRows) {
  const Trace all = trace_with_spikes(3000, 2);
  const auto same = [](const PlotCurves& a, const PlotCurves& b) {
    EXPECT_EQ(a.x, b.x);
    EXPECT_EQ(a.readings, b.readings);
    EXPECT_EQ(a.peaks, b.peaks);
    EXPECT_EQ(a.largest, b.largest);
    EXPECT_EQ(a.polished_from, b.polished_from);
  };
  const auto made_of = [](const Trace& trace) {
    PlotCurves curves;
    update_curves(curves, trace, false);
    return curves;
  };
  Trace more = all, first;
  for (std::size_t r = 0; r < 1200; ++r) more.rows[r].quality = SampleQuality::preview;
  first = {{more.rows.begin(), more.rows.begin() + 1200}, more.edition};
  PlotCurves curves = made_of(first);
  update_curves(curves, more, false);
  same(curves, made_of(more));
  ASSERT_TRUE(curves.polished_from);
  EXPECT_EQ(*curves.polished_from, more.rows[1200].time);
  Trace other{more.rows, more.edition + 1};
  other.rows[3].readings[1] = 9000;  // far before the end
  update_curves(curves, other, false);
  same(curves, made_of(other));
  EXPECT_EQ(curves.largest, 9000);
  const Trace later{{all.rows.begin() + 500, all.rows.end()}, more.edition + 2}, none{{}, more.edition + 3};
  update_curves(curves, later, false);
  same(curves, made_of(later));
  update_curves(curves, none, false);
  EXPECT_TRUE(curves.x.empty());
  EXPECT_EQ(curves.largest, 0);
}

}  // namespace
}  // namespace taxel::ui
