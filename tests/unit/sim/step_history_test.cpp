// Recorded steps: the same bits as computed, for as many steps as fit, and a simulation that resumes from any of them
// with the same result.
#include "core/run/history/step_history.h"
#include "core/run/recording/run_recorder.h"

#include <gtest/gtest.h>

#include "fixtures/box_sweep.h"
#include "fixtures/counted_new.h"
#include "fixtures/recorded_simulation.h"
#include "fixtures/same_step.h"
#include "fixtures/sweep_model.h"

namespace taxel {
namespace {

using test::expect_same_step;
using test::RecordedSimulation;

constexpr int kBeforeContact = 800;  // steps of the sweep

class History : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    model_ = test::fingertip_model(1e5);
    Layout moved = model_->layout;
    for (Taxel& taxel : moved.taxels) taxel.radius *= 0.8;
    edited_ = build_sensor_model(moved, model_->mesh, moved.mesh.sha256, "edited");
  }
  static void TearDownTestSuite() { model_.reset(), edited_.reset(); }
  static RecordedSimulation sweep(int skipped = kBeforeContact) {
    RecordedSimulation run{Simulator::make_scenario(model_, test::box_sweep()), {}, {}};
    run.skip(skipped);
    return run;
  }
  static SensorModelPtr model_, edited_;
};
SensorModelPtr History::model_, History::edited_;

TEST_F(History, ReturnsStepsUnchangedAfterALayoutChange) {
  RecordedSimulation run = sweep();
  std::vector<SimFrame> kept;
  for (int i = 0; i < 520; ++i) {
    run.step();
    if (i < 20 || i % 37 == 0) kept.push_back(run.now());
  }
  run.simulator->replace_model(model_, edited_);
  run.history.replace_newest(run.simulator->view());
  for (int i = 0; i < 5; ++i) run.step();
  std::size_t with_polygons = 0, with_hits = 0;
  for (const SimFrame& frame : kept) {
    expect_same_step(run.recorded(frame.step), frame);
    for (const ContactSurface& surface : frame.sensors[0].surfaces) with_polygons += surface.polygons.empty() ? 0 : 1;
    for (const RayHit& hit : frame.sensors[0].hits) with_hits += hit.hit() ? 1 : 0;
  }
  EXPECT_GT(with_polygons, 5u) << "the finger touches the box in these steps";
  EXPECT_GT(with_hits, 20u);
  EXPECT_LE(kept.front().step + 500, run.history.last());
  EXPECT_EQ(run.recorded(run.history.last()).scene->sensors[0], edited_);
  expect_same_step(run.recorded(run.history.last()), run.now());
}

TEST_F(History, RereadsTheNewestStepByAnotherLayoutAndReportsIt) {
  RecordedSimulation run = sweep(1500);
  for (int i = 0; i < 10; ++i) run.step();
  const SimFrame before = run.now();
  run.simulator->replace_model(model_, edited_);
  run.history.replace_newest(run.simulator->view());
  expect_same_step(run.recorded(before.step), run.now());
  EXPECT_NE(run.now().sensors[0].readings, before.sensors[0].readings);
  const auto lanes = run.history.lanes();
  EXPECT_TRUE(lanes->steps.back().has(StepEvent::other_layout));
  const std::span<const double> row = lanes->readings_of(lanes->rows() - 1);
  EXPECT_TRUE(std::equal(row.begin(), row.end(), run.now().sensors[0].readings.begin()));
  run.step();
  EXPECT_FALSE(run.history.lanes()->steps.back().has(StepEvent::other_layout));
}

TEST_F(History, ResumesFromAnEarlierStepWithTheSameResult) {
  RecordedSimulation run = sweep();
  std::vector<SimFrame> frames;
  for (int i = 0; i < 400; ++i) {
    run.step();
    frames.push_back(run.now());
  }
  const std::uint64_t from = frames[120].step;
  run.simulator->restore_state(run.history.state(from));
  run.history.cut_after(from);
  EXPECT_EQ(run.history.last(), from);
  EXPECT_EQ(run.history.lanes()->steps.back().step, from);
  for (std::size_t i = 121; i < 400; ++i) {
    run.step();
    expect_same_step(run.now(), frames[i]);
    expect_same_step(run.recorded(frames[i].step), frames[i]);
  }
  Simulator& simulator = *run.simulator;
  EXPECT_TRUE(row_of(simulator.view()).sensors[0].readings == frames.back().sensors[0].readings);
}

