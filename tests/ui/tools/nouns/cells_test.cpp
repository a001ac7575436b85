// The heat map of the readings of many taxels: places of the cells, their colours, and the cell under the pointer.
#include "app/studio/nouns/bars/taxel_cells.h"

#include <gtest/gtest.h>

#include <set>

#include "../interface_frames.h"
#include "overlaps.h"
#include "ui/tools/hand_frame.h"

namespace taxel::ui {
namespace {

/// The links of a hand: chains of 4, 4, 4, 5 and 3 sensors, and a palm; 773 taxels.
struct HandCounts {
  std::vector<std::size_t> counts{48};
  std::vector<int> chains{0};

  HandCounts() {
    for (int finger = 1; finger <= 5; ++finger) {
      std::vector<std::size_t> links{12, 36, 36, 60};
      if (finger == 4) links.insert(links.begin(), 17);
      if (finger == 5) links.erase(links.begin());
      counts.insert(counts.end(), links.begin(), links.end());
      chains.insert(chains.end(), links.size(), finger);
    }
  }
};

bool overlap(const Rect& a, const Rect& b) {
  constexpr float kRounding = 1e-2f;
  return a.x0 + kRounding < b.x1 && b.x0 + kRounding < a.x1 && a.y0 + kRounding < b.y1 && b.y0 + kRounding < a.y1;
}

/// Returns the rectangles of all cells.
std::vector<Rect> all_cells(const CellPlan& plan, const std::vector<std::size_t>& counts) {
  std::vector<Rect> cells;
  for (std::size_t s = 0; s < counts.size(); ++s)
    for (std::size_t k = 0; k < counts[s]; ++k) cells.push_back(plan.cell({0, 0}, s, k));
  return cells;
}

TEST(PlaceCells, PutsAWholeHandIntoALowPanel) {
  const HandCounts hand;
  for (const ImVec2 room : {ImVec2(1000, 90), ImVec2(700, 120), ImVec2(1600, 160), ImVec2(400, 700)}) {
    const CellPlan plan = place_cells(hand.counts, hand.chains, room, {70, 13, 3});
    ASSERT_EQ(plan.sensors.size(), 21U);
    EXPECT_LE(plan.total_height, room.y + 0.1f);
    EXPECT_GE(std::min(plan.width, plan.height), 3.0f);
    const std::vector<Rect> cells = all_cells(plan, hand.counts);
    ASSERT_EQ(cells.size(), 773U);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      EXPECT_GE(cells[i].x0, 70) << "right of the name";
      EXPECT_LE(cells[i].x1, room.x + 0.1f);
      EXPECT_LE(cells[i].y1, room.y + 0.1f);
      for (std::size_t j = 0; j < i; ++j) ASSERT_FALSE(overlap(cells[i], cells[j])) << i << " and " << j;
    }
    for (std::size_t s = 1; s < plan.sensors.size(); ++s)
      if (plan.sensors[s].x == plan.sensors[s - 1].x) {
        EXPECT_GE(plan.sensors[s].top - plan.sensors[s - 1].top, 13) << "room for the name";
      }
  }
}

TEST(PlaceCells, KeepsTheSensorsOfAFingerInOneColumn) {
  const std::vector<std::size_t> counts(6, 10);
  const std::vector<int> chains{1, 1, 2, 2, 2, 3};
  const CellPlan plan = place_cells(counts, chains, {600, 48}, {50, 13, 3});
  EXPECT_EQ(plan.sensors[2].top, 0) << "the second finger does not fit below the first one";
  EXPECT_EQ(plan.sensors[2].x, plan.sensors[4].x);
  EXPECT_GT(plan.sensors[2].x, plan.sensors[1].x);
}

TEST(PlaceCells, IsHigherThanTheRoomIfCellsWouldBeTooSmall) {
  const std::vector<std::size_t> counts(21, 400);
  const CellPlan plan = place_cells(counts, {}, {300, 60}, {70, 13, 3});
  EXPECT_GE(std::min(plan.width, plan.height), 3);
  EXPECT_GT(plan.total_height, 60);
}

TEST(PlaceCells, GivesOneTaxelAWideCell) {
  const std::vector<std::size_t> one{1};
  const CellPlan plan = place_cells(one, {}, {500, 100}, {0, 13, 3});
  EXPECT_FLOAT_EQ(plan.height, 1.4f * 13);
  EXPECT_FLOAT_EQ(plan.width, 1.6f * plan.height);
  EXPECT_TRUE(place_cells({}, {}, {500, 100}, {0, 13, 3}).sensors.empty());
}

/// Returns two sensors with 300 readings each, from 0 to 299 Pa and from 0 to 299 N.
std::vector<BarGroup> many_readings() {
  std::vector<BarGroup> groups(2);
  for (int s = 0; s < 2; ++s) {
    BarGroup& group = groups[static_cast<std::size_t>(s)];
    group.sensor = s + 3;
    group.name = s == 0 ? "index" : "thumb";
    group.unit = s == 0 ? ReadingUnit{"Pa", 1} : ReadingUnit{"N", 1, false};
    group.range = {0, 299};
    for (int k = 0; k < 300; ++k) group.values.push_back({100 + k, static_cast<double>(k), 299, k, 0, "left"});
  }
  return groups;
}

/// Draws the cells in a room of 600 x 200 pixels, in frames in which the pointer is at `at` and its button pressed.
struct DrawnCells {
  BarsShown shown;
  std::optional<ClickedBar> clicked;

