// Several sensors in the panels: groups of bars, cells of the map, rows of the table, ranges of colours, selection.
#include <gtest/gtest.h>

#include <array>

#include "app/studio/frame/sensor_chooser.h"
#include "app/studio/nouns/bars/pressure_bars.h"
#include "app/studio/nouns/map/map_panel.h"
#include "app/studio/nouns/table/table_rows.h"
#include "ui/tools/hand_frame.h"

namespace taxel::ui {
namespace {

using test::run_of;

TEST(PlaceGroups, LeavesAGapBetweenSensors) {
  const std::array<std::size_t, 2> counts{2, 3};
  const std::vector<BarSpan> spans = place_groups(counts, {}, 100, 210, 10);
  ASSERT_EQ(spans.size(), 2U);
  EXPECT_FLOAT_EQ(spans[0].step, 20);
  EXPECT_FLOAT_EQ(spans[0].x1, 140);
  EXPECT_FLOAT_EQ(spans[1].x0, 150);
  EXPECT_FLOAT_EQ(spans[1].column(2), 190);
  EXPECT_FLOAT_EQ(spans[1].x1, 210);
}

TEST(PlaceGroups, GivesOneSensorTheWholeRoom) {
  const std::array<std::size_t, 1> counts{4};
  const std::vector<BarSpan> spans = place_groups(counts, {}, 0, 100, 10);
  EXPECT_FLOAT_EQ(spans[0].step, 25);
}

TEST(PlaceGroups, KeepsTwoThirdsOfTheRoomForBars) {
  const std::vector<std::size_t> counts(31, 1);
  const std::vector<BarSpan> spans = place_groups(counts, {}, 0, 93, 10);
  EXPECT_FLOAT_EQ(spans[0].step, 2);
  EXPECT_NEAR(spans.back().x1, 93, 1e-4);
}

TEST(PlaceGroups, LeavesAWiderGapBetweenFingers) {
  const std::array<std::size_t, 3> counts{1, 1, 1};
  const std::array chains{1, 1, 2};
  const std::vector<BarSpan> spans = place_groups(counts, chains, 0, 120, 10);
  EXPECT_FLOAT_EQ(spans[0].step, 30);
  EXPECT_FLOAT_EQ(spans[1].x0, 40);
  EXPECT_FLOAT_EQ(spans[2].x0, 90);
  const std::array apart{1, 2, 3};
  EXPECT_FLOAT_EQ(place_groups(counts, apart, 0, 120, 10)[1].x0, 100.0f / 3 + 10) << "one sensor in each finger";
}

TEST(MapCells, AreSideBySideInAWideRoom) {
  const FlatMap square{{{0, 0}, {0.1, 0.1}}, 0.1, false};
  const std::vector<const FlatMap*> maps(4, &square);
  const std::vector<MapCell> wide = map_cells(maps, {0, 0}, {800, 200}, 10, 12),
                             high = map_cells(maps, {0, 0}, {200, 800}, 10, 12);
  ASSERT_EQ(wide.size(), 4U);
  EXPECT_FLOAT_EQ(wide[3].origin.x, 600);
  EXPECT_FLOAT_EQ(wide[3].origin.y, 0);
  EXPECT_FLOAT_EQ(wide[3].size.y, 188) << "room for the name";
  EXPECT_FLOAT_EQ(high[3].origin.x, 0);
  EXPECT_FLOAT_EQ(high[3].origin.y, 600);
}

TEST(MapCells, AreAsWideAsNamesIfMapsStayLarge) {
  const FlatMap square{{{0, 0}, {0.1, 0.1}}, 0.1, false};
  const std::vector<const FlatMap*> maps(4, &square);
  const ImVec2 room(400, 200);
  EXPECT_FLOAT_EQ(map_cells(maps, {0, 0}, room, 10, 12, 80)[3].origin.x, 300);
  EXPECT_FLOAT_EQ(map_cells(maps, {0, 0}, room, 10, 12, 120)[3].origin.y, 100) << "two rows have room for names";
  EXPECT_FLOAT_EQ(map_cells(maps, {0, 0}, {400, 60}, 10, 12, 120)[3].origin.y, 0) << "two rows are too low";
}

TEST(SensorRows, ListAllSensorsInTheirOrder) {
  const RunView run = run_of({{"index", {3, 9}}, {"thumb", {5}}});
  TableState table;
  EXPECT_EQ(sensor_rows(table, sensors_shown(run)), (std::vector<SensorRow>{{0, 0}, {0, 1}, {1, 0}}));
  table.sorted = TableColumn::reading;
  table.descending = true;
  EXPECT_EQ(sensor_rows(table, sensors_shown(run)), (std::vector<SensorRow>{{0, 1}, {1, 0}, {0, 0}}));
  table.sorted = TableColumn::sensor;
  EXPECT_EQ(sensor_rows(table, sensors_shown(run)), (std::vector<SensorRow>{{1, 0}, {0, 0}, {0, 1}}));
}

TEST(SensorRows, PassAFilterByTheNameOfTheSensor) {
  const RunView run = run_of({{"index", {3, 9}}, {"thumb", {5}}});
  TableState table;
  table.filter = "THU";
  EXPECT_EQ(sensor_rows(table, sensors_shown(run)), (std::vector<SensorRow>{{1, 0}}));
}

TEST(SensorLines, HaveAHeadingForEachSensor) {
  const RunView run = run_of({{"index", {3, 9}}, {"thumb", {5}}});
  const std::vector<SensorShown> sensors = sensors_shown(run);
  TableState table;
  const auto lines = [&] { return sensor_lines(table, sensor_rows(table, sensors), sensors); };
  const SensorLine index{true, {0, 0}, 2}, thumb{true, {1, 0}, 1};
  const SensorLine first{false, {0, 0}, 0}, second{false, {0, 1}, 0}, third{false, {1, 0}, 0};
  EXPECT_EQ(lines(), (std::vector<SensorLine>{index, first, second, thumb, third}));
  table.folded = {0};
  EXPECT_EQ(lines(), (std::vector<SensorLine>{index, thumb, third}));
  table.filter = "index";
  EXPECT_EQ(lines(), (std::vector<SensorLine>{index, first, second})) << "a filter shows all that pass";
  table.filter.clear();
  table.sorted = TableColumn::reading;
  EXPECT_EQ(lines(), (std::vector<SensorLine>{first, third, second})) << "no headings in another order";
}

TEST(SensorsShown, HaveShortNamesAndAreFoundByTheirGeoms) {
  RunView run = run_of({{"rh_ffdistal", {3, 9}}, {"rh_thdistal", {5}}});
  const auto scene = std::make_shared<SimScene>(*run.frame->scene);
  const auto frame = std::make_shared<SimFrame>(*run.frame);
  scene->sensor_labels = {"index", "thumb"};
  frame->scene = scene;
  run.frame = frame;
  const std::vector<SensorShown> sensors = sensors_shown(run);
  EXPECT_EQ(taxel_label(sensors, sensors[1], 1), "thumb 1");
  EXPECT_EQ(matching_sensors(sensors, "THUMB"), std::vector<std::size_t>{1});
  EXPECT_EQ(matching_sensors(sensors, "ffdistal"), std::vector<std::size_t>{0});
  EXPECT_EQ(matching_sensors(sensors, "").size(), 2U);
  TableState table;
  table.filter = "rh_th";
  EXPECT_EQ(sensor_rows(table, sensors), (std::vector<SensorRow>{{1, 0}}));
  table.filter = "index 2";
  EXPECT_EQ(sensor_rows(table, sensors), (std::vector<SensorRow>{{0, 1}})) << "taxel 2 of the index";
}

TEST(SensorsShown, LeaveOutGeomsWithoutTaxels) {
  const RunView run = run_of({{"soft", {}}, {"thumb", {5, 6}}});
  const std::vector<SensorShown> sensors = sensors_shown(run);
  ASSERT_EQ(sensors.size(), 1U);
  EXPECT_EQ(sensors[0].index, 1);
  EXPECT_EQ(sensors[0].first, 0U);
  EXPECT_TRUE(sensors_shown({}).empty());
}

TEST(RangeOf, IsThatOfTheSelectedSensorForEqualUnits) {
  const RunView run = run_of({{"index", {100}}, {"thumb", {300}}, {"palm", {0.8, 0.3}, Aggregate::force}});
  const std::vector<SensorShown> sensors = sensors_shown(run);
  const PressureRange selected{0, 400};
  EXPECT_EQ(range_of(sensors, sensors[1], run, {}, selected), selected);
  const PressureRange forces = range_of(sensors, sensors[2], run, {}, selected);
  EXPECT_GE(forces.hi, 0.8);
  EXPECT_LT(forces.hi, 2);
}

TEST(ClickTaxelOf, SelectsInOneSensorAtATime) {
  Selection selection;
  selection.set(3);
  click_taxel_of(selection, {0, 4}, true);
  EXPECT_EQ(selection.taxels, (std::vector<int>{3, 4}));
  click_taxel_of(selection, {2, 4}, true);
  EXPECT_EQ(selection.sensor, 2);
  EXPECT_EQ(selection.taxels, std::vector<int>{4});
  EXPECT_TRUE(is_selected(selection, {2, 4}));
  EXPECT_FALSE(is_selected(selection, {0, 4}));
}

}  // namespace
}  // namespace taxel::ui