void expect_same_rows(const HistoryLanes& a, const HistoryLanes& b) {
  ASSERT_EQ(a.rows(), b.rows());
  for (std::size_t row = 0; row < a.rows(); ++row) {
    const SensorSummary &one = a.sensor(row, 0), &other = b.sensor(row, 0);
    ASSERT_EQ(a.steps[row].step, b.steps[row].step);
    EXPECT_EQ(a.steps[row].events, b.steps[row].events) << "step " << a.steps[row].step;
    EXPECT_EQ(one.force, other.force);
    EXPECT_EQ(one.area, other.area);
    EXPECT_EQ(one.polygons, other.polygons);
    EXPECT_EQ(one.largest_jump, other.largest_jump) << "step " << a.steps[row].step;
    EXPECT_EQ(one.jumped_taxel, other.jumped_taxel) << "step " << a.steps[row].step;
    EXPECT_EQ(one.largest_reading, other.largest_reading) << "step " << a.steps[row].step;
  }
}

/// The rows of a run that goes back equal those of a straight run: largest readings, jumps and events depend only on
/// previous steps, including discarded ones.
TEST_F(History, HasTheRowsOfAStraightRunAfterGoingBack) {
  for (const std::size_t limit : {std::size_t{2000}, std::size_t{350}}) {
    RecordedSimulation run = sweep();
    Breakpoints breakpoints;
    breakpoints.jump = 0.03;
    run.history.set_breakpoints(breakpoints);
    run.history.set_limits({limit, std::size_t{1} << 30});
    for (int i = 0; i < 600; ++i) run.step();
    const auto straight = run.history.lanes();
    const std::uint64_t from = run.history.last() - 280;
    const double peak_there = straight->sensor(straight->row_of(from), 0).largest_reading;
    ASSERT_LT(peak_there, straight->sensor(straight->rows() - 1, 0).largest_reading) << "the peak comes later";
    ASSERT_GT(peak_there, 0);
    int events = 0;
    for (std::size_t row = straight->row_of(from); row < straight->rows(); ++row)
      events += straight->steps[row].events != 0 ? 1 : 0;
    ASSERT_GT(events, 0) << "something happens after it";
    run.simulator->restore_state(run.history.state(from));
    run.history.cut_after(from);
    for (int i = 0; i < 280; ++i) run.step();
    expect_same_rows(*run.history.lanes(), *straight);
  }
}

TEST_F(History, RefusesAStateOfAnotherScene) {
  RecordedSimulation run = sweep(0);
  SimState other;
  other.integration = {1, 2, 3};
  EXPECT_THROW(run.simulator->restore_state(other), std::exception);
}

TEST_F(History, KeepsTheLatestStepsThatFit) {
  RecordedSimulation run = sweep(1200);
  run.history.set_limits({300, std::size_t{1} << 30});
  for (int i = 0; i < 450; ++i) run.step();
  EXPECT_EQ(run.history.size(), 300u);
  EXPECT_EQ(run.history.last(), 1650u);
  EXPECT_EQ(run.history.first(), 1351u);
  EXPECT_FALSE(run.history.contains(1350));
  const auto lanes = run.history.lanes();
  ASSERT_EQ(lanes->rows(), 300u);
  for (std::size_t row = 0; row < lanes->rows(); ++row) {
    const SimFrame frame = run.recorded(lanes->steps[row].step);
    EXPECT_EQ(frame.time, lanes->steps[row].time);
    EXPECT_EQ(frame.sensors[0].readings[3], lanes->readings_of(row)[3]);
    EXPECT_EQ(glm::length(frame.sensors[0].force_W), lanes->sensor(row, 0).force);
  }
  // The bytes are the sum of the parts of a frame: of each polygon area, centroid, pressure, tet, face, count.
  constexpr std::size_t kPolygon = 5 * sizeof(double) + 3 * sizeof(int);
  std::size_t arrays = 0;
  for (std::uint64_t step = run.history.first(); step <= run.history.last(); ++step) {
    const SimFrame frame = run.recorded(step);
    for (const ContactSurface& surface : frame.sensors[0].surfaces)
      arrays += surface.vertices.size() * (sizeof(dvec3) + sizeof(double)) + surface.polygons.size() * kPolygon;
  }
  EXPECT_GT(run.history.bytes(), arrays);
  EXPECT_LT(run.history.bytes(), 2 * arrays + 6000000);
  // And a limit of bytes.
  const std::size_t half = run.history.bytes() / 2;
  run.history.set_limits({300, half});
  EXPECT_LT(run.history.size(), 200u);
  EXPECT_GT(run.history.size(), 50u);
  for (int i = 0; i < 50; ++i) run.step();
  EXPECT_LE(run.history.bytes(), half + 100000) << "the rows of the timeline are few in comparison";
  EXPECT_EQ(run.history.last(), 1700u);
  run.history.set_limits({0, 0});
  EXPECT_EQ(run.history.size(), 1u) << "never none";
}

