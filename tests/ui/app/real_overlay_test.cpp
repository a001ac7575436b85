// The overlay of a real recording over the run: its start time and its alignment.
#include "app/studio/nouns/real/real_commands.h"

#include <gtest/gtest.h>

#include "fixtures/temp_folder.h"

namespace taxel::studio {
namespace {

TEST(RealOverlay, BeginsWithTheRunIfItCannotBeAligned) {
  const test::TempFolder folder;
  const std::string table = folder.write("real.csv", "time [s],taxel_1\n5,0\n6,1\n7,0\n").string();
  RealOverlay overlay;
  ui::RealState state;
  overlay.read(table, {1}, state);
  ASSERT_TRUE(state.asks);
  TaxelSeries run;  // one row only, so there is nothing to align with
  run.taxel_ids = {1};
  run.time = {2};
  run.values = {{0}};
  ASSERT_TRUE(overlay.overlay(state, run, 0)) << state.problem;
  const ui::RealShown& shown = *overlay.shown();
  EXPECT_FALSE(shown.alignment);
  EXPECT_EQ(shown.recording.series.time.front() + shown.shift, run.time.front());
  ASSERT_TRUE(overlay.overlay(state, {}, 0)) << state.problem;
  EXPECT_EQ(overlay.shown()->recording.series.time.front() + overlay.shown()->shift, 0) << "at 0 without a run";
  EXPECT_EQ(mapping_file_of("/data/press.csv"), "/data/press.recmap.json");
}

}  // namespace
}  // namespace taxel::studio
