// Frames that reuse the memory of earlier frames equal new frames, and need no more memory.
#include "core/sim/host/sim_loop.h"

#include <gtest/gtest.h>

#include <cstring>
#include <optional>

#include "fixtures/box_sweep.h"
#include "fixtures/counted_new.h"
#include "fixtures/fill_frame.h"
#include "fixtures/same_step.h"
#include "fixtures/sweep_model.h"

namespace taxel {
namespace {

constexpr int kTouchingFrom = 1100;  // steps of the sweep

class FrameMemoryTest : public testing::Test {
 protected:
  static void SetUpTestSuite() { model_ = test::fingertip_model(1e5); }
  static void TearDownTestSuite() { model_.reset(); }
  static std::unique_ptr<Simulator> sweep(int steps) {
    auto simulator = Simulator::make_scenario(model_, test::box_sweep());
    for (int i = 0; i < steps; ++i) simulator->step();
    return simulator;
  }
  static void expect_as_anew(const SimFrame& frame, const Simulator& simulator) {
    SimFrame anew;
    test::fill_frame(simulator, anew);
    test::expect_same_step(frame, anew);
    EXPECT_EQ(frame.scene, anew.scene);
    EXPECT_EQ(frame.recorded, anew.recorded);
    EXPECT_EQ(frame.trace, nullptr) << "only memory is kept";
  }
  static SensorModelPtr model_;
};
SensorModelPtr FrameMemoryTest::model_;

TEST_F(FrameMemoryTest, MakesFramesThatEqualNewOnes) {
  const auto simulator = sweep(kTouchingFrom);
  StepHistory history;
  SimState state;
  FrameMemory memory;
  std::shared_ptr<SimFrame> shown, waiting;
  Layout denser = model_->layout;
  denser.sampling.density *= 1.3;
  const SensorModelPtr other = build_sensor_model(denser, model_->mesh, denser.mesh.sha256, "denser");
  for (int i = 0; i < 120; ++i) {
    for (int k = 0; k < 7; ++k) simulator->step();
    if (i == 60) simulator->replace_model(model_, other);
    if (i == 100) simulator->reset();  // without contact
    shown = std::exchange(waiting, memory.frame_of(*simulator));
    expect_as_anew(*waiting, *simulator);
    waiting->trace = std::make_shared<const Trace>();
    waiting->recorded = true;
    if (i % 10 != 3) continue;
    simulator->save_state(state);
    history.clear();
    history.record(simulator->view(), state);
    shown = std::exchange(waiting, memory.recorded_frame(history, state.step));
    expect_as_anew(*waiting, *simulator);
  }
}

TEST_F(FrameMemoryTest, MakesFramesThatOutliveTheMemory) {
  const auto simulator = sweep(kTouchingFrom);
  std::optional<FrameMemory> memory(std::in_place);
  const std::shared_ptr<SimFrame> frame = memory->frame_of(*simulator);
  memory.reset();
  expect_as_anew(*frame, *simulator);
}

TEST_F(FrameMemoryTest, AllocatesNothingInSteadyState) {
  const auto simulator = sweep(kTouchingFrom);
  StepHistory history;
  SimState state;
  history.set_limits({50, std::size_t{1} << 30});
  FrameMemory memory;
  std::shared_ptr<SimFrame> shown, waiting;
  std::shared_ptr<const HistoryLanes> lanes, lanes_waiting;
  long last = 0;
  for (int i = 0; i < 80; ++i) {  // always the same step, so that its arrays have the same sizes
    simulator->save_state(state);
    StepView view = simulator->view();
    view.step = state.step = static_cast<std::uint64_t>(i);
    history.record(view, state);
    const long before = allocation_count();
    shown = std::exchange(waiting, memory.frame_of(*simulator));
    lanes = std::exchange(lanes_waiting, memory.lanes_of(history));
    last = allocation_count() - before;
  }
  EXPECT_LT(last, 40) << "the frame itself, and its parts outside of the arrays";
  EXPECT_EQ(lanes_waiting->rows(), 50U);
}

bool same_marks(const Column<StepMark>& a, const Column<StepMark>& b) {  // their bytes differ where no member is
  return std::equal(a.begin(), a.end(), b.begin(), b.end());
}

template <class T>
bool same_bytes(const Column<T>& a, const Column<T>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

StepView of_step(const Simulator& simulator, std::uint64_t step) {
  StepView view = simulator.view();
  view.step = step;
  return view;
}

TEST_F(FrameMemoryTest, CopiesTheWholeTimelineAfterAnyChangeOfRows) {
  const auto simulator = sweep(kTouchingFrom);
  StepHistory history;
  history.set_limits({40, std::size_t{1} << 30});
  FrameMemory memory;
  SimState state;
  std::shared_ptr<const HistoryLanes> shown, waiting;
  for (int i = 0; i < 300; ++i) {
    simulator->step();
    simulator->save_state(state);
    StepView view = simulator->view();
    if (!history.empty()) view.step = state.step = history.last() + (i == 150 ? 2 : 1);  // 2: begins a separate history
    history.record(view, state);
    if (i % 31 == 30) history.cut_after(history.last() - 4);
    if (i % 47 == 46) simulator->step(), history.replace_newest(of_step(*simulator, history.last()));
    if (i == 200) history.set_limits({10, std::size_t{1} << 30});
    if (i % 3 != 0) continue;
    shown = std::exchange(waiting, memory.lanes_of(history));
    const auto anew = history.lanes();
    EXPECT_EQ(waiting->rows(), history.size()) << i;
    EXPECT_EQ(waiting->steps.back().step, history.last()) << i;
    EXPECT_TRUE(same_marks(waiting->steps, anew->steps) && same_bytes(waiting->sensors, anew->sensors) &&
                same_bytes(waiting->readings, anew->readings))
        << i;
  }
}

bool same_rows(const std::vector<TraceRow>& a, const std::vector<TraceRow>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const TraceRow& x, const TraceRow& y) {
    return x.time == y.time && x.readings == y.readings && x.quality == y.quality;
  });
}

TEST_F(FrameMemoryTest, CopiesAllRowsAfterSomeWereRemoved) {
  FrameMemory memory;
  Trace trace;
  std::vector<TraceRow>& rows = trace.rows;
  std::shared_ptr<const Trace> shown, waiting;
  for (int i = 0; i < 200; ++i) {
    for (int k = 0; k < i % 3; ++k) rows.push_back({0.1 * i + k, 0, {1.0 * i, 2.0 * k}, SampleQuality::polished});
    if (i % 17 == 0 && rows.size() > 5) {  // a run that resumes from an earlier step replaces the last rows
      rows.resize(rows.size() - 5);
      ++trace.edition;
      for (int k = 0; k < 6; ++k) rows.push_back({-1.0 * i, 0, {0, 0}, SampleQuality::preview});
    }
    shown = std::exchange(waiting, memory.copy_of(trace));
    EXPECT_TRUE(same_rows(waiting->rows, rows)) << i;
    EXPECT_EQ(waiting->edition, trace.edition);
    if (shown != nullptr && i % 5 == 0) shown.reset();
  }
}

}  // namespace
}  // namespace taxel
