// The values that a device reports, in sensordata: the plugin's chain follows MuJoCo's steps, copies and states.
#include <gtest/gtest.h>

#include "core/sensor/calibration.h"
#include "fixtures/sensor_scene.h"

namespace taxel {
namespace {

using test::key;
using test::sensor_extension;
using test::SensorScene;

/// Returns a calibration with every stage that has a state or random numbers.
Calibration slow_device() {
  Calibration c;
  c.response = {{1, 1e-6}, 1e5, {}};
  c.relaxation = {{0.1, 0.01}, {0.2, 0.05}};
  c.hysteresis = {50, 0.3, {{200, 0.2}}};
  c.low_pass = {0.002, {}};
  c.noise = 3;
  c.rate = 400;
  c.latency = 0.003;
  return c;
}

/// A soft ball on the floor, pressed by a mocap body through a weld. The output is the reading and the reported value.
class ReportedValuesTest : public testing::Test {
 protected:
  void compile(const std::optional<Calibration>& calibration, const std::string& output) {
    s.add_sensor("ball", make_sphere(0.02, 0.008), {FieldKind::star, 5e4, 0, 5, 0.5});
    layout = read_layout(s.folder / "ball.taxels.json");
    layout.calibration = calibration;
    write_layout(s.folder / "ball.taxels.json", layout);
    s.compile("<mujoco><option timestep='0.001'/>" +
              sensor_extension("ball", key("others", "floor") + key("output", output)) +
              R"(<asset><mesh name='ball' file='ball.obj'/></asset><worldbody>
      <geom name='floor' type='plane' size='1 1 1' contype='0' conaffinity='0'/>
      <body name='hand' mocap='true' pos='0 0 0.0185'/>
      <body name='ball' pos='0 0 0.0185'><freejoint/><geom name='ball' type='mesh' mesh='ball' contype='0' conaffinity='0'/></body>
      </worldbody><equality><weld body1='hand' body2='ball' solref='0.02 1'/></equality></mujoco>)");
  }
  void SetUp() override {
    compile(slow_device(), "readings calibrated");
    ASSERT_NE(s.model, nullptr) << s.error;
  }
  /// Presses deeper and less deep, and returns reading and reported value of each step.
  std::vector<double> run(mjData& d, int from, int count) {
    std::vector<double> out;
    for (int n = from; n < from + count; ++n) {
      d.mocap_pos[2] = 0.0185 - 1e-5 * (n % 40);
      mj_step(s.model.get(), &d);
      out.insert(out.end(), d.sensordata, d.sensordata + s.model->nsensordata);
    }
    return out;
  }
  /// Returns the readings of a run with the values that the chain makes of them.
  std::vector<double> through_chain(const std::vector<double>& run) const {
    Calibrator calibrator(layout, 0.001);
    std::vector<double> out;
    double time = 0;
    for (std::size_t i = 0; i < run.size(); i += 2, time += 0.001) {
      out.push_back(run[i]);
      out.push_back(calibrator.advance(time, {&run[i], 1})[0]);
    }
    return out;
  }
  SensorScene s;
  Layout layout;
};

TEST_F(ReportedValuesTest, AreThoseOfTheChainForTheReadings) {
  const std::vector<double> out = run(*s.data, 0, 80);
  EXPECT_EQ(out, through_chain(out));
  EXPECT_GT(out[2 * 60], 1000);
  EXPECT_NE(out[2 * 60], out[2 * 60 + 1]);
}

TEST_F(ReportedValuesTest, BeginAgainAfterAReset) {
  const std::vector<double> first = run(*s.data, 0, 40);
  mj_resetData(s.model.get(), s.data.get());
  EXPECT_EQ(run(*s.data, 0, 40), first);
  s.data->time = 0;  // the program sets the clock back by itself
  const std::vector<double> later = run(*s.data, 40, 40);
  EXPECT_EQ(later, through_chain(later));
}

TEST_F(ReportedValuesTest, ContinueInACopy) {
  run(*s.data, 0, 30);
  DataHandle copy(mj_copyData(nullptr, s.model.get(), s.data.get()));
  const std::vector<double> original = run(*s.data, 30, 30);
  EXPECT_EQ(run(*copy, 30, 30), original);
}

TEST_F(ReportedValuesTest, RepeatFromEachRestoredState) {
  const auto size = static_cast<std::size_t>(mj_stateSize(s.model.get(), mjSTATE_INTEGRATION));
  std::vector<std::vector<mjtNum>> states(60, std::vector<mjtNum>(size));
  std::vector<double> original;
  for (int n = 0; n < 60; ++n) {
    mj_getState(s.model.get(), s.data.get(), states[static_cast<std::size_t>(n)].data(), mjSTATE_INTEGRATION);
    const std::vector<double> row = run(*s.data, n, 1);
    original.insert(original.end(), row.begin(), row.end());
  }
  DataHandle other(mj_makeData(s.model.get()));
  for (int i = 0; i < 60; ++i) {
    const int n = i * 17 % 60, count = std::min(6, 60 - n);
    mj_setState(s.model.get(), other.get(), states[static_cast<std::size_t>(n)].data(), mjSTATE_INTEGRATION);
    EXPECT_EQ(run(*other, n, count), std::vector<double>(original.begin() + 2 * n, original.begin() + 2 * (n + count)))
        << n;
  }
}

TEST_F(ReportedValuesTest, DoNotAdvanceByForward) {
  std::vector<double> out;
  for (int n = 0; n < 40; ++n) {
    mj_forward(s.model.get(), s.data.get());
    mj_forward(s.model.get(), s.data.get());
    const std::vector<double> row = run(*s.data, n, 1);
    out.insert(out.end(), row.begin(), row.end());
  }
  EXPECT_EQ(out, through_chain(out));
}

TEST_F(ReportedValuesTest, LeaveTheReadingsUnchanged) {
  const std::vector<double> both = run(*s.data, 0, 40);
  const int with = static_cast<int>(s.model->npluginstate);
  compile(slow_device(), "readings");
  ASSERT_NE(s.model, nullptr) << s.error;
  const std::vector<double> alone = run(*s.data, 0, 40);
  for (std::size_t i = 0; i < alone.size(); ++i) EXPECT_EQ(alone[i], both[2 * i]);
  EXPECT_EQ(with - static_cast<int>(s.model->npluginstate), static_cast<int>(Chain(layout, 0.001).state_size()));
}

TEST_F(ReportedValuesTest, BeginAgainWithAnotherCalibrationOnly) {
  const auto load = [&](const Calibration& calibration) {
    Layout changed = layout;
    changed.calibration = calibration;
    write_layout(s.folder / "ball.taxels.json", changed);
    return load_sensor_model(s.folder / "ball.taxels.json");
  };
  const std::vector<double> whole = run(*s.data, 0, 60);
  mj_resetData(s.model.get(), s.data.get());
  run(*s.data, 0, 30);
  s.sensor().hand_over(*s.model, load(slow_device()));
  EXPECT_EQ(run(*s.data, 30, 30), std::vector<double>(whole.begin() + 60, whole.end()));
  Calibration other = slow_device();
  other.noise = 0;
  s.sensor().hand_over(*s.model, load(other));
  layout.calibration = other;
  const std::vector<double> values = run(*s.data, 60, 30), expected = through_chain(values);
  for (std::size_t i = 0; i < values.size(); ++i) EXPECT_NEAR(values[i], expected[i], 1e-9 * (1 + expected[i])) << i;
  other.latency = 0.05;  // needs more state than the model has
  EXPECT_THROW(s.sensor().hand_over(*s.model, load(other)), Error);
}

TEST_F(ReportedValuesTest, NeedACalibration) {
  compile(std::nullopt, "calibrated");
  EXPECT_EQ(s.model, nullptr);
  EXPECT_NE(s.error.find("\"calibrated\" needs a calibration"), std::string::npos) << s.error;
  EXPECT_NE(s.error.find("output"), std::string::npos) << s.error;
}

}  // namespace
}  // namespace taxel
