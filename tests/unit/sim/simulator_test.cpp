// The sweep as a user runs it, and its files.
#include "core/sim/simulator.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/hydro/intersect.h"
#include "core/run/recording/run_recorder.h"
#include "core/sim/plugin/plugin_table.h"
#include "core/sim/scene/scenario_scene.h"
#include "fixtures/box_sweep.h"
#include "fixtures/fill_frame.h"
#include "fixtures/sensor_scene.h"
#include "fixtures/sweep_model.h"

namespace taxel {
namespace {

bool operator==(const RecordedRow& a, const RecordedRow& b) {
  const auto same = [](const SensorRecord& x, const SensorRecord& y) {
    return x.readings == y.readings && x.area == y.area && x.force_W == y.force_W && x.polygons == y.polygons &&
           x.X_WM.p == y.X_WM.p && x.X_WM.q == y.X_WM.q;
  };
  return a.time == b.time && a.travel == b.travel &&
         std::equal(a.sensors.begin(), a.sensors.end(), b.sensors.begin(), b.sensors.end(), same);
}

/// A complete sweep that the tests share.
class Sweep : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    simulator_ = Simulator::make_scenario(test::fingertip_model(1e6), test::box_sweep());
    while (!simulator_->finished()) {
      simulator_->step();
      ++steps_;
      if (simulator_->row_due()) rows_.push_back(row_of(simulator_->view()));
    }
  }
  static void TearDownTestSuite() {
    simulator_.reset();
    rows_.clear();
  }
  static double peak(std::size_t taxel) {
    double largest = 0;
    for (const RecordedRow& row : rows_) largest = std::max(largest, row.sensors[0].readings[taxel]);
    return largest;
  }
  static std::unique_ptr<Simulator> simulator_;
  static std::vector<RecordedRow> rows_;
  static int steps_;
};
std::unique_ptr<Simulator> Sweep::simulator_;
std::vector<RecordedRow> Sweep::rows_;
int Sweep::steps_ = 0;

TEST_F(Sweep, HasARowForEveryTenthOfAMillimetre) {
  EXPECT_EQ(steps_, 2401);
  ASSERT_EQ(rows_.size(), 241u);
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    EXPECT_NEAR(rows_[i].travel, 1e-4 * static_cast<double>(i), 1e-15);
    EXPECT_NEAR(rows_[i].time, 0.01 * static_cast<double>(i), 1e-9);
  }
  EXPECT_EQ(rows_[0].travel, 0);
  EXPECT_EQ(rows_[0].sensors[0].force_W, dvec3(0));
}

TEST_F(Sweep, RespondsOnlyAtPadMiddleAndTipOfBothSides) {
  double largest = 0;
  for (std::size_t k = 0; k < 12; ++k) largest = std::max(largest, peak(k));
  for (std::size_t k = 0; k < 12; ++k)
    EXPECT_EQ(peak(k) > 0.05 * largest, k == 3 || k == 4 || k == 9 || k == 10) << "taxel " << k;
  for (const auto& [pad, tip] : {std::pair(3u, 4u), std::pair(9u, 10u)}) {
    EXPECT_GT(peak(tip), 2 * peak(pad));
    EXPECT_LT(peak(tip), 7 * peak(pad));
  }
}

TEST_F(Sweep, MovesTheFingerWithTheMocapBody) {
  const Pose first = rows_.front().sensors[0].X_WM, last = rows_.back().sensors[0].X_WM;
  EXPECT_NEAR(last.p.x - first.p.x, 0.024, 1e-4);
  for (const RecordedRow& row : rows_) EXPECT_NEAR(row.sensors[0].X_WM.p.z, first.p.z, 1e-4);
  EXPECT_NEAR(simulator_->mocap_pose().p.x - first.p.x, 0.024, 1e-12);
  EXPECT_GT(rows_.back().sensors[0].force_W.z, 0.1);
  // Sliding on the top: friction near mu = 0.5 against the motion.
  EXPECT_NEAR(rows_.back().sensors[0].force_W.x, -0.5 * rows_.back().sensors[0].force_W.z,
              0.02 * rows_.back().sensors[0].force_W.z);
}

