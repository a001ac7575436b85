// Playback of recorded steps: equal durations, within the range, in both directions.
#include "core/run/history/replay.h"

#include <gtest/gtest.h>

#include <map>

namespace taxel {
namespace {

TEST(Replay, PlaysToTheEndAndStops) {
  Replay replay;
  replay.start(10, 1);
  EXPECT_EQ(replay.advance(0.4, {0, 20}, false), 10u);
  EXPECT_EQ(replay.advance(0.4, {0, 20}, false), 10u);
  EXPECT_EQ(replay.advance(0.4, {0, 20}, false), 11u) << "parts of a step add up";
  EXPECT_EQ(replay.advance(5, {0, 20}, false), 16u);
  EXPECT_EQ(replay.direction(), 1);
  EXPECT_EQ(replay.advance(50, {0, 20}, false), 20u);
  EXPECT_EQ(replay.direction(), 0);
  replay.start(10, -1);
  EXPECT_EQ(replay.advance(4, {3, 20}, false), 6u);
  EXPECT_EQ(replay.advance(40, {3, 20}, false), 3u);
  EXPECT_EQ(replay.direction(), 0);
  EXPECT_EQ(replay.advance(40, {3, 20}, false), 3u) << "it waits";
}

TEST(Replay, ShowsEachStepEquallyLongInALoop) {
  for (const int direction : {1, -1}) {
    Replay replay;
    replay.start(107, direction);
    std::map<std::uint64_t, int> shown;
    for (int i = 0; i < 8000; ++i) ++shown[replay.advance(0.25, {100, 119}, true)];
    EXPECT_EQ(shown.size(), 20u);
    for (const auto& [step, times] : shown) EXPECT_NEAR(times, 400, 4) << step;
    EXPECT_EQ(replay.direction(), direction);
  }
}

TEST(Replay, StaysInTheRangeAfterSeveralRounds) {
  Replay replay;
  replay.start(5, -1);
  EXPECT_EQ(replay.advance(1003, {0, 9}, true), 2u);
  replay.start(500, 1);  // outside, as when a range was marked elsewhere
  const std::uint64_t step = replay.advance(1, {0, 9}, true);
  EXPECT_LE(step, 9u);
}

}  // namespace
}  // namespace taxel