TEST_F(History, AllocatesNothingInSteadyStateIfFull) {
  RecordedSimulation run = sweep(1500);
  run.history.set_limits({20, std::size_t{1} << 30});
  for (int i = 0; i < 60; ++i) run.step();
  const StepView view = run.simulator->view();
  StepView next = view;
  const long before = allocation_count();
  for (int i = 0; i < 20; ++i) {
    run.state.step = ++next.step;
    run.history.record(next, run.state);
  }
  // Memory for a deque's block, rows that grow, or a step larger than the one whose memory is reused: occasionally, not
  // in every step.
  EXPECT_LT(allocation_count() - before, 40);
}

TEST_F(History, RecordsEventsAndJumpsInItsRows) {
  RecordedSimulation run = sweep(700);
  while (run.history.empty() || run.history.last() < 3000) {
    if (run.simulator->finished()) break;
    run.step();
  }
  const auto lanes = run.history.lanes();
  int begins = 0;
  for (std::size_t row = 1; row < lanes->rows(); ++row) {
    const SensorSummary &now = lanes->sensor(row, 0), &before = lanes->sensor(row - 1, 0);
    EXPECT_EQ(lanes->steps[row].has(StepEvent::contact_begins), now.polygons > 0 && before.polygons == 0);
    EXPECT_EQ(lanes->steps[row].has(StepEvent::contact_ends), now.polygons == 0 && before.polygons > 0);
    begins += lanes->steps[row].has(StepEvent::contact_begins) ? 1 : 0;
    double largest = 0;
    for (std::size_t k = 0; k < lanes->reading_count; ++k)
      largest = std::max(largest, std::abs(lanes->readings_of(row)[k] - lanes->readings_of(row - 1)[k]));
    EXPECT_EQ(now.largest_jump, largest) << "of all taxels, whichever the breakpoints name";
    EXPECT_EQ(now.jumped_taxel >= 0, largest > 0);
    EXPECT_EQ(now.smallest_polygon > 0, now.polygons > 0);
    EXPECT_LE(now.smallest_polygon * now.polygons, now.area * (1 + 1e-12));
  }
  EXPECT_GE(begins, 1);
}

TEST_F(History, MarksJumpsByTheLargestReadingOfTheRunAsExplanationsDo) {
  RecordedSimulation run = sweep(700);
  run.history.set_breakpoints({.jump = 0.02});
  while (run.history.empty() || run.history.last() < 3000) {
    if (run.simulator->finished()) break;
    run.step();
  }
  const auto lanes = run.history.lanes();
  int marked = 0, of_a_small_reading = 0;
  std::vector<double> so_far(lanes->reading_count, 0.0);
  std::vector<int> touched(lanes->reading_count, 0);
  for (std::size_t row = 1; row < lanes->rows(); ++row) {
    const std::span<const double> before = lanes->readings_of(row - 1), after = lanes->readings_of(row);
    bool jumps = false, jumps_so_far = false;
    for (std::size_t k = 0; k < after.size(); ++k) {
      so_far[k] = std::max(so_far[k], std::abs(after[k]));
      touched[k] += after[k] != 0 ? 1 : 0;
      const double change = std::abs(after[k] - before[k]);
      const bool counts = touched[k] * 0.02 >= 3;
      jumps = jumps || (counts && change > 0.02 * largest_reading(*lanes, k));
      jumps_so_far = jumps_so_far || (counts && change > 0.02 * so_far[k]);
    }
    const StepMark& mark = lanes->steps[row];
    EXPECT_EQ(mark.has(StepEvent::jump) || mark.has(StepEvent::jump_at_equal_force), jumps) << "step " << mark.step;
    EXPECT_EQ(lanes->sensor(row, 0).is_jump, jumps) << "step " << mark.step;
    marked += jumps ? 1 : 0;
    of_a_small_reading += jumps_so_far && !jumps ? 1 : 0;
  }
  EXPECT_GT(marked, 0);
  EXPECT_GT(of_a_small_reading, 0) << "the case that the largest reading decides";
}

}  // namespace
}  // namespace taxel