TEST(MocapBody, HasThePoseOfTheMotionInEachStep) {
  const SensorModelPtr model = test::fingertip_model(1e5);
  for (const ScenarioKind kind : {kKind<scenarios::Roll>, kKind<scenarios::Twist>, kKind<scenarios::Slide>}) {
    Scenario scenario = default_scenario(kind);
    const Motion motion = build_scenario_scene(*model, scenario).motion;
    const auto simulator = Simulator::make_scenario(model, scenario);
    SimState state;
    double turned = 0;
    for (std::uint64_t step = 0; step <= 300; ++step) {
      const Pose expected = motion.pose(step);
      simulator->step();
      simulator->save_state(state);
      const Pose X = simulator->controls_of(state).mocaps.at(0);
      ASSERT_EQ(X.p, expected.p) << "step " << step;
      ASSERT_EQ(X.q, expected.q) << "step " << step;
      EXPECT_EQ(simulator->mocap_pose().p, expected.p);
      EXPECT_EQ(simulator->mocap_pose().q, expected.q);
      turned = std::max(turned, glm::length(X.q - motion.X_start.q));
    }
    EXPECT_NE(motion.pose(0).q, dquat(1, 0, 0, 0));
    if (kind == kKind<scenarios::Slide>) continue;
    EXPECT_GT(turned, 0.01) << to_word(kind);
  }
}

TEST_F(Sweep, RepeatsBitForBitAfterAReset) {
  simulator_->reset();
  EXPECT_FALSE(simulator_->finished());
  for (std::size_t i = 0; i < 130;) {
    simulator_->step();
    if (simulator_->row_due()) {
      ASSERT_TRUE(row_of(simulator_->view()) == rows_[i]) << "row " << i;
      ++i;
    }
  }
}

TEST_F(Sweep, RepeatsBitForBitInAnotherSimulator) {
  const auto other = Simulator::make_scenario(test::fingertip_model(1e6), test::box_sweep());
  for (std::size_t i = 0; i < 130;) {
    other->step();
    if (other->row_due()) {
      ASSERT_TRUE(row_of(other->view()) == rows_[i]) << "row " << i;
      ++i;
    }
  }
}

TEST_F(Sweep, RepeatsBitForBitInPlainMujocoFromItsFolder) {
  test::SensorScene plain;
  export_scene(*simulator_, plain.folder / "sweep");
  const std::filesystem::path moved = plain.folder / "moved";  // the folder runs elsewhere
  std::filesystem::rename(plain.folder / "sweep", moved);
  char reason[1000] = "";
  plain.model.reset(mj_loadXML((moved / "scene.xml").c_str(), nullptr, reason, sizeof reason));
  ASSERT_NE(plain.model, nullptr) << reason;
  plain.data.reset(mj_makeData(plain.model.get()));
  EXPECT_TRUE(plain.sensor().warnings().empty());
  simulator_->reset();
  double largest = 0;
  for (int n = 0; n < 1300; ++n) {
    simulator_->step();
    for (int i = 0; i < 3; ++i) plain.data->mocap_pos[i] = simulator_->mocap_pose().p[i];
    const dquat q = simulator_->mocap_pose().q;
    const std::array<double, 4> quat{q.w, q.x, q.y, q.z};
    std::copy(quat.begin(), quat.end(), plain.data->mocap_quat);
    plain.step();
    const std::vector<double> readings = row_of(simulator_->view()).sensors[0].readings;
    for (std::size_t k = 0; k < readings.size(); ++k) {
      ASSERT_EQ(plain.data->sensordata[k], readings[k]) << "step " << n << " taxel " << k;
      largest = std::max(largest, readings[k]);
    }
  }
  EXPECT_GT(largest, 1000);
}

TEST_F(Sweep, GivesTheSurfaceOfARowAtItsPoses) {
  // As in `taxel read`: the contact at the recorded pose, recomputed.
  const SensorModelPtr& model = simulator_->scene()->sensors[0];
  const HydroBodyPtr box = make_body({ShapeType::box, dvec3(0.025), nullptr, 0}, {}, "box");
  ContactSurface surface;
  IntersectWorkspace workspace;
  SensorReading reading;
  for (const std::size_t i : {0u, 90u, 130u, 240u}) {
    intersect(*model->body, *box, rows_[i].sensors[0].X_WM, Pose{{1, 0, 0, 0}, dvec3(0.025, 0, 0.025)}, surface,
              workspace);
    const ContactSurface* surfaces[] = {&surface};
    read_sensor(*model, surfaces, reading);
    EXPECT_EQ(reading.values, rows_[i].sensors[0].readings) << "row " << i;
    EXPECT_EQ(surface.area(), rows_[i].sensors[0].area);
  }
}

