// The runs of a study take place in parallel, and one that fails does not stop the others.
#include "core/sim/study.h"

#include <gtest/gtest.h>

#include <atomic>

#include "fixtures/box_sweep.h"
#include "fixtures/sweep_model.h"

namespace taxel {
namespace {

constexpr std::size_t kRuns = 4;

/// Four short sweeps that differ in depth.
std::vector<StudyRun> four_runs() {
  Study study;
  study.scenario = test::box_sweep();
  study.parameters.push_back({"depth", {0.0005, 0.0010, 0.0015, 0.0020}});
  return runs_of(study);
}

/// The reports of one study, by run.
struct Report {
  std::vector<int> steps = std::vector<int>(kRuns), ends = std::vector<int>(kRuns);
  std::vector<std::string> errors = std::vector<std::string>(kRuns);
};

/// Runs the study with at most three steps per run; run 1 has no model, and run 2 fails in its second step.
Report report_of(std::vector<StudyRun> runs) {
  static const SensorModelPtr sensor = test::fingertip_model(1e5);
  Report report;
  Progress progress;
  run_study(
      runs, [&](std::size_t run) { return run == 1 ? nullptr : sensor; },
      [&](std::size_t run, const Simulator&) {
        const int steps = ++report.steps[run];
        if (run == 2 && steps == 2) throw Error("no more");
        return steps < 3;
      },
      [&](std::size_t run, const std::string& error) {
        ++report.ends[run];
        report.errors[run] = error;
      },
      progress);
  EXPECT_EQ(progress.fraction(), 1);
  return report;
}

TEST(RunStudy, EndsEachRunOnceAndKeepsOthersWhenOneFails) {
  const Report report = report_of(four_runs());
  EXPECT_EQ(report.steps, (std::vector<int>{3, 0, 2, 3}));
  EXPECT_EQ(report.ends, (std::vector<int>{1, 0, 1, 1})) << "a run without a model has no end";
  EXPECT_EQ(report.errors, (std::vector<std::string>{"", "", "no more", ""}));
}

TEST(RunStudy, ReportsARunThatCannotBeMade) {
  std::vector<StudyRun> runs = four_runs();
  runs[0].scenario = with_object(runs[0].scenario, "/nowhere/none.obj");
  const Report report = report_of(runs);
  EXPECT_EQ(report.steps, (std::vector<int>{0, 0, 2, 3}));
  EXPECT_NE(report.errors[0].find("none.obj"), std::string::npos) << report.errors[0];
}

TEST(RunStudy, ThrowsErrorsOfTheModel) {
  Progress progress;
  const auto fail = [](std::size_t) -> SensorModelPtr { throw Error("no layout"); };
  EXPECT_THROW(run_study(four_runs(), fail, {}, {}, progress), Error);
}

TEST(RunStudy, StopsWhenItsProgressIsCancelled) {
  Progress progress;
  std::atomic<int> steps = 0;
  const SensorModelPtr sensor = test::fingertip_model(1e5);
  const auto step = [&](std::size_t, const Simulator&) {
    ++steps;
    progress.cancel();
    return true;
  };
  EXPECT_THROW(
      run_study(
          four_runs(), [&](std::size_t) { return sensor; }, step, [](std::size_t, const std::string&) {}, progress),
      Cancelled);
  EXPECT_LE(steps, static_cast<int>(kRuns));
}

}  // namespace
}  // namespace taxel
