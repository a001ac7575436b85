// The close-up of the plot: its steps, its ends and the height of the magnified change.
#include "app/studio/nouns/plot/close_up.h"

#include <gtest/gtest.h>

#include "ui/tools/hand_frame.h"

namespace taxel::ui {
namespace {

using test::lanes_of;
using test::run_of;

constexpr double kHeightOfPlot = 200;  // [pixels]

/// Returns a run of 101 steps in which taxel 2 falls from `high` to `low` in step 50.
RunView falling_run(double high, double low) {
  std::vector<std::vector<double>> rows;
  for (int r = 0; r <= 100; ++r) rows.push_back({7, r < 50 ? high : low});
  return run_of({{"index", {7, low}}}, lanes_of(rows));
}

std::optional<CloseUpView> view_of_fall(const RunView& run, const ExactCurvePtr& exact) {
  return view_close_up(run, sensors_shown(run), {{0, 2}, 50}, exact, nullptr, 1e-3, kHeightOfPlot);
}

/// Returns the exact readings `value` in all steps.
ExactCurve exact_of(const RunView& run, double value) {
  ExactCurve exact{{{0, 2}, 50}, run.frame->scene, false, {}, ""};
  for (int r = 0; r <= 100; ++r) exact.curve.x.push_back(1e-3 * r), exact.curve.readings.push_back(value);
  return exact;
}
ExactCurvePtr shared(const ExactCurve& exact) {
  return std::make_shared<const ExactCurve>(exact);
}

TEST(CloseUp, HasTheStepsAroundTheChange) {
  const std::optional<CloseUpView> view = view_of_fall(falling_run(300, 200), nullptr);
  ASSERT_TRUE(view);
  EXPECT_EQ(view->readings.x.size(), 2 * kCloseUpSteps + 1);
  EXPECT_DOUBLE_EQ(view->bounds.x_low, 0.020);
  EXPECT_DOUBLE_EQ(view->bounds.x_high, 0.080);
  EXPECT_DOUBLE_EQ(view->from, 0.3);
  EXPECT_DOUBLE_EQ(view->to, 0.2);
}

TEST(CloseUp, HasAllCurvesIfTheChangeIsHighEnough) {
  const RunView run = falling_run(300, 200);
  const std::optional<CloseUpView> view = view_of_fall(run, shared(exact_of(run, 450)));
  ASSERT_TRUE(view);
  EXPECT_LT(view->bounds.y_low, 0.2);
  EXPECT_GT(view->bounds.y_high, 0.45);
  EXPECT_GE(view->change_height(kHeightOfPlot), kChangeHeight);
}

TEST(CloseUp, MagnifiesASmallChangeBetweenFarCurves) {
  const RunView run = falling_run(300, 290);
  const std::optional<CloseUpView> view = view_of_fall(run, shared(exact_of(run, 900)));
  ASSERT_TRUE(view);
  EXPECT_NEAR(view->change_height(kHeightOfPlot), kChangeHeight, 1e-9);
  EXPECT_LT(view->bounds.y_low, 0.290);
  EXPECT_GT(view->bounds.y_high, 0.300);
}

TEST(CloseUp, HasTheWholeChangeInALowPlot) {
  const RunView run = falling_run(300, 200);
  const auto view = view_close_up(run, sensors_shown(run), {{0, 2}, 50}, nullptr, nullptr, 1e-3, 20);
  ASSERT_TRUE(view);
  EXPECT_LT(view->bounds.y_low, 0.2);
  EXPECT_GT(view->bounds.y_high, 0.3);
}

TEST(CloseUp, LeavesOutTheExactReadingsOfAnotherStep) {
  const RunView run = falling_run(300, 200);
  ExactCurve other = exact_of(run, 450);
  other.of.step = 49;
  EXPECT_TRUE(view_of_fall(run, shared(other))->exact.x.empty());
}

TEST(CloseUp, IsEmptyWithoutTheTaxelOrItsSteps) {
  const RunView run = falling_run(300, 200);
  const auto sensors = sensors_shown(run);
  EXPECT_FALSE(view_close_up(run, sensors, {{0, 9}, 50}, nullptr, nullptr, 1, kHeightOfPlot)) << "no such taxel";
  EXPECT_FALSE(view_close_up(run, sensors, {{0, 2}, 101}, nullptr, nullptr, 1, kHeightOfPlot)) << "later than the run";
  EXPECT_FALSE(view_close_up(run, sensors, {{0, 2}, 0}, nullptr, nullptr, 1, kHeightOfPlot)) << "no step before";
}

TEST(EarlierReadings, AreThoseOfAllRecordedSteps) {
  const RunView run = falling_run(300, 200);
  const EarlierCurvePtr before = readings_before(run, {0, 2}, Layout{});
  ASSERT_TRUE(before);
  EXPECT_EQ(before->curve.readings.size(), 101U);
  EXPECT_EQ(before->curve.readings[49], 300);
  EXPECT_EQ(before->curve.readings[50], 200);
  EXPECT_EQ(readings_before(run, {0, 9}, Layout{}), nullptr);
}

}  // namespace
}  // namespace taxel::ui
