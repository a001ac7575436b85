// A simulation without a thread carries out commands and makes steps only when it is called.
#include "core/sim/host/sim_loop.h"

#include <gtest/gtest.h>

#include "fixtures/box_sweep.h"
#include "fixtures/same_step.h"
#include "fixtures/sensor_scene.h"
#include "fixtures/sweep_model.h"

namespace taxel {
namespace {

class LoopTest : public testing::Test {
 protected:
  static void SetUpTestSuite() { model_ = test::fingertip_model(1e5); }
  static void TearDownTestSuite() { model_.reset(); }
  void carry_out(const SimCommand& command) { taxel::carry_out(loop_, ++sent_, command); }
  void load() { carry_out(LoadScenarioCommand{model_, test::box_sweep()}); }
  SimFramePtr frame() { return make_frame(loop_, 0, true, true); }
  /// Returns the only event since the last call.
  SimEvent event() {
    const std::vector<SimEvent> events = loop_.events.take();
    EXPECT_EQ(events.size(), 1U);
    return events.empty() ? SimEvent{} : events.front();
  }
  static SensorModelPtr model_;
  SimLoop loop_;
  CommandId sent_ = 0;
};
SensorModelPtr LoopTest::model_;

TEST_F(LoopTest, HasAnEmptySceneBeforeTheFirstLoad) {
  const SimFramePtr empty = frame();
  ASSERT_NE(empty->scene, nullptr);
  EXPECT_TRUE(empty->scene->sensors.empty());
  carry_out(PlayCommand{});
  carry_out(StepCommand{3});
  EXPECT_FALSE(loop_.play.playing());
  EXPECT_FALSE(make_step(loop_));
  EXPECT_EQ(frame()->step, 0U);
  EXPECT_EQ(loop_.events.take().size(), 2U) << "one reply for each command";
}

TEST_F(LoopTest, MakesStepsOnlyWhenCalled) {
  load();
  const std::vector<SimEvent> events = loop_.events.take();
  ASSERT_EQ(events.size(), 2U);
  EXPECT_EQ(std::get<RunStarted>(events[0].what).run, 1U);
  EXPECT_TRUE(std::holds_alternative<SceneLoaded>(events[1].what));
  EXPECT_EQ(events[1].reply_to, 1U);
  EXPECT_FALSE(loop_.play.playing());
  carry_out(StepCommand{3});
  EXPECT_EQ(frame()->step, 3U);
  carry_out(PlayCommand{});
  EXPECT_TRUE(loop_.play.playing());
  EXPECT_EQ(frame()->step, 3U) << "the host makes the steps";
  EXPECT_TRUE(make_step(loop_));
  EXPECT_EQ(frame()->step, 4U);
  EXPECT_EQ(loop_.simulator->scene()->timestep, frame()->scene->timestep);
}

TEST_F(LoopTest, ReportsAPaceChangeOnce) {
  load();
  EXPECT_TRUE(loop_.play.consume_change());
  EXPECT_FALSE(loop_.play.consume_change());
  carry_out(BreakpointsCommand{});
  carry_out(StepCommand{2});
  EXPECT_FALSE(loop_.play.consume_change()) << "neither sets playing nor the speed";
  carry_out(SpeedCommand{2.0});
  EXPECT_TRUE(loop_.play.consume_change());
  EXPECT_EQ(loop_.play.speed(), 2.0);
  carry_out(SpeedCommand{-1.0});
  EXPECT_EQ(loop_.play.speed(), 2.0) << "a speed must be positive";
}

TEST_F(LoopTest, ReportsARefusedSceneAndRetainsThePreviousOne) {
  load();
  const std::shared_ptr<const SimScene> scene = frame()->scene;
  loop_.events.take();
  carry_out(LoadSceneCommand{"no_such_scene.xml"});
  const SimEvent refusal = event();
  EXPECT_EQ(refusal.reply_to, 2U);
  EXPECT_NE(std::get<Refused>(refusal.what).why.find("no_such_scene.xml"), std::string::npos);
  const SimFramePtr refused = frame();
  EXPECT_EQ(refused->error, "");
  EXPECT_FALSE(refused->failed);
  EXPECT_EQ(refused->scene, scene);
}

/// Actuators are found by their names: the second scene has them in another order.
TEST_F(LoopTest, KeepsControlsInAnotherSceneOnRequest) {
  const test::SensorScene files;
  const auto scene = [&](const char* name, const std::string& actuators) {
    const std::filesystem::path file = files.folder / name;
    write_file_atomically(file,
                          "<mujoco><worldbody><body><joint name='a'/><joint name='b' axis='1 0 0'/>"
                          "<geom size='.1'/></body></worldbody><actuator>" +
                              actuators + "</actuator></mujoco>");
    return file.string();
  };
  const std::string on_a = "<motor name='on a' joint='a'/>", on_b = "<motor name='on b' joint='b'/>";
  const std::string file = scene("ab.xml", on_a + on_b), other = scene("ba.xml", on_b + on_a);
  carry_out(LoadSceneCommand{file});
  carry_out(EditSceneCommand{SetControl{0, 0.5}});
  carry_out(StepCommand{3});
  carry_out(LoadSceneCommand{other, {}, {}, true});
  EXPECT_EQ(frame()->step, 0U);
  EXPECT_EQ(frame()->controls.controls, (std::vector<double>{0, 0.5}));
  carry_out(LoadSceneCommand{other});
  EXPECT_EQ(frame()->controls.controls, (std::vector<double>{0, 0}));
}

TEST_F(LoopTest, PublishesThePreviousStepOnRequest) {
  load();
  carry_out(StepCommand{1200});  // in contact
  const SimFramePtr earlier = frame();
  EXPECT_EQ(earlier->before, nullptr);
  carry_out(FollowStepBeforeCommand{true});
  carry_out(StepCommand{1});
  const SimFramePtr now = frame();
  ASSERT_NE(now->before, nullptr);
  test::expect_same_step(*now->before, *earlier);
  EXPECT_EQ(now->before->sensors[0].model, model_);
  EXPECT_EQ(now->before->sensors[0].time, earlier->time);
  EXPECT_EQ(make_frame(loop_, 0, true, false)->before, nullptr) << "the host can leave it out";
}

TEST_F(LoopTest, IdentifiesStepsByRunStepAndModelEdition) {
  load();
  carry_out(StepCommand{3});
  const StepId before = frame()->id();
  EXPECT_EQ(before.step, 3U);
  EXPECT_EQ(frame()->id(), before) << "a frame that is created again shows the same step";
  const SensorModelPtr other = test::fingertip_model(2e5);
  carry_out(ReplaceModelCommand{model_, other});
  const StepId replaced = frame()->id();
  EXPECT_EQ(replaced, (StepId{before.run, 3, before.model_edition + 1}));
  carry_out(ReplaceModelCommand{model_, other});
  EXPECT_EQ(frame()->id(), replaced) << "no sensor has the model any more";
  load();
  carry_out(StepCommand{3});
  EXPECT_EQ(frame()->id(), (StepId{before.run + 1, 3, 0}));
}

TEST_F(LoopTest, RecallsTheStepsThatTheHistoryHolds) {
  load();
  carry_out(StepCommand{1200});
  const SimFramePtr earlier = frame();
  carry_out(StepCommand{5});
  loop_.events.take();
  carry_out(RecallCommand{{1200, 5000}});
  const SimEvent recalled = event();
  const std::vector<StepPtr>& steps = std::get<StepsRecalled>(recalled.what).steps;
  ASSERT_EQ(steps.size(), 1U);
  test::expect_same_step(*steps[0], *earlier);
}

TEST_F(LoopTest, ContinuesFromTheDisplayedStep) {
  load();
  carry_out(StepCommand{1210});
  const SimFramePtr newest = frame();
  carry_out(ScrubCommand{1200});
  EXPECT_TRUE(frame()->recorded);
  EXPECT_EQ(frame()->step, 1200U);
  EXPECT_EQ(frame()->history.last, 1210U);
  carry_out(StepCommand{10});
  EXPECT_EQ(frame()->history.last, 1210U);
  test::expect_same_step(*frame(), *newest);
}

TEST_F(LoopTest, ReportsWhyItStopsByItself) {
  carry_out(BreakpointsCommand{{.on_jump = true, .jump = 0.03}});
  load();
  loop_.events.take();
  carry_out(StepCommand{2401});
  const SimEvent stopped = event();
  const Stopped& stop = std::get<Stopped>(stopped.what);
  EXPECT_EQ(std::get<Jump>(stop.stop).step, frame()->step);
  EXPECT_EQ(stop.scene, frame()->scene);
  carry_out(BreakpointsCommand{});
  loop_.events.take();
  carry_out(StepCommand{100000});
  const SimEvent end = event();
  EXPECT_TRUE(std::holds_alternative<Finished>(end.what));
  EXPECT_EQ(end.reply_to, 5U);
  carry_out(StepCommand{1});
  const SimEvent nothing = event();
  EXPECT_TRUE(std::holds_alternative<Done>(nothing.what)) << "the end is reported once";
}

TEST_F(LoopTest, ReplacesOnlyAModelThatASensorUses) {
  load();
  loop_.events.take();
  const SensorModelPtr other = test::fingertip_model(2e5);
  carry_out(ReplaceModelCommand{other, model_});
  const SimEvent unused = event();
  EXPECT_TRUE(std::holds_alternative<Done>(unused.what));
  carry_out(ReplaceModelCommand{model_, other});
  const SimEvent replaced = event();
  EXPECT_TRUE(std::holds_alternative<ModelReplaced>(replaced.what));
  EXPECT_EQ(frame()->scene->sensors[0], other);
}

}  // namespace
}  // namespace taxel