  explicit DrawnCells(const std::vector<BarGroup>& groups, std::optional<ImVec2> at = {}) {
    test::InterfaceFrames interface;
    if (at) interface.move(static_cast<double>(at->x), static_cast<double>(at->y));
    for (int i = 0; i < 4; ++i) {
      if (at && i == 3) interface.button(true);
      interface.frame([&] {
        ImGui::SetNextWindowPos({10, 10});
        ImGui::SetNextWindowSize({640, 300});
        ImGui::Begin("cells");
        WindowUi ui;
        if (const auto click = draw_taxel_cells(ui, Viewer(), shown, groups, {600, 200})) clicked = click;
        ImGui::End();
      });
    }
  }
};

TEST(TaxelCells, HaveTheColoursOfTheirReadings) {
  const std::vector<BarGroup> groups = many_readings();
  const BarsShown shown = DrawnCells(groups).shown;
  ASSERT_EQ(shown.cells.size(), 600U);
  std::set<std::pair<int, int>> taxels;
  for (const CellShown& cell : shown.cells) {
    EXPECT_EQ(cell.value, cell.taxel_id - 100);
    EXPECT_EQ(cell.color, groups[0].range.color(cell.value));
    EXPECT_TRUE(taxels.emplace(cell.sensor, cell.taxel_id).second);
  }
  EXPECT_EQ(test::first_overlap(shown.texts), "");
  EXPECT_EQ(shown.texts.size(), 2U) << "the names of the sensors";
}

TEST(TaxelCells, ReturnTheClickedTaxel) {
  const BarsShown shown = DrawnCells(many_readings()).shown;
  const CellShown& cell = shown.cells[300 + 77];
  const DrawnCells pressed(many_readings(), ImVec2(cell.rect.center_x(), cell.rect.center_y()));
  ASSERT_TRUE(pressed.clicked);
  EXPECT_EQ(pressed.clicked->sensor, 4);
  EXPECT_EQ(pressed.clicked->id, 177);
}

TEST(BarTip, HasNameValueAndUnit) {
  const std::vector<BarGroup> groups = many_readings();
  EXPECT_EQ(bar_tip(groups, groups[1], groups[1].values[12]), "Taxel thumb 112, left: 12.000 N\npeak 299.000 N");
}

/// Returns a hand whose palm bears a finger of two links and a thumb.
RunView branched_hand() {
  RunView run = test::run_of({{"palm", {1}}, {"proximal", {1}}, {"distal", {1}}, {"thumb", {1}}});
  const auto scene = std::make_shared<SimScene>(*run.frame->scene);
  const auto frame = std::make_shared<SimFrame>(*run.frame);
  // The bodies are world, forearm, palm, knuckle, proximal, distal and thumb.
  for (const int parent : {0, 0, 1, 2, 3, 4, 2}) scene->controls.bodies.push_back({"", -1, false, parent});
  const std::array bodies{2, 4, 5, 6};
  for (int s = 0; s < 4; ++s) {
    SceneGeom& geom = scene->geoms.emplace_back();
    geom.sensor = s;
    geom.body_index = bodies[static_cast<std::size_t>(s)];
  }
  frame->scene = scene;
  run.frame = frame;
  return run;
}

TEST(PlacesOf, AreTheFingersAndThePalm) {
  const RunView run = branched_hand();
  const std::vector<SensorPlace> places = places_of(sensors_shown(run), run);
  EXPECT_EQ(places[1].chain, places[2].chain) << "two links of a finger";
  EXPECT_EQ((std::set{places[0].chain, places[1].chain, places[3].chain}).size(), 3U);
  EXPECT_LT(places[1].body, places[2].body);
}

}  // namespace
}  // namespace taxel::ui
