// The heat map of readings: rows by sensor, cells that keep spikes, colour levels, and rectangles.
#include "app/studio/nouns/heat/heat_state.h"

#include <gtest/gtest.h>

#include "ui/tools/hand_frame.h"

namespace taxel::ui {
namespace {

using test::lanes_of;
using test::run_of;
using Labels = std::vector<std::string>;

Labels labels_of(const std::vector<HeatRow>& rows) {
  Labels labels;
  for (const HeatRow& row : rows) labels.push_back(row.label);
  return labels;
}

TEST(HeatRows, AreGroupedBySensor) {
  const auto lanes = lanes_of({{0, 100, 2, 50}});
  const RunView run = run_of({{"index", {0, 0}}, {"thumb", {0, 0}}}, lanes);
  const std::vector<HeatRow> rows = heat_rows(*lanes, sensors_shown(run), {}, false);
  EXPECT_EQ(labels_of(rows), (Labels{"index 1", "index 2", "thumb 1", "thumb 2"}));
  EXPECT_EQ(rows[2].sensor, 1U);
  EXPECT_EQ(rows[3].reading, 3U);
}

TEST(HeatRows, CanLeaveOutTaxelsThatDoNotRespond) {
  const auto lanes = lanes_of({{0, 100, 2, 50}, {0, 0, 3, 0}});
  const RunView run = run_of({{"index", {0, 0}}, {"thumb", {0, 0}}}, lanes);
  EXPECT_EQ(labels_of(heat_rows(*lanes, sensors_shown(run), {}, true)), (Labels{"index 2", "thumb 2"}));
  Selection selection;
  selection.sensor = 1;
  selection.set(1);
  EXPECT_EQ(labels_of(heat_rows(*lanes, sensors_shown(run), selection, true)),
            (Labels{"index 2", "thumb 1", "thumb 2"}));
}

TEST(PlaceRows, LeavesAGapBetweenSensors) {
  std::vector<HeatRow> rows(4);
  rows[2].sensor = rows[3].sensor = 1;
  const HeatPlaces places = place_rows(rows, 84, 2, 100, 4);
  EXPECT_EQ(places.row, 20);
  EXPECT_EQ(places.tops, (std::vector<float>{0, 20, 44, 64}));
  EXPECT_EQ(places.height, 84);
  EXPECT_EQ(places.row_at(39), 1U);
  EXPECT_FALSE(places.row_at(42)) << "in the gap";
  EXPECT_EQ(places.row_at(44), 2U);
  EXPECT_FALSE(places.row_at(84));
  EXPECT_FALSE(places.row_at(-1));
}

TEST(PlaceRows, LeavesRoomForTheNamesOfSensors) {
  std::vector<HeatRow> rows(3);
  rows[1].sensor = 1;
  rows[2].sensor = 2;
  const HeatPlaces places = place_rows(rows, 20, 2, 100, 4, 13);
  EXPECT_EQ(places.row, 4);
  EXPECT_EQ(places.heights, (std::vector<float>{13, 13, 13})) << "the height of a name";
  EXPECT_EQ(places.tops, (std::vector<float>{0, 17, 34}));
  EXPECT_EQ(places.height, 47);
  EXPECT_EQ(places.row_at(12), 0U);
  EXPECT_FALSE(places.row_at(14));
}

TEST(PlaceRows, LimitsTheHeightOfARow) {
  const std::vector<HeatRow> rows(240);
  const HeatPlaces low = place_rows(rows, 120, 2, 20, 4);
  EXPECT_EQ(low.row, 2);
  EXPECT_EQ(low.height, 480) << "the panel scrolls";
  EXPECT_EQ(place_rows(std::vector<HeatRow>(3), 120, 2, 20, 4).row, 20);
}

TEST(HeatCells, ShowASpikeOfOneStepAmongMany) {
  for (const unsigned spike : {770U, 777U, 779U}) {
    std::vector<std::vector<double>> steps(1000, {1, 0});
    steps[spike] = {50, 0};
    const auto lanes = lanes_of(steps);
    std::vector<HeatRow> rows(2);
    rows[1].reading = 1;
    const HeatCells cells = heat_cells(*lanes, rows, 100);
    ASSERT_EQ(cells.columns, 100U);
    EXPECT_EQ(cells.step(0, 77), spike);
    EXPECT_EQ(cells.step(1, 77), 770U) << "the first step of equal readings";
    EXPECT_EQ(cells.step(0, 99), 990U);
  }
}

TEST(HeatCells, HaveAtMostAColumnPerStep) {
  const auto lanes = lanes_of({{1}, {2}, {3}});
  const HeatCells cells = heat_cells(*lanes, std::vector<HeatRow>(1), 500);
  ASSERT_EQ(cells.columns, 3U);
  EXPECT_EQ(cells.steps, (std::vector<std::uint32_t>{0, 1, 2}));
}

TEST(HeatLevel, IsZeroOnlyForTheLowerEnd) {
  const PressureRange range{0, 100};
  EXPECT_EQ(heat_level(range, 0), 0);
  EXPECT_EQ(heat_level(range, -5), 0);
  EXPECT_EQ(heat_level(range, 1e-6), 1) << "the smallest reading differs from none";
  EXPECT_EQ(heat_level(range, 2.5 * range.hi / kHeatLevels), 3) << "the next level begins above the limit of this one";
  EXPECT_EQ(heat_level(range, 50), kHeatLevels / 2);
  EXPECT_EQ(heat_level(range, 1000), kHeatLevels);
  EXPECT_EQ(heat_level({0, 0}, 1), 0);
}

TEST(HeatRuns, JoinCellsOfOneColour) {
  const auto lanes = lanes_of({{0, 9}, {100, 9}, {100, 0}, {50, 9}});
  std::vector<HeatRow> rows(2);
  rows[1].reading = 1;
  const std::vector<HeatRun> runs = heat_runs(*lanes, rows, heat_cells(*lanes, rows, 4), {PressureRange{0, 100}});
  ASSERT_EQ(runs.size(), 4U);
  EXPECT_EQ(runs[0].first, 1U);
  EXPECT_EQ(runs[0].last, 3U);
  EXPECT_EQ(runs[0].level, kHeatLevels);
  EXPECT_EQ(runs[1].first, 3U);
  EXPECT_EQ(runs[1].last, 4U);
  EXPECT_EQ(runs[2].row, 1U);
  EXPECT_EQ(runs[2].last, 2U);
  EXPECT_EQ(runs[3].first, 3U);
}

}  // namespace
}  // namespace taxel::ui
