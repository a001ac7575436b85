// Fits of simulated recordings whose parameters are known: presses and their baselines, recovered values, and
// recordings that decide nothing.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <random>

#include "core/base/error.h"
#include "core/run/fit/agreement.h"
#include "core/run/fit/fit.h"
#include "core/run/fit/fit_files.h"
#include "core/run/fit/fit_model.h"
#include "core/run/fit/least_squares.h"
#include "core/run/fit/pressed_recording.h"
#include "core/sensor/contact_case/pose_readings.h"
#include "fixtures/strip.h"

namespace taxel {
namespace {

constexpr double kTop = 0.006;    // height of the strip's skin [m]
constexpr double kBall = 0.0037;  // radius of the object [m]
constexpr double kRest = 0.0003;  // height of the object above the skin at rest [m]

/// Presses of a ball on the strip, as a sensor records them.
struct Presses {
  int places = 9;                  ///< 2 mm apart
  int rows = 10;                   ///< rows of the loading part
  double depth = 0.0012;           ///< [m]
  double noise = 0.01;             ///< standard deviation over the largest value
  int bits = 8;                    ///< digits of a value; 0 for all
  dvec3 zero{0.0013, 0, -0.0001};  ///< zero that the fit must find [m]
  std::vector<double> gains{1.5, 0.7, 2.0};
};

ContactCase ball_case(double radius = kBall) {
  ContactCase out;
  out.b.shape = CaseShape{};
  out.b.shape->size = dvec3(radius, 0, 0);
  out.b.X_WB.p = {0, 0, kTop + kBall + kRest};
  return out;
}

FitSubject subject() {
  Readout readout;
  readout.method = ReadingMethod::exact;
  return {test::strip_source({}, readout), ball_case()};
}

/// Returns the displacements of all rows: three at rest, the loading part, and two on the way back.
std::vector<dvec3> displacements(const Presses& presses) {
  std::vector<dvec3> out;
  for (int place = 0; place < presses.places; ++place) {
    const double x = 0.002 * (place - 0.5 * (presses.places - 1));
    for (int i = 0; i < 3; ++i) out.push_back({x, 0, 0});
    for (int i = 1; i <= presses.rows; ++i) out.push_back({x, 0, -(kRest + presses.depth) * i / presses.rows});
    for (const double part : {0.6, 0.2}) out.push_back({x, 0, -part * (kRest + presses.depth)});
  }
  return out;
}

/// Returns the table that the sensor of the fixture writes.
std::string recorded(const Presses& presses, std::uint64_t seed) {
  const FitSubject truth = subject();
  const SensorModelPtr model = build_sensor_model(truth.sensor.layout, truth.sensor.mesh.mesh, "", "strip");
  const MadeBody ball = make_case_body(truth.contact_case, truth.contact_case.b, "b");
  const std::vector<dvec3> at = displacements(presses);
  std::vector<Pose> poses;
  for (const dvec3& displacement : at)
    poses.push_back({dquat(1, 0, 0, 0), truth.contact_case.b.X_WB.p + displacement + presses.zero});
  const PoseReadings readings = read_poses(*model, *ball.body, poses);
  double largest = 0;
  for (std::size_t i = 0; i < readings.readings.size(); ++i)
    largest = std::max(largest, presses.gains[i % 3] * readings.readings[i]);
  std::mt19937_64 random(seed);
  std::normal_distribution<double> noise(0, presses.noise * largest);
  std::string text = "x [mm],z [mm],taxel_0,taxel_1,taxel_2\n";
  for (std::size_t i = 0; i < at.size(); ++i) {
    text += fmt::format("{:.6f},{:.6f}", 1e3 * at[i].x, 1e3 * at[i].z);
    for (std::size_t k = 0; k < 3; ++k) {
      double value = 1000 + presses.gains[k] * readings.readings[3 * i + k] + noise(random);
      const double step = 1.1 * largest / (1 << std::max(presses.bits, 1));
      if (presses.bits > 0) value = step * std::round(value / step);
      text += fmt::format(",{}", value);
    }
    text += '\n';
  }
  return text;
}

PressedOptions table_options() {
  PressedOptions options;
  options.mapping.rate = 100;
  for (int k = 0; k < 3; ++k) options.mapping.taxels.push_back({k, fmt::format("taxel_{}", k), {}, {}});
  return options;
}

PressedRecording presses_of(const Presses& presses, std::uint64_t seed) {
  return parse_pressed_recording(recorded(presses, seed), table_options(), "presses.csv");
}

RecordingFitOptions free_parameters(std::vector<FitName> names) {
  RecordingFitOptions options;
  options.free = std::move(names);
  return options;
}

const FittedParameter& parameter(const RecordingFit& fit, FitName name) {
  return *std::find_if(fit.parameters.begin(), fit.parameters.end(),
                       [&](const FittedParameter& p) { return p.name == name; });
}

std::string press_refusal(const std::string& text, const PressedOptions& options = table_options()) {
  try {
    parse_pressed_recording(text, options, "presses.csv");
  } catch (const Error& e) {
    return e.what();
  }
  return "";
}

bool has_part(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(PressedRecording, CutsPressesAndTakesTheMeanBeforeEachAsItsBaseline) {
  const PressedRecording recording = parse_pressed_recording(
      "x [mm],z [um],taxel_0,taxel_1,taxel_2\n"
      "0,0,10,1,1\n0,0,12,1,1\n0,-500,20,1,1\n0,-1000,30,1,nan\n0,-600,25,1,1\n0,0,11,1,1\n"
      "2,0,13,1,1\n2,-400,21,1,1\n2,-900,31,1,1\n2,0,15,1,1\n",
      table_options(), "presses.csv");
  ASSERT_EQ(recording.presses.size(), 2U);
  EXPECT_EQ(recording.presses[0].first, 2U);
  EXPECT_EQ(recording.presses[0].end, 4U) << "the way back is no loading";
  EXPECT_DOUBLE_EQ(recording.presses[0].baseline[0], 11);
  EXPECT_DOUBLE_EQ(recording.presses[1].baseline[0], 12);
  EXPECT_EQ(recording.displacements[3], dvec3(0, 0, -0.001));
  EXPECT_EQ(recording.displacements[8], dvec3(0.002, 0, -0.0009));
  EXPECT_TRUE(std::isnan(recording.values[2][3]));
  EXPECT_EQ(recording.lateral_axis, 0);
  EXPECT_DOUBLE_EQ(measured_at(recording, {1, 8}, 0), 19);
}

TEST(PressedRecording, RefusesATableWithItsLineAndColumn) {
  const std::string head = "x [mm],z [mm],taxel_0,taxel_1,taxel_2\n";
  EXPECT_TRUE(
      has_part(press_refusal("x,z [mm],taxel_0,taxel_1,taxel_2\n0,0,1,1,1\n0,1,1,1,1\n"), "column \"x\": has no unit"));
  EXPECT_TRUE(has_part(press_refusal("x [N],z [mm],taxel_0,taxel_1,taxel_2\n0,0,1,1,1\n"), "unit must be a length"));
  EXPECT_TRUE(has_part(press_refusal(head + "0,0,1,1,1\n0,0,2,1,1\n"), "holds no press: the position along z is 0 m"));
  EXPECT_TRUE(has_part(press_refusal(head + "0,0,1,1,1\n0,nan,2,1,1\n"), "line 3, column \"z [mm]\""));
  EXPECT_TRUE(has_part(press_refusal(head + "0,0,1,1,1\n0,1e99,2,1,1\n"), "line 3, column \"z [mm]\""));
  EXPECT_TRUE(has_part(press_refusal(head + "0,0,1,1,1\n0,1,2,1\n"), "line 3"));
  EXPECT_TRUE(has_part(press_refusal("x [mm],taxel_0,taxel_1,taxel_2\n0,1,1,1\n"), "has no column \"z\""));
  EXPECT_TRUE(has_part(press_refusal("a\n1\n2\n"), "has no column \"z\"")) << press_refusal("a\n1\n2\n");
  EXPECT_TRUE(has_part(press_refusal(head + std::string(kMostPressedRows + 1, '\n')), "leave rows out"));
  PressedOptions no_taxels = table_options();
  no_taxels.mapping.taxels.clear();
  EXPECT_TRUE(has_part(press_refusal(head + "0,0,1,1,1\n", no_taxels), "has no column for a taxel"));
}

TEST(PressedRecording, ReadsUnitsOfColumnsFromAnOption) {
  const std::vector<PoseColumn> columns = parse_pose_columns("x=0.001 mm, z=depth*-(1/480) mm");
  ASSERT_EQ(columns.size(), 2U);
  EXPECT_EQ(columns[0].column, "x");
  EXPECT_DOUBLE_EQ(columns[0].unit, 1e-6);
  EXPECT_EQ(columns[1].column, "depth");
  EXPECT_EQ(columns[1].axis, 2);
  EXPECT_NEAR(columns[1].unit, -1e-3 / 480, 1e-18);
  for (const char* wrong : {"x", "q=1 mm", "x=1", "x=0 mm", "x=1 N", "x=", ""})
    EXPECT_THROW(parse_pose_columns(wrong), Error) << wrong;
}

TEST(LeastSquares, FindsTheMinimumOfRosenbrocksValleyWithinBounds) {
  LeastSquares problem;
  problem.residuals = [](const Eigen::VectorXd& p) { return Eigen::Vector2d(1 - p[0], 10 * (p[1] - p[0] * p[0])); };
  problem.derivatives = [](const Eigen::VectorXd& p) {
    Eigen::Matrix2d J;
    J << -1, 0, -20 * p[0], 10;
    return J;
  };
  problem.lower = Eigen::Vector2d(-2, -2), problem.upper = Eigen::Vector2d(2, 2), problem.scale = Eigen::Vector2d(1, 1);
  const LeastSquaresPoint found = minimise(problem, Eigen::Vector2d(-1.2, 1), 100);
  EXPECT_NEAR(found.p[0], 1, 1e-6);
  EXPECT_NEAR(found.p[1], 1, 1e-6);
  problem.upper[0] = 0.5;
  const LeastSquaresPoint bounded = minimise(problem, Eigen::Vector2d(-1.2, 1), 100);
  EXPECT_NEAR(bounded.p[0], 0.5, 1e-9);
  EXPECT_NEAR(bounded.p[1], 0.25, 1e-4);
}

// A line a + b x at x = 0, 1, 2: var a = 5/6 s^2, var b = s^2/2, correlation -sqrt(3/5).
TEST(LeastSquares, GivesTheStandardErrorsOfALine) {
  Eigen::MatrixXd J(3, 3);
  J << 1, 0, 0, 1, 1, 0, 1, 2, 0;
  const Certainty certainty = certainty_of(J, 4);
  EXPECT_NEAR(certainty.standard_errors[0], 2 * std::sqrt(5.0 / 6), 1e-9);
  EXPECT_NEAR(certainty.standard_errors[1], 2 * std::sqrt(0.5), 1e-9);
  EXPECT_NEAR(certainty.correlations[0][1], -std::sqrt(0.6), 1e-9);
  EXPECT_TRUE(std::isinf(certainty.standard_errors[2])) << "nothing depends on it";
}

TEST(Agreement, MeasuresTheWidthOfABellAtHalfHeight) {
  EXPECT_DOUBLE_EQ(half_width({0, 1, 2, 3, 4}, {0, 1, 4, 1, 0}), 2 + 2.0 / 3 - (1 + 1.0 / 3));
  EXPECT_TRUE(std::isnan(half_width({0, 1, 2}, {4, 3, 1}))) << "its left side is not seen";
}

TEST(RecordingFit, FindsTheZerosTheRadiusAndTheGainsOfARecording) {
  const Presses presses;
  RecordingFitOptions options = free_parameters({FitName::radius, FitName::x0, FitName::z0, FitName::gain});
  options.values = {{FitName::radius, 0.0045}};
  const RecordingFit fit = fit_recordings(subject(), {presses_of(presses, 3)}, {presses_of(presses, 4)}, options);
  const FittedParameter &radius = parameter(fit, FitName::radius), &x0 = parameter(fit, FitName::x0),
                        &z0 = parameter(fit, FitName::z0);
  EXPECT_NEAR(radius.value, 0.006, 3 * radius.standard_error);
  EXPECT_NEAR(x0.value, presses.zero.x, 3 * x0.standard_error);
  EXPECT_NEAR(z0.value, presses.zero.z, 3 * z0.standard_error);
  EXPECT_LT(radius.standard_error, 1e-4);
  ASSERT_EQ(fit.runs.size(), 2U);
  for (const RunAgreement& run : fit.runs) {
    EXPECT_GT(run.r2, 0.99);
    EXPECT_NEAR(run.rms, presses.noise, 0.4 * presses.noise);
    for (std::size_t t = 0; t < 3; ++t) EXPECT_NEAR(run.taxels[t].gain / presses.gains[t], 1, 0.05);
  }
  EXPECT_TRUE(fit.runs[1].is_held_out);
}

TEST(RecordingFit, ReadsItsSubjectAsReadPosesDoesWithTheChangedGeometry) {
  FitModel model(subject(), 1, nullptr);
  const dvec3 displacement(0.001, 0, -0.001);
  FitSubject changed = subject();
  for (Taxel& taxel : changed.sensor.layout.taxels) taxel.radius = 0.004;
  changed.sensor.layout.material.thickness = 0.004;
  changed.sensor.layout.material.law = {LawKind::stiffening, 0.5, {}};
  changed.contact_case.b.shape->size.x = 0.003;
  const SensorModelPtr sensor = build_sensor_model(changed.sensor);
  const MadeBody ball = make_case_body(changed.contact_case, changed.contact_case.b, "b");
  const Pose poses[] = {{dquat(1, 0, 0, 0), changed.contact_case.b.X_WB.p + displacement}};
  EXPECT_EQ(model.read({0.004, 0.003, 0.004, 0.5}, std::array{displacement}).readings,
            read_poses(*sensor, *ball.body, poses).readings);
  EXPECT_EQ(model.geometry(), (FitGeometry{0.006, kBall, test::kStripPad, 0}));
}

TEST(RecordingFit, WritesItsPointsAndDrawsThem) {
  RecordingFit fit;
  const PressedRecording recording = presses_of({}, 1);
  RunAgreement& run = fit.runs.emplace_back();
  run.taxels.resize(3);
  run.largest = 10;
  run.points = {{0, 3, {0.001, 0, -0.002}, 1, 10, 9}, {0, 4, {0.001, 0, -0.003}, 1, 12, 12.5}};
  EXPECT_EQ(points_csv(fit, {recording}),
            "run,press,row,x,y,z,taxel,measured,fitted,residual\n0,0,3,0.001,0,-0.002,1,10,9,1\n"
            "0,0,4,0.001,0,-0.003,1,12,12.5,-0.5\n");
  const Chart bells = bells_chart(fit, {recording}), loading = loading_chart(fit, {recording}, 2);
  EXPECT_EQ(bells.panels.at(0).rings.at(1).points.y, std::vector<double>{12}) << "the end of the press";
  EXPECT_EQ(loading.panels.at(0).curves.at(0).points.x, (std::vector<double>{-2, -3}));
  EXPECT_EQ(residuals_chart(fit, {recording}).panels.at(0).rings.at(1).points.y, (std::vector<double>{10, -5}));
}

TEST(RecordingFit, SaysWhichParametersARecordingDoesNotDecide) {
  Presses presses;
  presses.places = 1;
  const RecordingFit fit = fit_recordings(
      subject(), {presses_of(presses, 3)}, {},
      free_parameters({FitName::radius, FitName::object_radius, FitName::z0, FitName::y0, FitName::gain}));
  ASSERT_FALSE(fit.undecided.empty());
  for (const Undecided& undecided : fit.undecided) EXPECT_FALSE(undecided.advice.empty());
}

TEST(RecordingFit, RefusesSubjectsAndOptionsThatCannotBeFitted) {
  const PressedRecording recording = presses_of({}, 1);
  const auto why = [&](const FitSubject& of, const RecordingFitOptions& options) -> std::string {
    try {
      fit_recordings(of, {recording}, {}, options);
    } catch (const Error& e) {
      return e.what();
    }
    return "";
  };
  EXPECT_TRUE(has_part(why(subject(), free_parameters({FitName::x0, FitName::x0})), "names x0 twice"));
  FitSubject far = subject();
  far.contact_case.b.X_WB.p.y = 1;
  EXPECT_TRUE(has_part(why(far, free_parameters({FitName::z0, FitName::gain})), "touches the layout nowhere"));
  FitSubject other = subject();
  other.sensor.layout.taxels[1].id = 7;
  EXPECT_TRUE(has_part(why(other, free_parameters({FitName::z0})), "strip has no taxel 1"));
}

}  // namespace
}  // namespace taxel
