// The quantities of the plot: which sensors have them, their units and axes, and the reasons for missing ones.
#include "app/studio/nouns/plot/plot_state.h"

#include <gtest/gtest.h>

#include "app/studio/nouns/table/table_rows.h"
#include "ui/tools/hand_frame.h"

namespace taxel::ui {
namespace {

using test::run_of;

/// Returns a hand whose index has neither shear nor slip, and whose thumb has both.
RunView hand() {
  RunView run = run_of({{"index", {500, 0}}, {"thumb", {900, 200}}});
  const auto frame = std::make_shared<SimFrame>(*run.frame);
  frame->sensors[1].shear = {{3, 4}, {-1, 0}};
  frame->sensors[1].slip = {0.25, 1};
  run.frame = frame;
  return run;
}

/// Returns the curves of one row of that hand.
PlotCurves curves_of(const RunView& run, PlotQuantity quantity) {
  TraceRow row{0, 0, {500, 0, 900, 200}};
  row.shear = {0, 0, 5, 1};
  row.slip = {0, 0, 0.25, 1};
  PlotCurves curves;
  update_curves(curves, Trace{{row}}, run.by_travel(), quantity);
  return curves;
}

TEST(WhyMissing, IsEmptyIfOneSensorHasTheQuantity) {
  const RunView two = hand(), one = run_of({{"index", {0, 0}}});
  for (const PlotQuantity quantity : kPlotQuantities) EXPECT_EQ(why_missing(sensors_shown(two), quantity), "");
  EXPECT_EQ(why_missing(sensors_shown(one), PlotQuantity::reading), "");
  EXPECT_NE(why_missing(sensors_shown(one), PlotQuantity::slip).find("Tangential stiffness"), std::string::npos);
  EXPECT_NE(why_missing(sensors_shown(one), PlotQuantity::shear).find("Readout > Shear"), std::string::npos);
}

TEST(AvailableQuantity, IsTheReadingIfNoSensorHasTheWantedOne) {
  const RunView two = hand(), one = run_of({{"index", {0, 0}}});
  EXPECT_EQ(available_quantity(sensors_shown(two), PlotQuantity::slip), PlotQuantity::slip);
  EXPECT_EQ(available_quantity(sensors_shown(one), PlotQuantity::slip), PlotQuantity::reading);
}

TEST(ChooseCurves, LeavesOutSensorsWithoutTheQuantity) {
  const RunView run = hand();
  PlotCurves curves = curves_of(run, PlotQuantity::slip);
  const PlotChoice choice = choose_curves(curves, sensors_shown(run), {}, {}, {});
  ASSERT_EQ(choice.curves.size(), 2U);
  EXPECT_EQ(choice.curves[0].label, "thumb 1");
  EXPECT_EQ(choice.without, 1);
  EXPECT_EQ(choice.other_units, 0);
  EXPECT_STREQ(choice.unit.text, "%");
  EXPECT_EQ(in_unit(0.25, choice.unit), "25.0 %");
}

TEST(PlotAxes, EndSlipAboveOneHundredPercentAndNeverDivideIt) {
  const RunView run = hand();
  PlotCurves slip = curves_of(run, PlotQuantity::slip), shear = curves_of(run, PlotQuantity::shear);
  const PlotChoice shares = choose_curves(slip, sensors_shown(run), {}, {}, {}),
                   frictions = choose_curves(shear, sensors_shown(run), {}, {}, {});
  EXPECT_FALSE(shares.relative);
  const PlotAxes axes = plot_axes(run, shares, shares.relative);
  EXPECT_EQ(axes.y_name, "field that slips (%)");
  EXPECT_NEAR(axes.y_end, 108, 1e-9);
  EXPECT_TRUE(frictions.relative);
  EXPECT_EQ(frictions.largest, 5);
  EXPECT_EQ(plot_axes(run, frictions, true).y_name, "shear / largest");
  EXPECT_EQ(plot_axes(run, frictions, false).y_name, "shear (kPa)");
}

TEST(SensorRows, SortByShearAndSlip) {
  const RunView run = hand();
  TableState table;
  table.descending = true;
  for (const auto& [column, taxel] : {std::pair(TableColumn::shear, 0U), std::pair(TableColumn::slip, 1U)}) {
    table.sorted = column;
    EXPECT_EQ(sensor_rows(table, sensors_shown(run)).front(), (SensorRow{1, taxel}));
  }
}

}  // namespace
}  // namespace taxel::ui
