// The simulation's thread and its recorded steps: displayed again, resumed from, stopped at, and kept after an
// instability.
#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <thread>

#include "core/run/history/breakpoints.h"
#include "core/run/recording/run_recorder.h"
#include "core/sensor/error_bars.h"
#include "core/sim/simulator.h"
#include "fixtures/asked_sim.h"
#include "fixtures/box_sweep.h"
#include "fixtures/sweep_model.h"

namespace taxel {
namespace {

class ThreadHistory : public testing::Test, protected test::AskedSim {
 protected:
  static void SetUpTestSuite() { model_ = test::fingertip_model(1e5); }
  static void TearDownTestSuite() { model_.reset(); }
  SimFramePtr run_to(int step) {
    ask(LoadScenarioCommand{model_, test::box_sweep()});
    return ask(StepCommand{step});
  }
  /// Plays a sweep with these breakpoints, at most until its end.
  SimFramePtr sweep_until_stopped(const Breakpoints& limits) {
    ask(BreakpointsCommand{limits});
    ask(LoadScenarioCommand{model_, test::box_sweep()});
    ask(PlayCommand{});
    SimFramePtr frame = ask(StepCommand{2401});
    EXPECT_FALSE(frame->playing);
    return frame;
  }
  static SensorModelPtr model_;
};
SensorModelPtr ThreadHistory::model_;

TEST_F(ThreadHistory, ShowsAScrubbedStepAndKeepsTheTimeline) {
  const SimFramePtr before = run_to(1300), newest = ask(StepCommand{10});
  EXPECT_FALSE(newest->recorded);
  EXPECT_EQ(newest->history.first, 0u) << "the start, before the first step";
  EXPECT_EQ(newest->history.last, 1310u);
  EXPECT_EQ(newest->history.steps, 1311u);
  EXPECT_EQ(newest->history.lanes->rows(), 1311u);
  EXPECT_GT(newest->history.bytes, 100000u);
  EXPECT_GT(newest->history.step_seconds, 0);
  EXPECT_LT(newest->history.step_seconds, newest->step_seconds);
  const SimFramePtr scrubbed = ask(ScrubCommand{1300});
  EXPECT_TRUE(scrubbed->recorded);
  EXPECT_FALSE(scrubbed->playing);
  EXPECT_EQ(scrubbed->step, 1300u);
  EXPECT_EQ(scrubbed->time, before->time);
  EXPECT_EQ(scrubbed->travel, before->travel);
  EXPECT_EQ(scrubbed->sensors[0].readings, before->sensors[0].readings);
  EXPECT_EQ(scrubbed->sensors[0].surfaces[0].polygons.size(), before->sensors[0].surfaces[0].polygons.size());
  EXPECT_EQ(scrubbed->history.last, 1310u);
  EXPECT_EQ(scrubbed->trace->rows.size(), newest->trace->rows.size());
  EXPECT_EQ(ask(ScrubCommand{0})->step, 0u);
  const SimFramePtr back = ask(ScrubCommand{99999});
  EXPECT_EQ(back->step, 1310u);
  EXPECT_FALSE(back->recorded);
  EXPECT_EQ(back->sensors[0].readings, newest->sensors[0].readings);
}

TEST_F(ThreadHistory, ResumesFromTheDisplayedStepAndDiscardsLaterSteps) {
  run_to(1250);
  const SimFramePtr middle = ask(StepCommand{30}), later = ask(StepCommand{70});
  EXPECT_EQ(later->trace->edition, middle->trace->edition) << "rows were added";
  EXPECT_EQ(ask(ScrubCommand{1250})->trace->edition, later->trace->edition);
  const SimFramePtr again = ask(StepCommand{30});
  EXPECT_EQ(again->step, 1280u);
  EXPECT_FALSE(again->recorded);
  EXPECT_EQ(again->history.last, 1280u);
  EXPECT_EQ(again->history.lanes->steps.back().step, 1280u);
  EXPECT_EQ(again->sensors[0].readings, middle->sensors[0].readings);
  EXPECT_EQ(again->trace->rows.size(), middle->trace->rows.size());
  EXPECT_NE(again->trace->edition, middle->trace->edition) << "others took the place of the last rows";
  EXPECT_EQ(again->runs, middle->runs) << "the same run";
  EXPECT_EQ(ask(StepCommand{70})->sensors[0].readings, later->sensors[0].readings) << "and so on";
}

TEST_F(ThreadHistory, GivesTheSameRowsWhenResumedFromAnyStep) {
  run_to(1250);
  const SimFramePtr straight = ask(StepCommand{60});
  ASSERT_GT(straight->trace->rows.size(), 125U);
  for (std::uint64_t from = 1290; from < 1302; ++from) {  // rows are 10 steps apart: each place between two rows
    ask(ScrubCommand{from});
    const SimFramePtr again = ask(StepCommand{static_cast<int>(1310 - from)});
    ASSERT_EQ(again->step, 1310u);
    ASSERT_EQ(again->trace->rows.size(), straight->trace->rows.size()) << "from step " << from;
    for (std::size_t i = 0; i < straight->trace->rows.size(); ++i) {
      const TraceRow &one = straight->trace->rows[i], &other = again->trace->rows[i];
      EXPECT_EQ(one.time, other.time) << "row " << i << " from step " << from;
      EXPECT_EQ(one.travel, other.travel);
      EXPECT_EQ(one.readings, other.readings) << "row " << i << " from step " << from;
    }
  }
}

TEST_F(ThreadHistory, StopsAtTheSameJumpAfterGoingBack) {
  Breakpoints limits;
  limits.jump = 0.03;
  limits.on_jump = true;
  const SimFramePtr first = sweep_until_stopped(limits);
  ASSERT_TRUE(first->stop.has_value());
  const Jump jump = std::get<Jump>(*first->stop);
  const SimFramePtr after = ask(StepCommand{300});  // to the next jump, or 300 steps
  for (const std::uint64_t back : {first->step - 1, first->step - 40}) {
    EXPECT_FALSE(ask(ScrubCommand{back})->playing);
    ask(PlayCommand{});
    const SimFramePtr again = ask(StepCommand{300});
    EXPECT_EQ(again->step, first->step) << "from " << back;
    ASSERT_TRUE(again->stop.has_value());
    const Jump& same = std::get<Jump>(*again->stop);
    EXPECT_EQ(same.step, jump.step);
    EXPECT_EQ(same.taxel, jump.taxel);
    EXPECT_EQ(same.before, jump.before);
    EXPECT_EQ(same.part, jump.part);
    EXPECT_EQ(same.force_before, jump.force_before);
    EXPECT_EQ(same.at_equal_force, jump.at_equal_force);
  }
  EXPECT_EQ(ask(StepCommand{300})->step, after->step) << "and at the one after it";
}

TEST_F(ThreadHistory, ResumesAFinishedRunBeforeItsEnd) {
  Scenario scenario = test::box_sweep();
  scenario.as<scenarios::Sweep>().before = scenario.as<scenarios::Sweep>().past = 0.001;
  ask(LoadScenarioCommand{model_, scenario});
  const SimFramePtr end = ask(StepCommand{100000});
  ASSERT_TRUE(end->finished);
  ask(ScrubCommand{100});
  EXPECT_TRUE(ask(PlayCommand{})->playing);
  const SimFramePtr again = ask(StepCommand{100000});
  EXPECT_TRUE(again->finished);
  EXPECT_EQ(again->step, end->step);
  EXPECT_EQ(again->sensors[0].readings, end->sensors[0].readings);
  EXPECT_EQ(again->trace->rows.size(), end->trace->rows.size());
}

/// Each taxel's largest reading of the run so far. Infinite until the taxel was touched in 3 / limit steps.
class PeaksSoFar {
 public:
  PeaksSoFar(const SensorModel& model, double limit)
      : limit_(limit),
        peaks_(static_cast<std::size_t>(model.taxel_count()), 1e-4 * model.layout.material.modulus),
        touched_(peaks_.size(), 0) {}
  void add(std::span<const double> readings) {
    for (std::size_t k = 0; k < readings.size(); ++k) {
      peaks_[k] = std::max(peaks_[k], readings[k]);
      touched_[k] += readings[k] != 0 ? 1 : 0;
    }
  }
  [[nodiscard]] std::vector<double> scales() const {
    std::vector<double> all = peaks_;
    for (std::size_t k = 0; k < all.size(); ++k)
      if (touched_[k] * limit_ < 3) all[k] = std::numeric_limits<double>::infinity();
    return all;
  }

