// The parts of a pressure bar as they are drawn.
#include <gtest/gtest.h>

#include "../interface_frames.h"
#include "app/studio/nouns/bars/pressure_bars.h"

namespace taxel::ui {
namespace {

/// The bars of one sensor up to 4 kPa, and the number of vertices that they are drawn with.
struct DrawnBars {
  BarsShown shown;
  int vertices = 0;

  explicit DrawnBars(const std::vector<BarValue>& values) {
    test::InterfaceFrames interface;
    interface.frame([&] {
      ImGui::Begin("bars");
      WindowUi ui;
      const int before = ImGui::GetWindowDrawList()->VtxBuffer.Size;
      draw_pressure_bars(ui, Viewer(), shown, {{0, "finger", {"kPa", 1e-3}, 4000, values}}, {400, 300}, true);
      vertices = ImGui::GetWindowDrawList()->VtxBuffer.Size - before;
      ImGui::End();
    });
  }
};

TEST(DrawnBars, EndInAMarkIfTheReadingIsAboveTheAxis) {
  const DrawnBars inside({{7, 4000}}), above({{7, 4000.1}});
  ASSERT_EQ(inside.shown.size(), 1U);
  ASSERT_EQ(above.shown.size(), 1U);
  EXPECT_FALSE(inside.shown[0].over);
  EXPECT_TRUE(above.shown[0].over);
  EXPECT_EQ(above.shown[0].height, inside.shown[0].height) << "clipped at the end of the axis";
  EXPECT_GT(above.vertices, inside.vertices) << "the mark";
}

TEST(DrawnBars, HaveALineAtTheirPeakAndAWhisker) {
  const DrawnBars plain({{7, 2000}}), peak({{7, 2000, 3000}}), whisker({{7, 2000, 0, 0, 100}});
  EXPECT_GT(peak.vertices, plain.vertices);
  EXPECT_GT(whisker.vertices, peak.vertices);
  EXPECT_EQ(plain.shown[0].height, 0.5 * plain.shown[0].axis_height);
}

TEST(DrawnBars, AreEmptyForAReadingBelowZero) {
  const DrawnBars negative({{7, -500}});
  EXPECT_EQ(negative.shown[0].height, 0);
  EXPECT_EQ(negative.shown[0].value, -500);
}

}  // namespace
}  // namespace taxel::ui
