// Time, legend and bars in the images of videos.
#include "app/studio/nouns/video/video_notes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "ui/theme.h"
#include "ui/tools/interface_frames.h"

namespace taxel::ui {
namespace {

/// Returns notes with all parts, of one sensor with this number of taxels.
VideoNotes notes_of_taxels(int taxels) {
  VideoNotes notes;
  notes.time = "12.345 s";
  notes.legend.emplace();
  notes.legend->surface.hi = 40e3;
  notes.legend->readings.hi = 5e3;
  BarGroup& group = notes.bars.emplace_back();
  group.top = 5e3;
  for (int i = 0; i < taxels; ++i) group.values.push_back({i, 2.5e3, 0, i});
  return notes;
}

bool plates_overlap(const Rect& a, const Rect& b) {
  return !a.empty() && !b.empty() && a.x0 < b.x1 && b.x0 < a.x1 && a.y0 < b.y1 && b.y0 < a.y1;
}

/// Returns the highest filled rectangle of a colour in a list.
Rect rect_of(const ImDrawList& list, ImU32 color) {
  Rect highest;
  for (int i = 0; i + 3 < list.VtxBuffer.Size; ++i) {
    const ImDrawVert &a = list.VtxBuffer[i], &c = list.VtxBuffer[i + 2];
    const Rect rect{a.pos.x, a.pos.y, c.pos.x, c.pos.y};
    if (a.col == color && c.col == color && rect.height() > highest.height()) highest = rect;
  }
  return highest;
}

void expect_apart(const VideoPlates& plates, ImVec2 image, const std::string& where) {
  const Rect middle{0.4f * image.x, 0.4f * image.y, 0.6f * image.x, 0.6f * image.y};
  for (const Rect& plate : {plates.time, plates.legend, plates.bars}) {
    if (plate.empty()) continue;
    EXPECT_TRUE(plate.x0 > 0 && plate.y0 > 0 && plate.x1 < image.x && plate.y1 < image.y) << where;
    EXPECT_FALSE(image.y >= 600 && plates_overlap(plate, middle)) << where;
  }
  EXPECT_FALSE(plates_overlap(plates.time, plates.bars)) << where;
  EXPECT_FALSE(plates_overlap(plates.time, plates.legend)) << where;
  EXPECT_FALSE(plates_overlap(plates.legend, plates.bars)) << where;
}

TEST(VideoNotes, OverlapNeitherEachOtherNorTheMiddle) {
  test::InterfaceFrames frames;
  for (const ImVec2 image : {ImVec2(1920, 1080), ImVec2(1000, 600), ImVec2(400, 300), ImVec2(160, 120)}) {
    for (const int taxels : {1, 12, 773}) {
      VideoPlates plates;
      frames.frame([&] { plates = draw_video_notes(*ImGui::GetBackgroundDrawList(), image, notes_of_taxels(taxels)); });
      const std::string where = std::to_string(taxels) + " in " + std::to_string(image.x);
      EXPECT_FALSE(plates.time.empty()) << where;
      EXPECT_EQ(plates.legend.empty() || plates.bars.empty(), image.y < 300) << where;
      expect_apart(plates, image, where);
    }
  }
}

TEST(VideoNotes, HaveBarsInTheColourAndTheHeightOfTheReadings) {
  test::InterfaceFrames frames;
  VideoNotes notes = notes_of_taxels(3);
  notes.bars.front().values[1].value = 1.25e3;
  notes.bars.front().values[2].value = 9e3;  // above the range
  frames.frame([&] {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const VideoPlates plates = draw_video_notes(list, {1000, 600}, notes);
    std::array<Rect, 3> bars;
    for (int i = 0; i < 3; ++i) bars[static_cast<std::size_t>(i)] = rect_of(list, taxel_color_u32(i));
    const float whole = rect_of(list, to_u32(palette(true).field)).height();
    EXPECT_NEAR(bars[0].height(), 0.5f * whole, 1);
    EXPECT_NEAR(bars[1].height(), 0.25f * whole, 1);
    EXPECT_NEAR(bars[2].height(), whole, 1);
    for (const Rect& bar : bars) EXPECT_TRUE(plates_overlap(bar, plates.bars));
    EXPECT_TRUE(bars[0].x1 < bars[1].x0 && bars[1].x1 < bars[2].x0);
  });
}

TEST(VideoNotes, HaveTheForceBelowTheTimeOnAPlateThatKeepsItsWidth) {
  test::InterfaceFrames frames;
  VideoNotes notes = notes_of_taxels(3);
  std::vector<Rect> plates;
  frames.frame([&] {
    for (const char* force : {"", "force 1.25 N", "force 99.88 N"}) {
      notes.force = force;
      plates.push_back(draw_video_notes(*ImGui::GetBackgroundDrawList(), {1000, 600}, notes).time);
    }
  });
  EXPECT_GT(plates[1].height(), 1.8f * plates[0].height() - 10) << "two lines";
  EXPECT_EQ(plates[1].y1, plates[0].y1);
  EXPECT_EQ(plates[1].width(), plates[2].width()) << "the bars next to it stay";
}

TEST(VideoNotes, HaveTheIdsOfTheTaxelsOfSeveralSensors) {
  test::InterfaceFrames frames;
  VideoNotes notes = notes_of_taxels(3);
  notes.bars.push_back(notes.bars.front());
  notes.bars[0].name = notes.bars[1].name = "tip";
  const auto vertices = [&](int first_id) {
    for (BarGroup& group : notes.bars)
      for (int i = 0; i < 3; ++i) group.values[static_cast<std::size_t>(i)].id = first_id + i;
    const ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const int before = list.VtxBuffer.Size;
    draw_video_notes(*ImGui::GetBackgroundDrawList(), {1000, 600}, notes);
    return list.VtxBuffer.Size - before;
  };
  frames.frame([&] { EXPECT_GT(vertices(100), vertices(0)) << "more digits are drawn"; });
}

TEST(VideoNotes, HaveOneColourBarForLinkedRanges) {
  test::InterfaceFrames frames;
  VideoNotes notes = notes_of_taxels(3);
  Rect apart, linked;
  frames.frame([&] {
    apart = draw_video_notes(*ImGui::GetBackgroundDrawList(), {1000, 600}, notes).legend;
    notes.legend->linked = true;
    linked = draw_video_notes(*ImGui::GetBackgroundDrawList(), {1000, 600}, notes).legend;
  });
  EXPECT_LT(linked.width(), 0.6f * apart.width());
  EXPECT_EQ(linked.x1, apart.x1);
}

}  // namespace
}  // namespace taxel::ui