 private:
  double limit_;
  std::vector<double> peaks_;
  std::vector<int> touched_;
};

TEST_F(ThreadHistory, StopsAtTheFirstStepWithALargeSamplingError) {
  Breakpoints limits;
  limits.disagreement = 0.15;
  // By the definition, with a plain loop.
  const auto simulator = Simulator::make_scenario(model_, test::box_sweep());
  PeaksSoFar peaks(*model_, limits.disagreement);
  std::uint64_t expected = 0;
  SampleGap gap;
  double part = 0;
  while (expected == 0 && !simulator->finished()) {
    simulator->step();
    const StepView view = simulator->view();
    const SensorView& sensor = view.sensors[0];
    peaks.add(sensor.readings);
    const auto largest = largest_sample_gap(*model_, sensor.surfaces, sensor.readings, peaks.scales());
    if (!largest) continue;  // before the contact
    gap = *largest;
    part = gap.gap / peaks.scales()[static_cast<std::size_t>(gap.taxel)];
    if (part > limits.disagreement) expected = view.step;
  }
  ASSERT_GT(expected, 500u) << "this sweep has such a step, in contact";
  limits.on_disagreement = true;
  const SimFramePtr frame = sweep_until_stopped(limits);
  EXPECT_EQ(frame->step, expected);
  ASSERT_TRUE(frame->stop.has_value());
  const Disagreement& found = std::get<Disagreement>(*frame->stop);
  EXPECT_EQ(found.taxel, gap.taxel);
  EXPECT_EQ(found.sampled, gap.sampled);
  EXPECT_EQ(found.exact, gap.exact);
  EXPECT_EQ(found.part, part);
  EXPECT_TRUE(frame->history.lanes->steps.back().has(StepEvent::disagreement));
}

TEST_F(ThreadHistory, StopsAtTheFirstStepThatJumps) {
  Breakpoints limits;
  limits.jump = 0.03;
  // By the definition, with a plain loop.
  const auto simulator = Simulator::make_scenario(model_, test::box_sweep());
  simulator->step();  // the evaluation before the first step gives the same readings
  std::vector<double> before = row_of(simulator->view()).sensors[0].readings;
  PeaksSoFar peaks(*model_, limits.jump);
  peaks.add(before);
  std::uint64_t expected = 0;
  std::size_t expected_taxel = 0;
  for (std::uint64_t step = 2; expected == 0 && !simulator->finished(); ++step) {
    simulator->step();
    const std::vector<double> now = row_of(simulator->view()).sensors[0].readings;
    peaks.add(now);
    double most = limits.jump;
    for (std::size_t k = 0; k < now.size(); ++k) {
      const double part = std::abs(now[k] - before[k]) / peaks.scales()[k];
      if (part <= most) continue;
      most = part;
      expected = step;
      expected_taxel = k;
    }
    before = now;
  }
  ASSERT_GT(expected, 500u) << "this sweep has such a step, in contact";
  limits.on_jump = true;
  const SimFramePtr frame = sweep_until_stopped(limits);
  EXPECT_EQ(frame->step, expected);
  ASSERT_TRUE(frame->stop.has_value());
  const Jump& jump = std::get<Jump>(*frame->stop);
  EXPECT_EQ(jump.step, expected);
  EXPECT_EQ(jump.taxel, static_cast<int>(expected_taxel));
  EXPECT_EQ(jump.after, before[expected_taxel]);
  EXPECT_GT(jump.part, 0.03);
  EXPECT_TRUE(frame->history.lanes->steps.back().has(StepEvent::jump) ||
              frame->history.lanes->steps.back().has(StepEvent::jump_at_equal_force));
  EXPECT_EQ(frame->sensors[0].readings, before);
  const SimFramePtr on = ask(StepCommand{1});
  EXPECT_EQ(on->step, expected + 1) << "it goes on";
}

TEST_F(ThreadHistory, KeepsTheDisplayedStepIfTheLayoutIsReplaced) {
  Layout moved = model_->layout;
  for (Taxel& taxel : moved.taxels) taxel.radius *= 0.8;
  const SensorModelPtr edited = build_sensor_model(moved, model_->mesh, moved.mesh.sha256, "edited");
  const SimFramePtr before = run_to(1400);
  ask(StepCommand{500});
  ask(ScrubCommand{1400});
  const SimFramePtr replaced = ask(ReplaceModelCommand{model_, edited});
  EXPECT_TRUE(replaced->recorded);
  EXPECT_EQ(replaced->scene->sensors[0], model_);
  EXPECT_EQ(replaced->simulated->sensors[0], edited);
  EXPECT_EQ(replaced->sensors[0].readings, before->sensors[0].readings);
  const SimFramePtr on = ask(StepCommand{1});
  EXPECT_EQ(on->step, 1401u);
  EXPECT_EQ(on->scene->sensors[0], edited);
}

TEST_F(ThreadHistory, StopsBeforeAnUnstableStepAndNamesTheBody) {
  const std::filesystem::path file = std::filesystem::path(TAXEL_BINARY_DIR) / "unstable.xml";
  std::ofstream(file) << R"(<mujoco><option timestep="0.01" gravity="0 0 -1e10"/><worldbody>
    <body name="still"><geom type="sphere" size="0.1"/></body>
    <body name="stone" pos="0 0 1"><freejoint/><geom type="sphere" size="0.1" contype="0" conaffinity="0"/></body>
  </worldbody></mujoco>)";
  ask(LoadSceneCommand{file.string()});
  const SimFramePtr frame = ask(StepCommand{100000});
  EXPECT_NE(frame->error.find("body \"stone\""), std::string::npos) << frame->error;
  EXPECT_FALSE(frame->playing);
  EXPECT_GT(frame->step, 5u);
  EXPECT_EQ(frame->step, frame->history.last) << "the step before";
  EXPECT_EQ(frame->history.first, 0u) << "the history is kept";
  for (const Pose& pose : frame->geom_poses) EXPECT_TRUE(std::isfinite(pose.p.z));
  EXPECT_LT(frame->geom_poses[1].p.z, -1e5) << "it fell, and was not put back to the start";
  const SimFramePtr earlier = ask(ScrubCommand{2});
  EXPECT_EQ(earlier->step, 2u);
  const SimFramePtr again = ask(PlayCommand{});
  EXPECT_TRUE(again->error.empty()) << "it goes on from there";
  EXPECT_EQ(ask(StepCommand{1})->step, 3u);
  EXPECT_EQ(ask(StepCommand{100000})->step, frame->step) << "to the same end";
  const SimFramePtr rewound = ask(PlayCommand{});
  EXPECT_EQ(rewound->step, 0u) << "from where it blew up there is no way on";
}

TEST_F(ThreadHistory, ChangesLimitsDuringARun) {
  run_to(300);
  ask(ScrubCommand{10});
  const SimFramePtr frame = ask(StepHistoryLimitsCommand{{50, std::size_t{1} << 30}});
  EXPECT_EQ(frame->history.steps, 50u);
  EXPECT_EQ(frame->history.first, 251u);
  EXPECT_EQ(frame->step, 251u) << "the step that was shown is forgotten: the oldest is";
  EXPECT_EQ(frame->history.limits.steps, 50u);
  EXPECT_EQ(ask(ResetCommand{})->history.steps, 1u);
}

}  // namespace
}  // namespace taxel
