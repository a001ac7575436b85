// The simulation's thread: commands in, frames out, in real time or on request.
#include "core/sim/host/sim_host.h"

#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <iterator>
#include <thread>
#include <utility>
#include <vector>

#include "core/run/recording/run_recorder.h"
#include "core/sim/host/sim_loop.h"
#include "core/sim/simulator.h"
#include "fixtures/box_sweep.h"
#include "fixtures/sweep_model.h"

namespace taxel {
namespace {

using namespace std::chrono_literals;

/// Waits for a frame that satisfies the condition, and adds all events until then. Returns null after ten seconds.
SimFramePtr await(SimThread& thread, const std::function<bool(const SimFrame&)>& condition,
                  std::vector<SimEvent>* events = nullptr) {
  const auto end = std::chrono::steady_clock::now() + 10s;
  while (std::chrono::steady_clock::now() < end) {
    SimReplies replies = thread.take();
    if (events != nullptr) std::move(replies.events.begin(), replies.events.end(), std::back_inserter(*events));
    if (replies.frame != nullptr && condition(*replies.frame)) return replies.frame;
    std::this_thread::sleep_for(1ms);
  }
  return nullptr;
}

class Thread : public testing::Test {
 protected:
  static void SetUpTestSuite() { model_ = test::fingertip_model(1e5); }
  static void TearDownTestSuite() { model_.reset(); }
  void load(const Scenario& scenario = test::box_sweep()) { thread_.send(LoadScenarioCommand{model_, scenario}); }
  static SensorModelPtr model_;
  SimThread thread_;
};
SensorModelPtr Thread::model_;

TEST_F(Thread, StepsExactlyOnRequest) {
  load();
  thread_.send(StepCommand{1300});
  const SimFramePtr frame = await(thread_, [](const SimFrame& f) { return f.step == 1300; });
  ASSERT_NE(frame, nullptr);
  EXPECT_FALSE(frame->playing);
  EXPECT_GT(frame->step_seconds, 1e-6);
  EXPECT_LT(frame->step_seconds, 1.0);
  std::this_thread::sleep_for(50ms);
  EXPECT_EQ(thread_.take().frame, nullptr);  // the clock continues, the simulation does not
  // The result equals that of a plain loop.
  const auto simulator = Simulator::make_scenario(model_, test::box_sweep());
  std::vector<TraceRow> rows;
  for (int n = 0; n < 1300; ++n) {
    simulator->step();
    if (simulator->row_due())
      rows.push_back({simulator->view().time, simulator->view().travel, row_of(simulator->view()).sensors[0].readings});
  }
  EXPECT_EQ(frame->sensors[0].readings, row_of(simulator->view()).sensors[0].readings);
  ASSERT_EQ(frame->trace->rows.size(), rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) EXPECT_EQ(frame->trace->rows[i].readings, rows[i].readings);
}

TEST_F(Thread, StopsAtTheEndAndPlaysAgainFromTheStart) {
  Scenario scenario = test::box_sweep();
  scenario.as<scenarios::Sweep>().before = scenario.as<scenarios::Sweep>().past = 0.001;
  load(scenario);
  thread_.send(SpeedCommand{1e-3});
  thread_.send(PlayCommand{});
  thread_.send(StepCommand{100000});
  SimFramePtr frame = await(thread_, [](const SimFrame& f) { return f.finished; });
  ASSERT_NE(frame, nullptr);
  EXPECT_FALSE(frame->playing);
  EXPECT_EQ(frame->step, 201u);
  EXPECT_EQ(frame->trace->rows.size(), 21u);
  const CommandId again = thread_.send(PlayCommand{});
  std::vector<SimEvent> events;
  frame = await(
      thread_, [](const SimFrame& f) { return f.playing; }, &events);
  ASSERT_NE(frame, nullptr);
  EXPECT_LE(frame->step, 1u) << "the first step is due at once";
  ASSERT_FALSE(events.empty());
  EXPECT_EQ(events[0].reply_to, again);
  EXPECT_EQ(std::get<RunStarted>(events[0].what).run, 2U);
}

TEST_F(Thread, RunsAtTheRequestedSpeedInRealTime) {
  load();
  thread_.send(SpeedCommand{0.5});
  thread_.send(PlayCommand{});
  ASSERT_NE(await(thread_, [](const SimFrame& f) { return f.playing; }), nullptr);
  const auto begin = std::chrono::steady_clock::now();
  const SimFramePtr frame = await(thread_, [](const SimFrame& f) { return f.time >= 0.15; });
  const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  ASSERT_NE(frame, nullptr);
  EXPECT_GE(wall, 0.8 * 0.3);  // never faster; slower on a busy machine
  EXPECT_GT(frame->measured_speed, 0);
  thread_.send(PauseCommand{});
  const SimFramePtr paused = await(thread_, [](const SimFrame& f) { return !f.playing; });
  ASSERT_NE(paused, nullptr);
  std::this_thread::sleep_for(30ms);
  EXPECT_EQ(thread_.take().frame, nullptr);
}

TEST_F(Thread, MakesNoFramesThatAreNotRead) {
  load();
  thread_.send(PlayCommand{});
  ASSERT_NE(await(thread_, [](const SimFrame& f) { return f.playing && f.step > 0; }), nullptr);
  std::this_thread::sleep_for(600ms);
  const SimFramePtr waited = thread_.take().frame;
  ASSERT_NE(waited, nullptr);
  const SimFramePtr next = await(thread_, [](const SimFrame&) { return true; });
  ASSERT_NE(next, nullptr) << "they are made again";
  EXPECT_GT(next->time, waited->time + 0.05) << "frames of running time lie 1/60 s apart";
}

TEST_F(Thread, GoesBackAndClearsTheTraceOnReset) {
  load();
  thread_.send(StepCommand{50});
  ASSERT_NE(await(thread_, [](const SimFrame& f) { return f.step == 50; }), nullptr);
  thread_.send(ResetCommand{});
  const SimFramePtr frame = await(thread_, [](const SimFrame& f) { return f.step == 0; });
  ASSERT_NE(frame, nullptr);
  EXPECT_TRUE(frame->trace->rows.empty());
  EXPECT_EQ(frame->time, 0);
}

TEST_F(Thread, ReportsASceneThatDoesNotLoadAndKeepsTheOldOne) {
  load();
  thread_.send(StepCommand{3});
  ASSERT_NE(await(thread_, [](const SimFrame& f) { return f.step == 3; }), nullptr);
  thread_.send(LoadSceneCommand{"no_such_scene.xml"});
  std::vector<SimEvent> events;
  const SimFramePtr frame = await(
      thread_, [](const SimFrame&) { return true; }, &events);
  ASSERT_NE(frame, nullptr);
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(events[0].reply_to, 3U);
  EXPECT_NE(std::get<Refused>(events[0].what).why.find("no_such_scene.xml"), std::string::npos);
  EXPECT_EQ(frame->error, "");
  EXPECT_EQ(frame->step, 3u);
  thread_.send(StepCommand{1});
  EXPECT_NE(await(thread_, [](const SimFrame& f) { return f.step == 4; }), nullptr);
}

TEST_F(Thread, HasAnEmptyFrameWithoutAScene) {
  thread_.send(PlayCommand{});
  const SimFramePtr frame = await(thread_, [](const SimFrame&) { return true; });
  ASSERT_NE(frame, nullptr);
  ASSERT_NE(frame->scene, nullptr);
  EXPECT_TRUE(frame->scene->geoms.empty());
  EXPECT_FALSE(frame->playing);
}

TEST_F(Thread, ContinuesIfNoFrameIsRead) {
  load();
  thread_.send(SpeedCommand{1000});
  thread_.send(PlayCommand{});
  std::this_thread::sleep_for(200ms);  // many more frames than are ever read
  thread_.send(PauseCommand{});
  const SimFramePtr frame = await(thread_, [](const SimFrame& f) { return !f.playing; });
  ASSERT_NE(frame, nullptr);
  EXPECT_GT(frame->step, 20u);
}

TEST_F(Thread, DropsFramesAndKeepsAllEvents) {
  load();
  for (int i = 0; i < 50; ++i) thread_.send(StepCommand{1});
  const CommandId last = thread_.send(ResetCommand{});
  std::vector<SimEvent> events;
  const auto is_reset = [&](const SimFrame&) { return !events.empty() && events.back().reply_to == last; };
  const SimFramePtr frame = await(thread_, is_reset, &events);
  ASSERT_NE(frame, nullptr);
  EXPECT_EQ(frame->step, 0U) << "the frame includes the effect of its events";
  ASSERT_EQ(events.size(), 53U) << "the scene starts a run and is loaded";
  EXPECT_TRUE(std::holds_alternative<RunStarted>(events[0].what));
  EXPECT_TRUE(std::holds_alternative<SceneLoaded>(events[1].what));
  for (std::size_t i = 2; i < 52; ++i) {
    EXPECT_TRUE(std::holds_alternative<Done>(events[i].what));
    EXPECT_EQ(events[i].reply_to, i);
  }
  EXPECT_EQ(std::get<RunStarted>(events[52].what).run, 2U);
}

TEST_F(Thread, ReportsTheEndOfARunInRealTime) {
  Scenario scenario = test::box_sweep();
  scenario.as<scenarios::Sweep>().before = scenario.as<scenarios::Sweep>().past = 0.001;
  load(scenario);
  thread_.send(SpeedCommand{1000});
  thread_.send(PlayCommand{});
  std::vector<SimEvent> events;
  const SimFramePtr frame = await(
      thread_, [](const SimFrame& f) { return f.finished; }, &events);
  ASSERT_NE(frame, nullptr);
  ASSERT_FALSE(events.empty());
  EXPECT_TRUE(std::holds_alternative<Finished>(events.back().what));
  EXPECT_EQ(events.back().reply_to, 0U) << "no command caused the last step";
}

TEST(StepTime, IsTheMeanOfTheLatestSteps) {
  StepTime time;
  EXPECT_EQ(time.mean_seconds(), 0);
  time.add(1ms);
  time.add(2ms);
  EXPECT_DOUBLE_EQ(time.mean_seconds(), 1.5e-3);
  for (int n = 0; n < 1000; ++n) time.add(5ms);
  EXPECT_DOUBLE_EQ(time.mean_seconds(), 5e-3) << "what lies further back is forgotten";
  time.add(5ms + 256us);
  EXPECT_DOUBLE_EQ(time.mean_seconds(), 5.001e-3);
}

TEST(Pacing, RequestsDueStepsAndSkipsStepsThatAreTooLate) {
  Pacing pacing;
  pacing.restart(100.0, 2.0);  // twice as fast as the clock
  EXPECT_DOUBLE_EQ(pacing.wait(100.0), 0.0);
  pacing.advance(0.01, 100.0);
  EXPECT_NEAR(pacing.wait(100.0), 0.005, 1e-12);
  EXPECT_LE(pacing.wait(100.0051), 0.0);
  for (int n = 1; n < 200; ++n) pacing.advance(0.01, 100.0 + 0.005 * n);
  EXPECT_NEAR(pacing.measured_speed(100.0 + 0.005 * 199), 2.0, 0.03);
  pacing.advance(0.01, 150.0);  // fifty seconds lost
  EXPECT_GE(pacing.wait(150.0), -0.06);
}

/// Returns the number of frames made from `begin` to `end` by a loop that looks at the clock each `look`.
int frames_of(FrameSchedule& schedule, double begin, double end, double look) {
  int frames = 0;
  for (double now = begin; now < end; now += look) {
    if (!schedule.is_due(now)) continue;
    schedule.made(now);
    ++frames;
  }
  return frames;
}

TEST(FrameSchedule, KeepsItsRateAlthoughFramesAreLate) {
  for (const double look : {0.0001, 0.0023, 0.0071, 0.0164}) {
    FrameSchedule schedule(1.0 / 60);
    EXPECT_NEAR(frames_of(schedule, 100, 110, look), 600, 1) << look;
  }
}

TEST(FrameSchedule, DoesNotMakeUpForMissedFrames) {
  FrameSchedule schedule(1.0 / 60);
  EXPECT_NEAR(frames_of(schedule, 100, 110, 0.04), 250, 1) << "each look makes one frame";
  EXPECT_NEAR(frames_of(schedule, 150, 151, 0.001), 60, 1) << "after forty seconds without a look";
}

TEST(FrameSchedule, CountsTheIntervalFromAFrameThatWasNotDue) {
  FrameSchedule schedule(0.02);
  schedule.made(100);
  schedule.made(100.015);  // such a frame follows a command
  EXPECT_FALSE(schedule.is_due(100.034));
  EXPECT_TRUE(schedule.is_due(100.0351));
}

}  // namespace
}  // namespace taxel
