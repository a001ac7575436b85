// The timeline: steps and pixels of its tracks.
#include <gtest/gtest.h>

#include "app/studio/nouns/timeline/timeline.h"

namespace taxel::ui {
namespace {

TEST(StepAt, FindsTheOnlyStepEverywhere) {
  Timeline timeline;
  timeline.lanes = {100, 0, 200, 50};
  timeline.steps = {7, 7};
  for (const float x : {-50.0f, 100.0f, 150.0f, 500.0f}) EXPECT_EQ(step_at(timeline, x), 7U) << x;
  EXPECT_FLOAT_EQ(x_of(timeline, 7), 150) << "one column over all of the width";
}

TEST(StepAt, FindsAStepInTracksWithoutWidth) {
  Timeline timeline;
  timeline.lanes = {100, 0, 100, 0};
  timeline.steps = {3, 8};
  EXPECT_EQ(step_at(timeline, 99), 3U);
  EXPECT_EQ(step_at(timeline, 101), 8U);
}

TEST(XOf, ContinuesBeyondTheRecordedSteps) {
  Timeline timeline;
  timeline.lanes = {100, 0, 200, 50};
  timeline.steps = {40, 49};  // 10 columns of 10 pixels
  EXPECT_FLOAT_EQ(x_of(timeline, 39), 95);
  EXPECT_FLOAT_EQ(x_of(timeline, 50), 205);
}

}  // namespace
}  // namespace taxel::ui
