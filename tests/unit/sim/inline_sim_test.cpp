// The host without a thread: steps are made in send() and advance(), and the same calls give the same steps.
#include "core/sim/host/sim_host.h"

#include <gtest/gtest.h>

#include "fixtures/asked_sim.h"
#include "fixtures/box_sweep.h"
#include "fixtures/same_step.h"
#include "fixtures/sweep_model.h"

namespace taxel {
namespace {

constexpr double kFrame = 0.020;  // [s] twenty steps of 1 ms

class InlineHost : public testing::Test {
 protected:
  static void SetUpTestSuite() { model_ = test::fingertip_model(1e5); }
  static void TearDownTestSuite() { model_.reset(); }
  void SetUp() override {
    sim_.send(LoadScenarioCommand{model_, test::box_sweep()});
    sim_.take();
  }
  static SensorModelPtr model_;
  InlineSim sim_;
};
SensorModelPtr InlineHost::model_;

TEST_F(InlineHost, ExecutesACommandBeforeSendReturns) {
  EXPECT_EQ(sim_.send(StepCommand{3}), 2U);
  EXPECT_EQ(sim_.send(StepCommand{4}), 3U);
  const SimReplies replies = sim_.take();
  ASSERT_NE(replies.frame, nullptr);
  EXPECT_EQ(replies.frame->step, 7U);
  ASSERT_EQ(replies.events.size(), 2U);
  EXPECT_EQ(replies.events[0].reply_to, 2U);
  EXPECT_EQ(replies.events[1].reply_to, 3U);
  const SimReplies none = sim_.take();
  EXPECT_EQ(none.frame, nullptr);
  EXPECT_TRUE(none.events.empty());
}

TEST_F(InlineHost, MakesTheStepsThatFillAFrameWhilePlaying) {
  sim_.advance(kFrame);
  EXPECT_EQ(sim_.take().frame, nullptr) << "a loaded scene is paused";
  sim_.send(PlayCommand{});
  sim_.advance(kFrame);
  const SimFramePtr frame = sim_.take().frame;
  ASSERT_NE(frame, nullptr);
  EXPECT_TRUE(frame->playing);
  EXPECT_EQ(frame->step, 20U);
  sim_.send(PauseCommand{});
  sim_.advance(kFrame);
  EXPECT_EQ(sim_.take().frame->step, 20U);
}

TEST_F(InlineHost, MakesNoStepsWhileRepliesWait) {
  sim_.send(PlayCommand{});
  sim_.advance(kFrame);
  sim_.advance(kFrame);
  EXPECT_EQ(sim_.take().frame->step, 20U) << "the first steps were not displayed";
  sim_.send(BreakpointsCommand{});
  sim_.advance(kFrame);
  EXPECT_EQ(sim_.take().frame->step, 20U);
  sim_.send(SpeedCommand{2});
  sim_.advance(kFrame);
  EXPECT_EQ(sim_.take().frame->step, 60U) << "a new speed holds up nothing";
}

TEST_F(InlineHost, KeepsTheTimeThatDoesNotFillAStep) {
  sim_.send(SpeedCommand{0.025});  // half a step per frame
  sim_.send(PlayCommand{});
  sim_.advance(kFrame);
  EXPECT_EQ(sim_.take().frame->step, 0U);
  sim_.advance(kFrame);
  EXPECT_EQ(sim_.take().frame->step, 1U);
  sim_.advance(kFrame);
  sim_.send(ScrubCommand{0});
  sim_.take();
  sim_.send(PlayCommand{});
  sim_.advance(kFrame);
  EXPECT_EQ(sim_.take().frame->step, 0U) << "another step begins with a whole one";
}

TEST_F(InlineHost, StopsAtTheEndAndPlaysAgainFromTheStart) {
  Scenario scenario = test::box_sweep();
  scenario.as<scenarios::Sweep>().before = scenario.as<scenarios::Sweep>().past = 0.001;
  sim_.send(LoadScenarioCommand{model_, scenario});
  sim_.take();
  sim_.send(PlayCommand{});
  sim_.advance(10);
  const SimReplies end = sim_.take();
  EXPECT_TRUE(end.frame->finished);
  EXPECT_FALSE(end.frame->playing);
  EXPECT_NE(test::newest<Finished>(end.events), nullptr);
  sim_.send(PlayCommand{});
  sim_.advance(kFrame);
  const SimReplies start = sim_.take();
  EXPECT_NE(test::newest<RunStarted>(start.events), nullptr);
  EXPECT_EQ(start.frame->step, 0U) << "the first step is displayed first";
  EXPECT_TRUE(start.frame->playing);
}

TEST_F(InlineHost, GivesTheSameStepsByCommandsAndByTime) {
  InlineSim other;
  other.send(LoadScenarioCommand{model_, test::box_sweep()});
  other.send(StepCommand{1400});
  sim_.send(PlayCommand{});
  SimFramePtr frame;
  for (int i = 0; i < 70; ++i) {
    sim_.advance(kFrame);
    frame = sim_.take().frame;
  }
  test::expect_same_step(*frame, *other.take().frame);
}

}  // namespace
}  // namespace taxel
