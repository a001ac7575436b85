// The curves of the plot: axes, peaks, scale, and curves that lie on each other.
#include <gtest/gtest.h>

#include "app/studio/nouns/plot/plot_state.h"

namespace taxel::ui {
namespace {

/// Three rows of two readings, 0.5 mm and 0.1 s apart.
Trace three_rows() {
  Trace trace;
  trace.rows = {{0.0, 0.0, {0, 10}, {}}, {0.1, 0.0005, {40, 10}, {}}, {0.2, 0.001, {20, 30}, {}}};
  for (TraceRow& row : trace.rows) row.quality = SampleQuality::polished;
  return trace;
}

TEST(UpdateCurves, UseMillimetresOfTravelOrSeconds) {
  PlotCurves curves;
  update_curves(curves, three_rows(), true);
  EXPECT_EQ(curves.x, (std::vector<double>{0, 0.5, 1}));
  update_curves(curves, three_rows(), false);
  EXPECT_EQ(curves.x, (std::vector<double>{0, 0.1, 0.2}));
}

TEST(UpdateCurves, FindThePeakOfEachReading) {
  PlotCurves curves;
  update_curves(curves, three_rows(), false);
  EXPECT_EQ(curves.readings, (std::vector<std::vector<double>>{{0, 40, 20}, {10, 10, 30}}));
  EXPECT_EQ(curves.peaks, (std::vector<double>{40, 30}));
  EXPECT_EQ(curves.largest, 40);
}

TEST(UpdateCurves, FillMissingReadingsWithZero) {
  Trace trace = three_rows();
  trace.rows[1].readings.pop_back();
  PlotCurves curves;
  update_curves(curves, trace, false);
  EXPECT_EQ(curves.readings[1], (std::vector<double>{10, 0, 30}));
}

TEST(UpdateCurves, MarkTheFirstRowOfPolishedSamples) {
  Trace trace = three_rows();
  PlotCurves curves;
  update_curves(curves, trace, false);
  EXPECT_FALSE(curves.polished_from) << "all rows are";
  trace.edition = 1;
  trace.rows[0].quality = trace.rows[1].quality = SampleQuality::preview;
  update_curves(curves, trace, false);
  EXPECT_EQ(curves.polished_from, 0.2);
}

TEST(UpdateCurves, GrowOnlyWithNewRows) {
  Trace trace = three_rows();
  PlotCurves curves;
  update_curves(curves, trace, false);
  EXPECT_TRUE(curves.is_growing);
  update_curves(curves, trace, false);
  EXPECT_FALSE(curves.is_growing);
  trace.rows.push_back({0.3, 0.0015, {90, 0}, SampleQuality::polished});
  update_curves(curves, trace, false);
  EXPECT_TRUE(curves.is_growing);
  EXPECT_EQ(curves.largest, 90);
}

TEST(UpdateCurves, ReadTheChosenQuantityFromTheStart) {
  Trace trace = three_rows();
  trace.rows[0].slip = {0, 0}, trace.rows[1].slip = {0.25, 1};  // the third row has no slip
  trace.rows[1].shear = {7, 0};
  PlotCurves curves;
  update_curves(curves, trace, false);
  update_curves(curves, trace, false, PlotQuantity::slip);
  EXPECT_EQ(curves.readings, (std::vector<std::vector<double>>{{0, 0.25, 0}, {0, 1, 0}}));
  EXPECT_EQ(curves.peaks, (std::vector<double>{0.25, 1}));
  update_curves(curves, trace, false, PlotQuantity::shear);
  EXPECT_EQ(curves.readings[0], (std::vector<double>{0, 7, 0}));
  EXPECT_EQ(curves.largest, 7);
  update_curves(curves, trace, false);
  EXPECT_EQ(curves.readings[0], (std::vector<double>{0, 40, 20}));
}

TEST(DrawnCurve, MultipliesReadingsByTheScale) {
  PlotCurves curves;
  update_curves(curves, three_rows(), false);
  EXPECT_EQ(drawn_curve(curves, 0, 0.001, 0, 0.5).y, (std::vector<double>{0, 20, 10}));
  EXPECT_EQ(drawn_curve(curves, 0, 0.001, 0, 2).y, (std::vector<double>{0, 80, 40})) << "another scale";
}

TEST(LeadersAmong, LetEqualCurvesFollowTheFirst) {
  Trace trace = three_rows();
  for (TraceRow& row : trace.rows) row.readings = {row.readings[0], row.readings[1], row.readings[0]};
  PlotCurves curves;
  update_curves(curves, trace, false);
  EXPECT_EQ(leaders_among(curves, {0, 1, 2}), (std::vector<int>{-1, -1, 0}));
  EXPECT_EQ(leaders_among(curves, {1, 2}), (std::vector<int>{-1, -1})) << "the first one is not drawn";
}

}  // namespace
}  // namespace taxel::ui
