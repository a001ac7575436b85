// The geometry of charts: ticks, clipping, places of axes and legends.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/base/page/chart.h"
#include "core/base/page/curve.h"
#include "core/base/rng.h"

namespace taxel {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

TEST(AxisTicks, AreMultiplesOfOneTwoOrFive) {
  EXPECT_EQ(axis_ticks(0, 24, 6).values, (std::vector<double>{0, 5, 10, 15, 20}));
  EXPECT_EQ(axis_ticks(0, 1, 5).values.size(), 6U);
  EXPECT_EQ(axis_ticks(-3, 7, 5).values, (std::vector<double>{-2, 0, 2, 4, 6}));
  for (const double end : {1e-3, 0.7, 3.3, 99.0, 1e6, 1e-90})
    for (const int most : {3, 6, 8}) {
      const AxisTicks ticks = axis_ticks(0.1 * end, end, most);
      EXPECT_LE(ticks.values.size(), static_cast<std::size_t>(most) + 1) << end;
      EXPECT_GE(ticks.values.size(), 2U) << end;
      const double digit = ticks.step / std::pow(10, std::floor(std::log10(ticks.step) + 1e-9));
      EXPECT_LT(std::min({std::abs(digit - 1), std::abs(digit - 2), std::abs(digit - 5)}), 1e-9) << ticks.step;
      EXPECT_GE(ticks.values.front(), 0.1 * end * (1 - 1e-9));
      EXPECT_LE(ticks.values.back(), end * (1 + 1e-9));
    }
}

TEST(AxisTicks, AreTheEndOfAnEmptyRange) {
  EXPECT_EQ(axis_ticks(0, 0, 5).values, std::vector<double>{0});
  EXPECT_EQ(axis_ticks(4, 4, 5).values, std::vector<double>{4});
  EXPECT_EQ(axis_ticks(0, 5e-324, 5).values, std::vector<double>{0});
  EXPECT_EQ(axis_ticks(0, 5e-324, 1).values, std::vector<double>{0}) << "a step of 0";
  EXPECT_LE(axis_ticks(1e15, 1e15 + 0.125, 4).values.size(), 13U) << "steps below the rounding error end";
  EXPECT_EQ(axis_ticks(0.07, 0.7, 3).values, (std::vector<double>{0.2, 0.4, 0.6000000000000001})) << "not 0.5 alone";
}

TEST(AxisTicks, HaveTextsWithEqualDecimals) {
  EXPECT_EQ(tick_texts(axis_ticks(0, 1, 5)), (std::vector<std::string>{"0.0", "0.2", "0.4", "0.6", "0.8", "1.0"}));
  EXPECT_EQ(tick_texts(axis_ticks(0, 40, 4)), (std::vector<std::string>{"0", "10", "20", "30", "40"}));
  EXPECT_EQ(tick_texts(axis_ticks(1000.25, 1000.5, 2)).front(), "1000.3");
  EXPECT_EQ(tick_texts(axis_ticks(0, 4e-7, 2)).back(), "4e-07");
}

TEST(ClipCurve, CutsALineAtTheBounds) {
  const CurvePoints cut = clip_curve({{-1, 1, 3}, {-1, 1, 3}}, {0, 2, 0, 2});
  EXPECT_EQ(cut.x.front(), 0);
  EXPECT_EQ(cut.y.front(), 0);
  const std::size_t finite =
      static_cast<std::size_t>(std::count_if(cut.x.begin(), cut.x.end(), [](double x) { return std::isfinite(x); }));
  EXPECT_EQ(finite, 3U) << "both ends and the middle";
  EXPECT_EQ(cut.x[2], 2);
}

TEST(ClipCurve, SeparatesParts) {
  const CurvePoints cut = clip_curve({{0, 1, 2, 3, 4}, {0, 5, 0, 5, 0}}, {0, 4, 0, 1});
  EXPECT_EQ(std::count_if(cut.x.begin(), cut.x.end(), [](double x) { return std::isnan(x); }), 2);
  const CurvePoints gap = clip_curve({{0, 1, 2, 3}, {0.5, kNaN, 0.5, 0.5}}, {0, 3, 0, 1});
  EXPECT_EQ(gap.x.back(), 3);
  EXPECT_EQ(gap.x[gap.x.size() - 2], 2);
  EXPECT_TRUE(clip_curve({{0, 1}, {5, 6}}, {0, 1, 0, 1}).x.empty());
}

TEST(ClipCurve, LeavesNoPointOutsideOfTheBounds) {
  const CounterRng rng(7);
  std::uint64_t drawn = 0;
  for (int round = 0; round < 200; ++round) {
    CurvePoints curve;
    for (int i = 0; i < 30; ++i)
      curve.x.push_back(i + rng.uniform(drawn++)), curve.y.push_back(8 * rng.uniform(drawn++) - 4);
    const CurvePoints cut = clip_curve(curve, {5, 20, -1, 2});
    ASSERT_FALSE(cut.x.empty());
    for (std::size_t i = 0; i < cut.x.size(); ++i) {
      if (std::isnan(cut.x[i])) continue;
      EXPECT_GE(cut.x[i], 5 - 1e-9);
      EXPECT_LE(cut.x[i], 20 + 1e-9);
      EXPECT_GE(cut.y[i], -1 - 1e-9);
      EXPECT_LE(cut.y[i], 2 + 1e-9);
    }
  }
}

/// Returns a chart of one curve per label.
Chart labelled_chart(std::size_t curves, const std::string& label) {
  Chart chart;
  chart.panels.emplace_back();
  ChartPanel& panel = chart.panels.back();
  panel.x = {0, 50, "travel (mm)", true}, panel.y = {0, 4.5, "reading (kPa)", true};
  for (std::size_t i = 0; i < curves; ++i) {
    panel.curves.push_back({{{0, 25, 50}, {0, 4.5, 0}}, {}});
    panel.legend.push_back({label + std::to_string(i), {}});
  }
  return chart;
}

/// Fails if an entry of the legend covers the axes, another entry or the edge of the page.
void expect_separate_legend(const Chart& chart) {
  const ChartLayout layout = lay_out_chart(chart);
  const PanelPlace& place = layout.panels.front();
  for (std::size_t i = 0; i < place.legend_entries; ++i) {
    const PagePoint at = place.legend_at(i);
    const double width = kLegendSwatch + kLegendGap + kChartText * helvetica_width(chart.panels[0].legend[i].label);
    EXPECT_GT(at.x, place.right) << i;
    EXPECT_LE(at.x + width, layout.width + 1e-9) << i;
    EXPECT_LE(at.y + kLegendRow, layout.height) << i;
    const double earlier = i < place.legend_rows ? 0 : place.legend_at(i - place.legend_rows).x + width;
    EXPECT_GE(at.x, earlier - 3) << i;
  }
}

TEST(ChartLayout, PutsTheLegendNextToTheAxes) {
  for (const std::size_t curves : {1U, 4U, 17U, 18U, 60U, 256U}) {
    Chart chart = labelled_chart(curves, "left side high ");
    expect_separate_legend(chart);
    EXPECT_EQ(lay_out_chart(chart).panels[0].legend_entries, curves);
    chart.page = PagePoint{450, 255};
    expect_separate_legend(chart);
    EXPECT_EQ(lay_out_chart(chart).width, 450);
    EXPECT_GE(lay_out_chart(chart).panels[0].right - lay_out_chart(chart).panels[0].left, 150) << curves;
  }
}

TEST(ChartLayout, LimitsTheLegendAndCountsTheRest) {
  Chart chart = labelled_chart(256, "taxel ");
  chart.max_legend_columns = 3;
  EXPECT_EQ(lay_out_chart(chart).panels[0].legend_entries, 60U);
  EXPECT_NE(page_to_svg(chart_page(chart)).find(">and 197 more<"), std::string::npos) << "59 are named";
}

TEST(ChartLayout, AlignsTheAxesOfAGrid) {
  Chart chart = labelled_chart(3, "taxel ");
  chart.columns = 2;
  for (int i = 0; i < 4; ++i) chart.panels.push_back(chart.panels.front()), chart.panels.back().legend.clear();
  chart.panels[2].title = "depth 0.001";
  chart.heading = "study";
  const ChartLayout layout = lay_out_chart(chart);
  ASSERT_EQ(layout.panels.size(), 5U);
  EXPECT_EQ(layout.panels[0].top, layout.panels[1].top);
  EXPECT_EQ(layout.panels[0].left, layout.panels[4].left);
  EXPECT_GT(layout.panels[1].left, layout.panels[0].right + 12 + 3 * 9) << "behind the legend";
  EXPECT_GT(layout.panels[2].top, layout.panels[0].bottom + 36) << "below the texts of the axis";
  EXPECT_EQ(layout.panels[3].right - layout.panels[3].left, 320);
}

TEST(ChartLayout, RefusesAPageWithoutRoomForAxes) {
  Chart chart = labelled_chart(1, "a very long name of a taxel ");
  chart.page = PagePoint{150, 150};
  EXPECT_THROW((void)lay_out_chart(chart), Error);
  chart.page = PagePoint{400, 60};
  EXPECT_THROW((void)lay_out_chart(chart), Error);
}

TEST(ChartPage, KeepsTheExtremesOfALongCurve) {
  Chart chart = labelled_chart(1, "taxel ");
  CurvePoints& points = chart.panels[0].curves[0].points;
  points = {};
  for (int i = 0; i < 100'000; ++i) points.x.push_back(i * 5e-4), points.y.push_back(1 + std::sin(0.7 * i));
  points.y[70'001] = 4.25;
  const Page page = chart_page(chart);
  EXPECT_LT(page_to_svg(page).size(), 150'000U);
  const PanelPlace place = lay_out_chart(chart).panels[0];
  double highest = place.bottom;
  for (const PageItem& item : page.items)
    if (const auto* line = std::get_if<PageLine>(&item); line != nullptr && line->points.size() > 100)
      for (const PagePoint& point : line->points) highest = std::min(highest, point.y);
  EXPECT_NEAR(highest, place.y(chart.panels[0].y, 4.25), 1e-9);
}

TEST(ChartPage, DrawsASinglePointAsASquare) {
  Chart chart = labelled_chart(1, "taxel ");
  chart.panels[0].curves[0].points = {{25}, {2}};
  std::size_t squares = 0;
  for (const PageItem& item : chart_page(chart).items)
    if (const auto* rect = std::get_if<PageRect>(&item)) squares += rect->b.x - rect->a.x == 4 ? 1 : 0;
  EXPECT_EQ(squares, 1U);
}

TEST(ChartPage, JoinsNeighbouringCellsOfOneColour) {
  Chart chart;
  chart.panels.emplace_back();
  chart.panels[0].x = {0, 4, "time (s)", true};
  chart.panels[0].cells =
      ChartCells{{0, 1, 2, 3, 4}, {"a", "b"}, {{0, 0, 5, 5}, {0, 10, 10, 10}}, 0, 10, "reading (Pa)"};
  const Page page = chart_page(chart);
  std::vector<PageRect> cells;
  const PanelPlace place = lay_out_chart(chart).panels[0];
  for (const PageItem& item : page.items)
    if (const auto* rect = std::get_if<PageRect>(&item);
        rect != nullptr && rect->a.x >= place.left && rect->b.x <= place.right)
      cells.push_back(*rect);
  ASSERT_EQ(cells.size(), 4U) << "background, the pair of the first row, two runs of the second";
  EXPECT_EQ(cells[1].a.x, place.x(chart.panels[0].x, 2));
  EXPECT_EQ(cells[1].b.x, place.right);
}

}  // namespace
}  // namespace taxel
