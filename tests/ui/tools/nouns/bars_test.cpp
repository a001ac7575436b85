// The parts of a pressure bar as they are drawn, and the texts below the bars, which do not overlap.
#include <gtest/gtest.h>

#include <algorithm>

#include "../interface_frames.h"
#include "app/studio/nouns/bars/pressure_bars.h"
#include "overlaps.h"

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
      draw_pressure_bars(ui, Viewer(), shown, {{0, "finger", {"kPa", 1e-3}, 4000, values, {}, {}}}, {400, 300}, true);
      vertices = ImGui::GetWindowDrawList()->VtxBuffer.Size - before;
      ImGui::End();
    });
  }
};

TEST(DrawnBars, EndInAMarkIfTheReadingIsAboveTheAxis) {
  const DrawnBars inside({{7, 4000}}), above({{7, 4000.1}});
  ASSERT_EQ(inside.shown.bars.size(), 1U);
  ASSERT_EQ(above.shown.bars.size(), 1U);
  EXPECT_FALSE(inside.shown.bars[0].over);
  EXPECT_TRUE(above.shown.bars[0].over);
  EXPECT_EQ(above.shown.bars[0].height, inside.shown.bars[0].height) << "clipped at the end of the axis";
  EXPECT_GT(above.vertices, inside.vertices) << "the mark";
}

TEST(DrawnBars, HaveALineAtTheirPeakAndAWhisker) {
  const DrawnBars plain({{7, 2000}}), peak({{7, 2000, 3000}}), whisker({{7, 2000, 0, 0, 100}});
  EXPECT_GT(peak.vertices, plain.vertices);
  EXPECT_GT(whisker.vertices, peak.vertices);
  EXPECT_EQ(plain.shown.bars[0].height, 0.5 * plain.shown.bars[0].axis_height);
}

TEST(DrawnBars, AreEmptyForAReadingBelowZero) {
  const DrawnBars negative({{7, -500}});
  EXPECT_EQ(negative.shown.bars[0].height, 0);
  EXPECT_EQ(negative.shown.bars[0].value, -500);
}

/// Returns sensors with `count` readings of up to 80 kPa each.
std::vector<BarGroup> groups_of(int sensors, int count) {
  std::vector<BarGroup> groups;
  for (int s = 0; s < sensors; ++s) {
    BarGroup& group = groups.emplace_back();
    group.sensor = s;
    group.name = "right finger " + std::to_string(s);
    group.unit = {"kPa", 1e-3};
    group.top = 80e3;
    group.range = {0, 80e3};
    for (int i = 0; i < count; ++i) {
      const double reading = 80e3 * ((37 * i + 11 * s) % 97) / 97.0;
      group.values.push_back({i, reading, 1.1 * reading, i});
    }
  }
  return groups;
}

/// Returns the bars in a room of `size` pixels.
BarsShown drawn(const std::vector<BarGroup>& groups, ImVec2 size, const Viewer& viewer = {}) {
  BarsShown shown;
  test::InterfaceFrames interface;
  interface.frame([&] {
    ImGui::Begin("bars");
    WindowUi ui;
    draw_pressure_bars(ui, viewer, shown, groups, size, false);
    ImGui::End();
  });
  return shown;
}

bool has_text(const BarsShown& shown, const std::string& text) {
  return std::any_of(shown.texts.begin(), shown.texts.end(), [&](const TextShown& each) { return each.text == text; });
}

TEST(BarTexts, NeverOverlapForAnyNumberOfTaxels) {
  for (const auto& [sensors, taxels] : {std::pair(1, 12), {1, 60}, {1, 256}, {2, 7}, {5, 12}, {21, 1}, {21, 37}})
    for (const ImVec2 size : {ImVec2(1000, 90), ImVec2(1000, 300), ImVec2(420, 160), ImVec2(150, 120)}) {
      const BarsShown shown = drawn(groups_of(sensors, taxels), size);
      EXPECT_EQ(shown.bars.size(), static_cast<std::size_t>(sensors * taxels));
      EXPECT_GE(shown.texts.size(), 2U) << "the axis";
      EXPECT_EQ(test::first_overlap(shown.texts), "") << sensors << " x " << taxels << " in " << size.x;
    }
}

TEST(BarTexts, GiveEveryFifthIdWhereNotAllFit) {
  const BarsShown shown = drawn(groups_of(1, 60), {500, 90});
  EXPECT_TRUE(has_text(shown, "55"));
  EXPECT_FALSE(has_text(shown, "56"));
  EXPECT_TRUE(has_text(drawn(groups_of(1, 12), {500, 90}), "11")) << "all of a few";
}

