// The flat map of taxels: the place of the map in its panel.
#include "app/studio/nouns/map/map_panel.h"

#include <gtest/gtest.h>

namespace taxel::ui {
namespace {

// A line of text is 10 pixels high in these tests: the margins take 6 pixels of each side, 3 at each end.

TEST(FitMap, FillsTheNarrowerSideOfTheRoom) {
  const FlatMap wide{{{0, 0}, {0.1, 0.01}}, 0, false}, high{{{0, 0}, {0.1, 0.2}}, 0, false};
  EXPECT_NEAR(fit_map(wide, {0, 0}, {206, 106}, 10).scale, 200 / 0.1, 1e-9);
  EXPECT_NEAR(fit_map(high, {0, 0}, {206, 106}, 10).scale, 100 / 0.2, 1e-9);
}

TEST(FitMap, LeavesRoomForTheDiscsAtTheRim) {
  const FlatMap map{{{0, 0}, {0.1, 0}}, 0.1, false};
  const MapFit fit = fit_map(map, {0, 0}, {198, 1006}, 10);
  EXPECT_NEAR(fit.scale, 192 / 0.192, 1e-9) << "0.1 m and two radii of 0.046 m";
}

TEST(FitMap, PutsTheMiddleOfTheMapInTheMiddleOfTheRoom) {
  const FlatMap map{{{0, 0}, {0.1, 0.2}}, 0, false};
  const MapFit fit = fit_map(map, {30, 40}, {106, 206}, 10);
  const ImVec2 middle = fit.at({0.05, 0.1});
  EXPECT_FLOAT_EQ(middle.x, 83);
  EXPECT_FLOAT_EQ(middle.y, 143);
  EXPECT_LT(fit.at({0.05, 0.2}).y, middle.y) << "up in the map is up in the window";
  EXPECT_GT(fit.at({0.1, 0.1}).x, middle.x);
}

TEST(FitMap, LimitsTheRadiusOfTheDiscs) {
  const FlatMap map{{{0, 0}, {0.1, 0}}, 0.1, false};
  EXPECT_NEAR(fit_map(map, {0, 0}, {44.4f, 1006}, 10).radius, 0.46 * 20, 1e-4) << "200 pixels per metre";
  EXPECT_FLOAT_EQ(fit_map(map, {0, 0}, {2006, 2006}, 10).radius, 22) << "2.2 lines of text";
  const FlatMap dense{{{0, 0}, {1, 0}}, 0.001, false};
  EXPECT_FLOAT_EQ(fit_map(dense, {0, 0}, {206, 206}, 10).radius, 1.5f);
}

TEST(FitMap, ShowsOneTaxelInTheMiddle) {
  const FlatMap map{{{0.3, -0.2}}, 0, false};
  const MapFit fit = fit_map(map, {0, 0}, {106, 56}, 10);
  EXPECT_FLOAT_EQ(fit.at({0.3, -0.2}).x, 53);
  EXPECT_FLOAT_EQ(fit.at({0.3, -0.2}).y, 28);
  EXPECT_FLOAT_EQ(fit.radius, 22) << "half of the room would be 25 pixels";
}

}  // namespace
}  // namespace taxel::ui
