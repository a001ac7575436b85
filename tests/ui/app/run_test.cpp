// The run of the window: which commands it sends, and which state it displays until the simulation replies.
#include "app/studio/host/run/run.h"

#include <gtest/gtest.h>

#include <memory>
#include <utility>

namespace taxel::studio {
namespace {

/// A simulation that only records its commands.
class FakeSim final : public SimHost {
 public:
  CommandId send(SimCommand command) override {
    commands.push_back(std::move(command));
    return commands.size();
  }
  void advance(double seconds) override { advanced += seconds; }
  SimReplies take() override { return {}; }
  void set_journal_folder(const std::string& /*folder*/) override {}

  std::vector<SimCommand> commands;
  double advanced = 0;
};

/// A run that displays step 15 of steps 10 to 20.
struct RunScene {
  FakeSim* sim = nullptr;
  std::unique_ptr<Run> run;
  SimFrame frame;

  RunScene() {
    auto host = std::make_unique<FakeSim>();
    sim = host.get();
    run = std::make_unique<Run>(std::move(host));
    auto scene = std::make_shared<SimScene>();
    scene->timestep = 0.001;
    frame.scene = frame.simulated = scene;
    frame.trace = std::make_shared<const Trace>();
    frame.step = 15;
    frame.history.first = 10, frame.history.last = 20, frame.history.steps = 11;
    build_scene(*run, PendingScene{});
    reply(1, SceneLoaded{});
    accept_pending(*run);
    release_hold(*run);
    show();
    sim->commands.resize(2);  // load and pause
  }
  void show() { EXPECT_TRUE(accept_frame(*run, std::make_shared<const SimFrame>(frame))); }
  void reply(CommandId command, SimReport what) { accept_reply(*run, {command, std::move(what)}); }
  /// The commands since the scene was loaded.
  [[nodiscard]] std::size_t sent() const { return sim->commands.size() - 2; }
  template <class Command>
  [[nodiscard]] const Command* newest() const {
    return std::get_if<Command>(&sim->commands.back());
  }
};

TEST(RunTest, PlaysFromTheRequestOn) {
  RunScene s;
  set_playing(*s.run, true, false);
  EXPECT_NE(s.newest<PlayCommand>(), nullptr);
  EXPECT_TRUE(s.run->playback.makes_steps());
  set_playing(*s.run, false, false);
  EXPECT_NE(s.newest<PauseCommand>(), nullptr);
  EXPECT_FALSE(s.run->moves());
}

TEST(RunTest, StopsWithTheSimulation) {
  for (const SimReport& stop : {SimReport{Finished{}}, SimReport{Failed{}}, SimReport{Stopped{}}}) {
    RunScene s;
    set_playing(*s.run, true, false);
    s.reply(3, Done{});
    s.reply(0, stop);
    EXPECT_FALSE(s.run->playback.plays);
  }
}

TEST(RunTest, IgnoresAStopBeforeTheNewestCommandToPlay) {
  RunScene s;
  set_playing(*s.run, true, false);
  s.reply(0, Finished{});
  EXPECT_TRUE(s.run->playback.plays) << "the command is not executed yet";
}

TEST(RunTest, HoldsARunUntilItIsReleased) {
  RunScene s;
  set_playing(*s.run, true, true);
  EXPECT_EQ(s.sent(), 0U);
  EXPECT_TRUE(s.run->playback.holds_run());
  EXPECT_FALSE(s.run->playback.makes_steps());
  release_hold(*s.run);
  EXPECT_NE(s.newest<PlayCommand>(), nullptr);
  EXPECT_TRUE(s.run->playback.makes_steps());
}

TEST(RunTest, HoldsSingleStepsAndMakesThemTogether) {
  RunScene s;
  s.frame.step = 20;
  s.show();
  step_by(*s.run, 1, true);
  step_by(*s.run, 1, true);
  release_hold(*s.run);
  ASSERT_NE(s.newest<StepCommand>(), nullptr);
  EXPECT_EQ(s.newest<StepCommand>()->steps, 2);
}

TEST(RunTest, StepsThroughRecordedStepsBeforeItSimulatesOne) {
  RunScene s;
  step_by(*s.run, 5, false);
  ASSERT_NE(s.newest<ScrubCommand>(), nullptr);
  EXPECT_EQ(s.newest<ScrubCommand>()->step, 20U);
  step_by(*s.run, -30, false);
  EXPECT_EQ(s.newest<ScrubCommand>()->step, 10U) << "the oldest recorded step";
  scrub(*s.run, 20);
  step_by(*s.run, 1, false);
  EXPECT_NE(s.newest<StepCommand>(), nullptr) << "counted from the requested step";
}

TEST(RunTest, ReplaysRecordedStepsAtTheSpeedOfTheSimulation) {
  RunScene s;
  set_speed(*s.run, 0.5);
  replay(*s.run, 1);
  EXPECT_TRUE(s.run->cursor.replays());
  advance_run(*s.run, 0.004);  // two steps of 1 ms at half the speed
  ASSERT_NE(s.newest<ScrubCommand>(), nullptr);
  EXPECT_EQ(s.newest<ScrubCommand>()->step, 17U);
  advance_run(*s.run, 1);
  EXPECT_EQ(s.newest<ScrubCommand>()->step, 20U);
  EXPECT_FALSE(s.run->cursor.replays()) << "it stops at the end";
}

TEST(RunTest, DisplaysNothingOfADroppedScene) {
  RunScene s;
  drop_scene(*s.run);
  EXPECT_EQ(s.run->frame, nullptr);
  EXPECT_FALSE(s.run->can_play());
  EXPECT_FALSE(accept_frame(*s.run, std::make_shared<const SimFrame>(s.frame)));
}

TEST(PeaksTest, RetainTheLargestReadingsOfOneTrace) {
  SimFrame frame;
  auto trace = std::make_shared<Trace>();
  trace->rows = {{0, 0, {1, 5, 2}}, {0, 0, {3, 4, 2}}};
  trace->edition = 1;
  frame.trace = trace;
  frame.sensors.resize(2);
  frame.sensors[0].readings = {2, 2};
  frame.sensors[1].readings = {7};
  Peaks peaks;
  peaks.add(frame);
  EXPECT_EQ(peaks.of_sensor(frame, 0), (std::vector<double>{3, 5}));
  EXPECT_EQ(peaks.of_sensor(frame, 1), (std::vector<double>{7}));
  EXPECT_TRUE(peaks.of_sensor(frame, 2).empty());
  EXPECT_TRUE(peaks.of_sensor(frame, -1).empty());
  auto other = std::make_shared<Trace>();
  other->edition = 2;
  frame.trace = other;
  peaks.add(frame);
  EXPECT_EQ(peaks.of_sensor(frame, 0), (std::vector<double>{2, 2})) << "another run starts again";
}

}  // namespace
}  // namespace taxel::studio
