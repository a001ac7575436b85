// A simulation without a thread executes commands and makes steps only when it is called.
#include "core/sim/host/sim_loop.h"

#include <gtest/gtest.h>

#include "fixtures/box_sweep.h"
#include "fixtures/same_step.h"
#include "fixtures/sweep_model.h"

namespace taxel {
namespace {

class LoopTest : public testing::Test {
 protected:
  static void SetUpTestSuite() { model_ = test::fingertip_model(1e5); }
  static void TearDownTestSuite() { model_.reset(); }
  void load() { loop_.execute(LoadScenarioCommand{model_, test::box_sweep()}); }
  SimFramePtr frame() { return loop_.make_frame(0, true, true); }
  static SensorModelPtr model_;
  SimLoop loop_;
};
SensorModelPtr LoopTest::model_;

TEST_F(LoopTest, HasAnEmptySceneBeforeTheFirstLoad) {
  const SimFramePtr empty = frame();
  ASSERT_NE(empty->scene, nullptr);
  EXPECT_TRUE(empty->scene->sensors.empty());
  loop_.execute(PlayCommand{});
  loop_.execute(StepCommand{3});
  EXPECT_FALSE(loop_.playing());
  EXPECT_FALSE(loop_.step());
  EXPECT_EQ(frame()->step, 0U);
  EXPECT_EQ(frame()->commands, 2U);
}

TEST_F(LoopTest, MakesStepsOnlyWhenCalled) {
  load();
  EXPECT_EQ(frame()->loads, 1U);
  EXPECT_FALSE(loop_.playing());
  loop_.execute(StepCommand{3});
  EXPECT_EQ(frame()->step, 3U);
  loop_.execute(PlayCommand{});
  EXPECT_TRUE(loop_.playing());
  EXPECT_EQ(frame()->step, 3U) << "the host makes the steps";
  EXPECT_TRUE(loop_.step());
  EXPECT_EQ(frame()->step, 4U);
  EXPECT_EQ(loop_.timestep(), frame()->scene->timestep);
}

TEST_F(LoopTest, ReportsAPaceChangeOnce) {
  load();
  EXPECT_TRUE(loop_.consume_pace_change());
  EXPECT_FALSE(loop_.consume_pace_change());
  loop_.execute(BreakpointsCommand{});
  loop_.execute(StepCommand{2});
  EXPECT_FALSE(loop_.consume_pace_change()) << "neither sets playing nor the speed";
  loop_.execute(SpeedCommand{2.0});
  EXPECT_TRUE(loop_.consume_pace_change());
  EXPECT_EQ(loop_.speed(), 2.0);
  loop_.execute(SpeedCommand{-1.0});
  EXPECT_EQ(loop_.speed(), 2.0) << "a speed must be positive";
}

TEST_F(LoopTest, ReportsARefusedSceneAndRetainsThePreviousOne) {
  load();
  const std::shared_ptr<const SimScene> scene = frame()->scene;
  loop_.execute(LoadSceneCommand{"no_such_scene.xml"});
  const SimFramePtr refused = frame();
  EXPECT_NE(refused->error.find("no_such_scene.xml"), std::string::npos) << refused->error;
  EXPECT_FALSE(refused->failed);
  EXPECT_EQ(refused->loads, 2U);
  EXPECT_EQ(refused->scene, scene);
}

TEST_F(LoopTest, PublishesThePreviousStepOnRequest) {
  load();
  loop_.execute(StepCommand{1200});  // in contact
  const SimFramePtr earlier = frame();
  EXPECT_EQ(earlier->before, nullptr);
  loop_.execute(FollowStepBeforeCommand{true});
  loop_.execute(StepCommand{1});
  const SimFramePtr now = frame();
  ASSERT_NE(now->before, nullptr);
  test::expect_same_step(*now->before, *earlier);
  EXPECT_EQ(now->before->sensors[0].model, model_);
  EXPECT_EQ(now->before->sensors[0].time, earlier->time);
  EXPECT_EQ(loop_.make_frame(0, true, false)->before, nullptr) << "the host can leave it out";
}

TEST_F(LoopTest, IdentifiesStepsByRunStepAndModelEdition) {
  load();
  loop_.execute(StepCommand{3});
  const StepId before = frame()->id();
  EXPECT_EQ(before.step, 3U);
  EXPECT_EQ(frame()->id(), before) << "a frame that is created again shows the same step";
  const SensorModelPtr other = test::fingertip_model(2e5);
  loop_.execute(ReplaceModelCommand{model_, other});
  const StepId replaced = frame()->id();
  EXPECT_EQ(replaced, (StepId{before.run, 3, before.model_edition + 1}));
  loop_.execute(ReplaceModelCommand{model_, other});
  EXPECT_EQ(frame()->id(), replaced) << "no sensor has the model any more";
  load();
  loop_.execute(StepCommand{3});
  EXPECT_EQ(frame()->id(), (StepId{before.run + 1, 3, 0}));
}

TEST_F(LoopTest, RecallsTheStepsThatTheHistoryHolds) {
  load();
  loop_.execute(StepCommand{1200});
  const SimFramePtr earlier = frame();
  loop_.execute(StepCommand{5});
  loop_.execute(RecallCommand{7, {1200, 5000}});
  const SimFramePtr now = frame();
  ASSERT_NE(now->recalled, nullptr);
  EXPECT_EQ(now->recalled->number, 7U);
  ASSERT_EQ(now->recalled->steps.size(), 1U);
  test::expect_same_step(*now->recalled->steps[0], *earlier);
}

TEST_F(LoopTest, ContinuesFromTheDisplayedStep) {
  load();
  loop_.execute(StepCommand{1210});
  const SimFramePtr newest = frame();
  loop_.execute(ScrubCommand{1200});
  EXPECT_TRUE(frame()->recorded);
  EXPECT_EQ(frame()->step, 1200U);
  EXPECT_EQ(frame()->history.last, 1210U);
  loop_.execute(StepCommand{10});
  EXPECT_EQ(frame()->history.last, 1210U);
  test::expect_same_step(*frame(), *newest);
}

}  // namespace
}  // namespace taxel
