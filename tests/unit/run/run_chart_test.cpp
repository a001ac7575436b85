// Charts of runs: their columns from tables, the chosen taxels, axes, looks and cells.
#include "core/run/plot/run_chart.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/base/page/chart.h"
#include "core/run/plot/curve_styles.h"
#include "core/run/plot/plotted_run.h"

namespace taxel {
namespace {

using testing::HasSubstr;

/// Returns the message with which a table is refused.
std::string refusal_of_table(const std::string& text) {
  try {
    (void)parse_readings_csv(text, "r.csv");
  } catch (const Error& error) {
    return error.what();
  }
  return "accepted";
}

/// Returns a run of `rows` rows over 10 mm and 1 s whose taxels have bumps of these heights [Pa].
PlottedRun bumps(const std::vector<double>& heights, int rows = 101) {
  PlottedRun run{"r.npz", {}, {}, {{"finger", "Pa", {}, {}, {}, {}, {}}}, {}};
  for (int i = 0; i < rows; ++i) {
    const double t = static_cast<double>(i) / std::max(1, rows - 1);
    run.time.push_back(t), run.travel.push_back(0.01 * t);
    run.sensors[0].force_W.emplace_back(0, -t, 2 * t);
  }
  for (std::size_t k = 0; k < heights.size(); ++k) {
    run.sensors[0].taxel_ids.push_back(static_cast<int>(k));
    run.sensors[0].taxel_names.emplace_back(k == 1 ? "tip" : "");
    std::vector<double> readings;
    for (const double t : run.time)
      readings.push_back(heights[k] * std::exp(-80 * std::pow(t - 0.4 - 0.15 * static_cast<double>(k), 2)));
    run.sensors[0].readings.push_back(readings);
  }
  return run;
}

TEST(ReadingsTable, FindsColumnsByTheirNames) {
  const PlottedRun run = parse_readings_csv(
      "\xEF\xBB\xBFtravel,extra,\"a,b/taxel_7\",time,a/taxel_2,a/force_z,a/force_x,a/force_y\r\n"
      "0.5,x,1,0,2,3,4,5\r\n\r\n0.5,,-1e3,0.1,.5,6,7,8",
      "r.csv");
  ASSERT_EQ(run.sensors.size(), 2U);
  EXPECT_EQ(run.time, (std::vector<double>{0, 0.1}));
  EXPECT_EQ(run.sensors[0].geom, "a,b");
  EXPECT_EQ(run.sensors[0].readings[0], (std::vector<double>{1, -1000}));
  EXPECT_EQ(run.sensors[1].taxel_ids, std::vector<int>{2});
  EXPECT_EQ(run.sensors[1].force_W[1], dvec3(7, 8, 6));
  EXPECT_EQ(run.sensors[1].unit, "Pa");
  EXPECT_EQ(run.sensors[0].unit, "") << "no forces next to the readings";
}

TEST(ReadingsTable, NamesLineAndColumnOfAnError) {
  EXPECT_EQ(refusal_of_table("time,travel,taxel_0\n0,0,1\n1,0,x1\n"),
            "r.csv: line 3, column \"taxel_0\": must be a number up to 1e100, is \"x1\"");
  EXPECT_EQ(refusal_of_table("time,travel,taxel_0\n0,0,nan\n"),
            "r.csv: line 2, column \"taxel_0\": must be a number up to 1e100, is \"nan\"");
  EXPECT_EQ(refusal_of_table("time,travel,taxel_0\n0,0,\n"),
            "r.csv: line 2, column \"taxel_0\": must be a number up to 1e100, is \"\"");
  EXPECT_EQ(refusal_of_table("time,travel,taxel_0\n0,0,1,2\n"),
            "r.csv: line 2: has 4 fields, the header has 3 columns");
  EXPECT_EQ(refusal_of_table("time,travel,taxel_0\n1,0,1\n0.5,0,1\n"),
            "r.csv: line 3, column \"time\": must not decrease, is 0.5 after 1");
  EXPECT_EQ(refusal_of_table("time,taxel_0\n1,0\n"), "r.csv: line 1: has no column \"travel\"");
  EXPECT_EQ(refusal_of_table("time,travel,taxel_0,taxel_0\n"), "r.csv: line 1: has two columns \"taxel_0\"");
  EXPECT_EQ(refusal_of_table("time,travel,force_x\n0,0,0\n"),
            "r.csv: line 1: has no column of a taxel, such as \"taxel_0\"");
  EXPECT_EQ(refusal_of_table("time,travel,taxel_0\n"), "r.csv: has no row after its header");
  EXPECT_THAT(refusal_of_table(""), HasSubstr("must be the names of the columns"));
}

// Whiskers are vertical lines of the length of the bars, in the colours of their curves, at different rows.
TEST(RunChart, DrawsErrorBarsAsWhiskers) {
  PlottedRun run = bumps({1000, 800});
  const std::size_t plain = run_chart(run, {}).chart.panels[0].curves.size();
  run.sensors[0].errors.assign(2, std::vector<double>(101, 50.0));
  const std::vector<ChartCurve> curves = run_chart(run, {}).chart.panels[0].curves;
  ASSERT_GT(curves.size(), plain + 30);
  ASSERT_LE(curves.size(), plain + 40);
  for (std::size_t i = plain; i < curves.size(); ++i) {
    const CurvePoints& line = curves[i].points;
    ASSERT_EQ(line.x.size(), 2U);
    EXPECT_EQ(line.x[0], line.x[1]);
    EXPECT_NEAR(line.y[1] - line.y[0], 0.1, 1e-12) << "in kPa";
  }
  EXPECT_NE(curves[plain].style.color, curves.back().style.color);
  std::set<double> first, second;
  for (std::size_t i = plain; i < curves.size(); ++i)
    (curves[i].style.color == curves[plain].style.color ? first : second).insert(curves[i].points.x[0]);
  for (const double x : first) EXPECT_FALSE(second.contains(x)) << "whiskers of both curves at " << x;
}

TEST(RunChart, HasTheLargestReadingsOfEitherSignAsPeaks) {
  const RunChart made = run_chart(bumps({100, -4000, 150}), {});
  ASSERT_EQ(made.taxels.size(), 1U) << "the others respond with less than a twentieth of it";
  EXPECT_NEAR(made.taxels[0].peak, -4000, 1);
  EXPECT_EQ(made.taxels[0].peak_row, 55U);
  EXPECT_LT(made.chart.panels[0].y.low, -4);
}

/// Returns a run of our fingertip whose taxels have equal readings.
PlottedRun equal_twins(const std::vector<int>& ids) {
  PlottedRun run = bumps(std::vector<double>(12, 0.0));
  for (const int id : ids) {
    run.sensors[0].readings[static_cast<std::size_t>(id)] = bumps({1000}).sensors[0].readings[0];
  }
  run.sensors[0].layout_json = read_file(TAXEL_SOURCE_DIR "/assets/layouts/fingertip.taxels.json");
  return run;
}

// Taxels 3 and 9, 4 and 10 are mirror images of each other. All four curves are equal.
TEST(RunChart, PairsMirrorTwinsAlone) {
  const ChartPanel panel = run_chart(equal_twins({3, 4, 9, 10}), {}).chart.panels.at(0);
  ASSERT_EQ(panel.legend.size(), 4U);
  EXPECT_TRUE(panel.legend[0].style.dashes.empty());
  EXPECT_TRUE(panel.legend[1].style.dashes.empty()) << "the tip is no twin of the pad";
  EXPECT_FALSE(panel.legend[2].style.dashes.empty());
  EXPECT_FALSE(panel.legend[3].style.dashes.empty());
  EXPECT_NE(panel.legend[0].style.color, panel.legend[1].style.color);
  const ChartPanel alone = run_chart(equal_twins({3, 4}), {}).chart.panels.at(0);
  for (const LegendEntry& key : alone.legend) EXPECT_TRUE(key.style.dashes.empty()) << "two taxels of one side";
}

TEST(RunChart, PlotsTheRespondingTaxelsOverTravel) {
  const RunChart made = run_chart(bumps({4000, 1500, 150, 0}), {});
  EXPECT_TRUE(made.is_over_travel);
  ASSERT_EQ(made.taxels.size(), 2U);
  EXPECT_EQ(made.taxels[0].label, "taxel 0");
  EXPECT_EQ(made.taxels[1].label, "1 tip");
  const ChartPanel& panel = made.chart.panels.at(0);
  EXPECT_EQ(panel.x.name, "travel (mm)");
  EXPECT_EQ(panel.y.name, "reading (kPa)");
  EXPECT_EQ(panel.x.high, 10);
  EXPECT_NEAR(panel.y.high, 4.32, 1e-9);
  EXPECT_EQ(panel.curves.size(), 2U);
}

TEST(RunChart, PlotsOverTimeIfTheBodyRests) {
  PlottedRun run = bumps({40});
  for (std::size_t i = 50; i < run.travel.size(); ++i) run.travel[i] = run.travel[50];
  EXPECT_FALSE(run_chart(run, {}).is_over_travel);
  EXPECT_EQ(run_chart(run, {}).chart.panels[0].x.name, "time (s)");
  EXPECT_EQ(run_chart(run, {}).chart.panels[0].y.name, "reading (Pa)");
  RunChartOptions over;
  over.over = PlotAxis::travel;
  EXPECT_TRUE(run_chart(run, over).is_over_travel);
  run.travel.back() = -0.001;
  EXPECT_EQ(run_chart(run, over).chart.panels[0].x.low, -1) << "a body that moves back";
  over.has_heat_map = true;
  EXPECT_THROW((void)run_chart(run, over), Error);
}

TEST(RunChart, DividesByTheLargestReading) {
  RunChartOptions options;
  options.has_normalised = true;
  const RunChart made = run_chart(bumps({4000, 1000}), options);
  double largest = 0;
  for (const double y : made.chart.panels.at(0).curves.at(0).points.y) largest = std::max(largest, y);
  EXPECT_DOUBLE_EQ(largest, 1);
}

TEST(RunChart, ChoosesTaxelsByIdAndByName) {
  RunChartOptions options;
  options.taxels = {"tip", "finger/3"};
  const RunChart made = run_chart(bumps({4000, 1500, 150, 0}), options);
  ASSERT_EQ(made.taxels.size(), 2U);
  EXPECT_EQ(made.taxels[1].taxel, 3U);
  options.taxels = {"17"};
  EXPECT_THROW((void)run_chart(bumps({1, 2}), options), Error);
  options.taxels.clear();
  options.sensor = "thumb";
  EXPECT_THROW((void)run_chart(bumps({1, 2}), options), Error);
}

TEST(RunChart, DrawsRunsOfOneRowAndOfZeros) {
  RunChartOptions all;
  all.has_readings = all.has_normalised = all.has_heat_map = all.has_forces = all.has_all_taxels = true;
  for (const int rows : {1, 2, 1000}) {
    const RunChart made = run_chart(bumps({0, 0}, rows), all);
    const std::string svg = page_to_svg(chart_page(made.chart));
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    EXPECT_EQ(svg.find("inf"), std::string::npos);
    ASSERT_EQ(made.chart.panels.size(), 4U);
    for (const ChartPanel& panel : made.chart.panels) EXPECT_LT(panel.x.low, panel.x.high) << rows;
  }
  EXPECT_EQ(run_chart(bumps({0, 0}), {}).notes, std::vector<std::string>{"no taxel responds: all readings are 0"});
}

TEST(RunChart, KeepsTheExtremesOfManyRowsInCells) {
  PlottedRun run = bumps({0, 0}, 100'000);
  run.sensors[0].readings[1][77'777] = 900;
  RunChartOptions options;
  options.has_heat_map = true;
  const RunChart made = run_chart(run, options);
  const ChartCells& cells = *made.chart.panels.at(0).cells;
  ASSERT_EQ(cells.values[1].size() + 1, cells.edges.size());
  EXPECT_LE(cells.edges.size(), 401U);
  const auto peak = std::max_element(cells.values[1].begin(), cells.values[1].end());
  EXPECT_EQ(*peak, 900);
  const auto column = static_cast<std::size_t>(peak - cells.values[1].begin());
  EXPECT_LE(cells.edges[column], 7.7778);
  EXPECT_GE(cells.edges[column + 1], 7.7777);
}

TEST(RunChart, PutsReadingsOfDifferentUnitsOnDifferentAxes) {
  PlottedRun run = bumps({4000});
  run.sensors.push_back(run.sensors[0]);
  run.sensors[1].geom = "palm", run.sensors[1].unit = "N";
  const RunChart made = run_chart(run, {});
  ASSERT_EQ(made.chart.panels.size(), 2U);
  EXPECT_EQ(made.chart.panels[0].y.name, "reading (kPa)");
  EXPECT_EQ(made.chart.panels[1].y.name, "reading (kN)");
  EXPECT_EQ(made.taxels[1].label, "palm/0");
}

TEST(StudyChart, HasTheSameAxesAndLooksInAllPanels) {
  const std::vector<StudiedRun> runs{
      {bumps({4000, 10}), "depth 1"}, {bumps({10, 9000}), "depth 2"}, {bumps({0, 0}), "depth 3"}};
  const RunChart made = study_chart(runs, 2, {});
  ASSERT_EQ(made.chart.panels.size(), 3U);
  for (const ChartPanel& panel : made.chart.panels) {
    EXPECT_EQ(panel.y.high, made.chart.panels[0].y.high);
    EXPECT_EQ(panel.curves.size(), 2U);
    EXPECT_EQ(panel.curves[1].style.color, made.chart.panels[0].curves[1].style.color);
  }
  EXPECT_NEAR(made.chart.panels[0].y.high, 9.72, 1e-9);
  EXPECT_EQ(made.chart.panels[1].legend.size(), 2U) << "one legend, at the right of the first row";
  EXPECT_TRUE(made.chart.panels[0].legend.empty());
  std::vector<StudiedRun> other = runs;
  other[1].run.sensors[0].taxel_ids[0] = 5;
  EXPECT_THROW((void)study_chart(other, 2, {}), Error);
}

TEST(CurveStyles, DifferInColourOrDashes) {
  for (std::size_t i = 0; i < kCurveStyles; ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const LineStyle a = numbered_style(i), b = numbered_style(j);
      EXPECT_TRUE(a.color != b.color || a.dashes != b.dashes) << i << " " << j;
    }
}

TEST(CurveStyles, DrawFollowersAsDashesOverTheirLeader) {
  const std::vector<LineStyle> styles = paired_styles({-1, -1, 0, 0});
  EXPECT_GT(styles[0].width, styles[2].width);
  EXPECT_TRUE(styles[0].dashes.empty());
  EXPECT_FALSE(styles[2].dashes.empty());
  EXPECT_NE(styles[2].dash_start, styles[3].dash_start);
  EXPECT_EQ(paired_order({-1, 0, -1}), (std::vector<std::size_t>{0, 2, 1}));
}

TEST(PlotUnits, HaveThePrefixThatSuitsTheValues) {
  EXPECT_EQ(plot_unit("Pa", 999).text, "Pa");
  EXPECT_EQ(plot_unit("Pa", 4000).text, "kPa");
  EXPECT_EQ(plot_unit("Pa", 4e6).scale, 1e-6);
  EXPECT_EQ(plot_unit("N", 0.02).text, "mN");
  EXPECT_EQ(plot_unit("V", 4000).text, "V");
}

}  // namespace
}  // namespace taxel
