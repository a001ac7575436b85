// Selection by a box or a lasso: its area, the side that faces the eye, hidden taxels, modifiers.
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/nouns/select/select.h"
#include "app/studio/nouns/taxel/tool_state.h"
#include "core/base/rng.h"
#include "ui/tools/interface_frames.h"
#include "ui/tools/tool_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace taxel::ui {
namespace {

/// Returns the winding number of a closed path about a point, as the sum of the angles of its segments. This is
/// independent of the tested method.
int winding(const std::vector<dvec2>& corners, const dvec2& p) {
  double turned = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const dvec2 a = corners[i] - p, b = corners[(i + 1) % corners.size()] - p;
    turned += std::atan2(a.x * b.y - a.y * b.x, glm::dot(a, b));
  }
  return static_cast<int>(std::lround(turned / (2 * glm::pi<double>())));
}

TEST(AreaSelect, ContainsPointsWithAnOddWindingNumber) {
  const CounterRng rng(3);
  int inside = 0;
  for (std::uint64_t trial = 0; trial < 300; ++trial) {
    std::vector<dvec2> corners;
    const std::uint64_t count = 3 + rng.bits(1000 * trial) % 9;
    for (std::uint64_t i = 0; i < count; ++i)
      corners.emplace_back(rng.uniform(1000 * trial + 2 * i + 1), rng.uniform(1000 * trial + 2 * i + 2));
    for (std::uint64_t k = 0; k < 50; ++k) {
      const dvec2 p(rng.uniform(1000 * trial + 100 + 2 * k), rng.uniform(1000 * trial + 101 + 2 * k));
      const bool odd = winding(corners, p) % 2 != 0;
      EXPECT_EQ(in_polygon(corners, p), odd) << trial << " " << k;
      inside += odd;
    }
  }
  EXPECT_GT(inside, 1000);
}

TEST(AreaSelect, ContainsNothingWithFewerThanThreeCorners) {
  EXPECT_FALSE(in_polygon({}, {0, 0}));
  EXPECT_FALSE(in_polygon({{0, 0}}, {0, 0}));
  EXPECT_FALSE(in_polygon({{0, 0}, {1, 1}}, {0.5, 0.5}));
}

/// Taxels 1 to 3 face the eye, from left to right. Taxel 4 is behind taxel 2, on the far side of the ball.
struct BallOfFour {
  test::InterfaceFrames interface;
  test::ToolScene scene{{dvec3(1, -0.6, 0), dvec3(1, 0, 0), dvec3(1, 0.6, 0), dvec3(-1, 0, 0)}};

  /// Draws a box over the view, or around it as a lasso. Returns the selected taxels.
  std::vector<int> drawn(Tool tool, const dvec2& from = {1, 1}, const dvec2& to = {798, 598}) {
    scene.app.get<ToolState>().tool = tool;
    const std::vector<dvec2> corners{from, {to.x, from.y}, to, {from.x, to.y}};
    for (std::size_t i = 0; i < corners.size(); ++i) {
      interface.move(corners[i].x, corners[i].y);
      if (i == 0) interface.button(true);
      interface.frame([&] {
        EXPECT_FALSE(draw_area(*scene.app.viewer, *scene.app.shown, scene.app.get<ToolState>(), corners[i], true));
      });
    }
    // A box ends opposite to its first corner, a lasso next to it.
    const dvec2 end = tool == Tool::lasso ? corners[3] : corners[2];
    interface.move(end.x, end.y);
    interface.button(false);
    interface.frame(
        [&] { EXPECT_TRUE(draw_area(*scene.app.viewer, *scene.app.shown, scene.app.get<ToolState>(), end, true)); });
    scene.app.get<ToolState>().area.clear();
    std::vector<int> ids = scene.app.viewer->selection.taxels;
    std::sort(ids.begin(), ids.end());
    return ids;
  }
};

TEST(AreaSelect, LeavesOutTheFarSideOfAnOpaqueSkin) {
  for (const Tool tool : {Tool::box, Tool::lasso}) {
    BallOfFour ball;
    EXPECT_EQ(ball.drawn(tool), (std::vector<int>{1, 2, 3}));
    ball.scene.app.viewer->overlays().sensor_transparent = true;
    EXPECT_EQ(ball.drawn(tool), (std::vector<int>{1, 2, 3, 4})) << "the far side is seen";
    ball.scene.app.viewer->camera().azimuth_deg = 180;
    ball.scene.app.viewer->overlays().sensor_transparent = false;
    EXPECT_EQ(ball.drawn(tool), (std::vector<int>{4})) << "from behind";
  }
}

TEST(AreaSelect, LeavesOutHiddenTaxels) {
  for (const Tool tool : {Tool::box, Tool::lasso}) {
    BallOfFour ball;
    ball.scene.project.hidden = {2};
    ball.scene.publish();
    EXPECT_EQ(ball.drawn(tool), (std::vector<int>{1, 3}));
  }
}

TEST(AreaSelect, SelectsTheTaxelsInsideByItsModifiers) {
  for (const Tool tool : {Tool::box, Tool::lasso}) {
    BallOfFour ball;
    EXPECT_EQ(ball.drawn(tool, {1, 1}, {399, 598}), (std::vector<int>{1})) << "left half";
    EXPECT_EQ(ball.drawn(tool, {401, 1}, {798, 598}), (std::vector<int>{3})) << "right half, alone";
    ball.interface.key(ImGuiMod_Shift, true);
    EXPECT_EQ(ball.drawn(tool, {1, 1}, {399, 598}), (std::vector<int>{1, 3})) << "Shift adds";
    ball.interface.key(ImGuiMod_Shift, false);
    ball.interface.key(ImGuiMod_Ctrl, true);
    EXPECT_EQ(ball.drawn(tool, {401, 1}, {798, 598}), (std::vector<int>{1})) << "Ctrl takes out";
    ball.interface.key(ImGuiMod_Ctrl, false);
    EXPECT_EQ(ball.drawn(tool, {1, 1}, {798, 200}), std::vector<int>{}) << "above all of them";
  }
}

}  // namespace
}  // namespace taxel::ui