TEST(BarTexts, GiveTheValuesOfTheSelectionAndOfTheLargestPeaks) {
  std::vector<BarGroup> groups = groups_of(1, 60);
  for (BarValue& bar : groups[0].values) bar.value = bar.peak = 1000;
  groups[0].values[30] = {30, 71000, 75000};
  groups[0].values[31] = {31, 72000, 73000};
  EXPECT_TRUE(has_text(drawn(groups, {500, 200}), "71.0"));
  EXPECT_FALSE(has_text(drawn(groups, {500, 200}), "72.0")) << "next to a taxel with a larger peak";
  Viewer viewer;
  viewer.selection.set(31);
  EXPECT_TRUE(has_text(drawn(groups, {500, 200}, viewer), "72.0"));
  EXPECT_TRUE(has_text(drawn(groups, {500, 200}, viewer), "31")) << "its id";
}

TEST(BarTexts, ArePlacedDirectlyAboveTheirBarsWhereNotAllValuesFit) {
  for (const auto& [sensors, taxels] : {std::pair(1, 60), {5, 12}}) {
    const BarsShown shown = drawn(groups_of(sensors, taxels), {700, 200});
    const float line = shown.texts.front().rect.y1 - shown.texts.front().rect.y0;
    int values = 0;
    for (const TextShown& text : shown.texts) {
      if (text.text.find('.') == std::string::npos) continue;  // an id, a name or a number of the axis
      const auto bar = std::find_if(shown.bars.begin(), shown.bars.end(), [&](const BarShown& each) {
        return text.text == number_in_unit(each.value, {"kPa", 1e-3}) && text.rect.x0 <= each.rect.center_x() &&
               each.rect.center_x() <= text.rect.x1;
      });
      ASSERT_NE(bar, shown.bars.end()) << text.text << " is not above its bar";
      EXPECT_LE(text.rect.y1, bar->y_mark);
      EXPECT_GT(text.rect.y1, bar->y_mark - line) << "no more than a line away";
      for (const BarShown& other : shown.bars)
        EXPECT_FALSE(other.rect.x0 < text.rect.x1 && text.rect.x0 < other.rect.x1 && other.y_mark < text.rect.y1)
            << text.text << " covers the bar of taxel " << other.taxel_id;
      ++values;
    }
    EXPECT_GE(values, 5);
  }
}

TEST(Whiskers, GrowWithTheWidthOfTheBar) {
  const auto whisker = [](int bars) {
    std::vector<BarGroup> groups = groups_of(1, bars);
    for (BarValue& bar : groups[0].values) bar.error = 4e3;
    const BarsShown shown = drawn(groups, {600, 300});
    return std::pair(shown.bars[5].rect.width(), shown.bars[5]);
  };
  const auto [wide, of_wide] = whisker(12);
  const auto [narrow, of_narrow] = whisker(60);
  EXPECT_GT(of_wide.whisker_line, 2);
  EXPECT_GE(of_narrow.whisker_line, 1);
  EXPECT_NEAR(of_narrow.whisker.width(), 2.0f / 3 * narrow, 0.01f);
  EXPECT_GE(of_wide.whisker.width(), std::min(2.0f / 3 * wide, 20.0f));
  EXPECT_NEAR(of_wide.whisker.height() / of_wide.axis_height, 2 * 4e3 / 80e3, 0.05) << "its height is the error";
}

TEST(BarTexts, ShortenNamesThatAreWiderThanTheirBars) {
  const BarsShown shown = drawn(groups_of(12, 4), {600, 90});
  EXPECT_FALSE(has_text(shown, "right finger 3"));
  EXPECT_TRUE(std::any_of(shown.texts.begin(), shown.texts.end(),
                          [](const TextShown& text) { return text.text.starts_with("ri") && text.text.size() < 14; }));
  EXPECT_TRUE(has_text(drawn(groups_of(3, 4), {600, 90}), "right finger 2"));
}

TEST(TextStride, IsTheLeastRoundNumberThatFits) {
  EXPECT_EQ(text_stride(10, 10), 1U);
  EXPECT_EQ(text_stride(10.1f, 10), 2U);
  EXPECT_EQ(text_stride(20.1f, 10), 5U);
  EXPECT_EQ(text_stride(51, 10), 10U);
  EXPECT_EQ(text_stride(101, 10), 20U);
  EXPECT_EQ(text_stride(10, 0), 1000U);
}

TEST(TextLine, KeepsAGapBetweenTexts) {
  TextLine line(5);
  EXPECT_TRUE(line.reserve(100, 120));
  EXPECT_FALSE(line.reserve(110, 112));
  EXPECT_FALSE(line.reserve(90, 130));
  EXPECT_FALSE(line.reserve(124, 130)) << "closer than the gap";
  EXPECT_TRUE(line.reserve(125, 130));
  EXPECT_FALSE(line.reserve(80, 96));
  EXPECT_TRUE(line.reserve(80, 95));
}

}  // namespace
}  // namespace taxel::ui