TEST_F(Sweep, ContainsTheWholeStepInItsFrame) {
  simulator_->reset();
  SimFrame before;
  test::fill_frame(*simulator_, before);
  EXPECT_EQ(before.step, 0u);
  ASSERT_EQ(before.geom_poses.size(), before.scene->geoms.size());
  EXPECT_NEAR(before.sensors[0].X_WM.p.x, rows_[0].sensors[0].X_WM.p.x, 1e-12);  // present before the first step
  for (int n = 0; n < 1200; ++n) simulator_->step();
  SimFrame frame;
  test::fill_frame(*simulator_, frame);
  const RecordedRow row = row_of(simulator_->view());
  EXPECT_EQ(frame.step, 1200u);
  EXPECT_EQ(frame.time, row.time);
  EXPECT_EQ(frame.travel, row.travel);
  EXPECT_EQ(frame.sensors[0].readings, row.sensors[0].readings);
  EXPECT_EQ(frame.sensors[0].hits.size(), frame.scene->sensors[0]->rays.size());
  ASSERT_EQ(frame.sensors[0].surfaces.size(), 1u);
  EXPECT_GT(frame.sensors[0].surfaces[0].polygons.size(), 10u);
  ASSERT_EQ(frame.scene->geoms.size(), 2u);
  EXPECT_EQ(frame.scene->geoms[0].name, kObjectGeom);
  EXPECT_EQ(frame.scene->geoms[0].sensor, -1);
  EXPECT_EQ(frame.scene->geoms[1].sensor, 0);
  EXPECT_NEAR(frame.scene->duration, 2.4, 1e-12);
  ASSERT_EQ(frame.scene->path_W.size(), 2u);
  EXPECT_NEAR(frame.scene->path_W[1].x, 0.012, 1e-12);
}

TEST(SimulatorPath, EndsOnThePathForOddNumbers) {
  Scenario scenario = test::box_sweep();
  scenario.as<scenarios::Sweep>().before = 0.001;
  scenario.as<scenarios::Sweep>().past = 0.00033;
  scenario.as<scenarios::Sweep>().speed = 0.0071;
  scenario.as<scenarios::Sweep>().record_every = 0.00017;
  const auto simulator = Simulator::make_scenario(test::fingertip_model(1e5), scenario);
  int rows = 0;
  double travel = -1;
  while (!simulator->finished()) {
    simulator->step();
    if (!simulator->row_due()) continue;
    const double now = simulator->view().travel;
    EXPECT_GE(now, 0.00017 * rows - 1e-12);
    EXPECT_LT(now, 0.00017 * rows + 0.0071 * 0.001);
    EXPECT_GT(now, travel);
    travel = now;
    ++rows;
  }
  EXPECT_EQ(rows, 8);  // 0, 0.17, ... 1.19 mm
  EXPECT_DOUBLE_EQ(simulator->view().travel, 0.00133);
}

// Steps that nobody views are not read, and do not change the readings of the others.
TEST(Simulator, ReadsOnlyTheStepsThatAreViewed) {
  const SensorModelPtr model = test::fingertip_model(2e5);
  const auto all = Simulator::make_scenario(model, test::box_sweep());
  const auto few = Simulator::make_scenario(model, test::box_sweep());
  const double before = few->sensor_times().readings;
  double largest = 0;
  for (int step = 1; step <= 1500; ++step) {
    all->step();
    few->step();
    const StepView view = all->view();
    if (step < 1200) {
      ASSERT_EQ(few->sensor_times().readings, before);
    } else if (step % 50 == 0) {
      const StepView late = few->view();
      EXPECT_TRUE(std::equal(view.sensors[0].readings.begin(), view.sensors[0].readings.end(),
                             late.sensors[0].readings.begin(), late.sensors[0].readings.end()));
      for (const double reading : view.sensors[0].readings) largest = std::max(largest, reading);
    }
  }
  EXPECT_GT(largest, 100);
  EXPECT_GT(few->sensor_times().readings, before);
}

}  // namespace
}  // namespace taxel
