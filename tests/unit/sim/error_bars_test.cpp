// Error bars of the readings of a run: of samples against their integral, of integrals against a finer tessellation,
// and as columns of a recording.
#include "core/sim/compare/error_bars.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/mesh/make/primitives.h"
#include "core/mesh/topology/subdivide.h"
#include "core/run/recording/csv.h"
#include "core/run/recording/npz.h"
#include "core/run/recording/run_recorder.h"
#include "core/sensor/error_bars/finer_body.h"
#include "core/sensor/integral/make_skin_fields.h"
#include "core/sensor/readout/reading.h"
#include "core/sim/compare/contact_again.h"
#include "core/sim/simulator.h"
#include "fixtures/box_sweep.h"
#include "fixtures/sweep_model.h"
#include "fixtures/temp_folder.h"

namespace taxel {
namespace {

SensorModelPtr finger(ReadingMethod method) {
  const SensorModelPtr base = test::fingertip_model(2e5);
  Layout layout = base->layout;
  layout.readout.method = method;
  return build_sensor_model(layout, base->loaded, "", "finger");
}

/// A short sweep around a layout, in contact.
struct Slide {
  std::unique_ptr<Simulator> simulator;
  explicit Slide(const SensorModelPtr& model) : simulator(Simulator::make_scenario(model, test::box_sweep())) {
    go_on(1100);
  }
  void go_on(int steps) {
    for (int i = 0; i < steps; ++i) simulator->step();
  }
};

/// Returns the model with a body whose edges are 1/8 as long.
SensorModel much_finer(const SensorModel& model) {
  SensorModel fine(model);
  Shape shape;
  shape.type = ShapeType::mesh;
  shape.mesh = std::make_shared<const TriMesh>(subdivide(*model.mesh, 3, SubdivisionScheme::midpoint));
  fine.body = make_body(shape, model.layout.material, "fine");
  fine.tet_table = nullptr;
  fine.skin_fields = skin_fields_for(fine, IntegralKind::weighted_mean);
  return fine;
}

// The finger's readings against those of a pad with edges 1/8 as long, over a slide.
TEST(TessellationError, ContainsTheErrorAgainstAMuchFinerPad) {
  const SensorModelPtr model = finger(ReadingMethod::exact);
  const SensorModel fine = much_finer(*model);
  Slide run(model);
  const TessellationError errors(run.simulator->scene(), 0);
  int all = 0, within = 0;
  std::vector<double> ratios;
  for (int i = 0; i < 40; ++i) {
    run.go_on(25);
    const StepView view = run.simulator->view();
    std::vector<SensorStep> poses(1);
    poses[0].X_WM = view.sensors[0].X_WM;
    const TouchedPoses bodies = touched_poses(*view.scene, 0, poses, view.geom_poses);
    const std::vector<double> exact = read_own_contact(fine, view.scene->touched[0], view.sensors[0].X_WM, bodies.X_WB);
    const std::vector<double> bars = errors.bars(view);
    const double peak = *std::max_element(exact.begin(), exact.end());
    for (std::size_t k = 0; k < bars.size(); ++k) {
      const double error = std::abs(view.sensors[0].readings[k] - exact[k]);
      if (error < 1e-4 * peak) continue;
      ++all;
      if (error <= bars[k] + 1e-4 * peak) ++within;
      ratios.push_back(bars[k] / error);
    }
  }
  std::sort(ratios.begin(), ratios.end());
  EXPECT_GT(all, 50);
  EXPECT_GE(within, 0.95 * all);
  EXPECT_GT(ratios[ratios.size() / 2], 0.5);
  EXPECT_LT(ratios[ratios.size() / 2], 2.0);
}

TEST(FinerBody, HalvesTheEdgesOfRoundShapesAndSoftMeshes) {
  for (const ShapeType type : {ShapeType::sphere, ShapeType::capsule, ShapeType::cylinder, ShapeType::ellipsoid}) {
    Shape shape;
    shape.type = type;
    shape.size = dvec3(0.01, 0.02, 0.015);
    const Shape finer = finer_shape(shape, Material{});
    EXPECT_NEAR(finer.resolution, 0.001, 1e-15) << static_cast<int>(type);
    EXPECT_NEAR(finer_shape(finer, Material{}).resolution, 0.0005, 1e-15);
  }
  Shape box;
  box.type = ShapeType::box;
  box.size = dvec3(0.01);
  EXPECT_EQ(finer_shape(box, Material{}).resolution, 0);
  Shape mesh;
  mesh.type = ShapeType::mesh;
  mesh.mesh = std::make_shared<const TriMesh>(make_icosphere(0.01, 1));
  EXPECT_EQ(finer_shape(mesh, Material{}).mesh, mesh.mesh) << "a rigid mesh is exact";
  Material soft;
  soft.modulus = 1e5;
  EXPECT_EQ(finer_shape(mesh, soft).mesh->face_count(), 4 * mesh.mesh->face_count());
  EXPECT_NEAR(finer_shape(mesh, soft).mesh->volume(), mesh.mesh->volume(), 1e-13 * mesh.mesh->volume());
}

TEST(FinerBody, ExtrapolatesWithTheSquareOfTheEdges) {
  const double limit = 7, c = 0.3;
  const std::vector<double> coarse{limit + c, limit - c}, fine{limit + c / 4, limit - c / 4};
  for (const double bar : richardson_bars(coarse, fine)) EXPECT_NEAR(bar, c, 1e-12);
}

/// Records rows of a run with error bars, and expects the bars of ErrorBars in CSV and NPZ, and after reading the NPZ.
void expect_recorded_bars(const SensorModelPtr& model) {
  Slide run(model);
  const auto scene = run.simulator->scene();
  auto bars = std::make_shared<ErrorBars>(scene);
  EXPECT_EQ(bars->missing(0), "");
  RunRecorder recorder(*scene, bars);
  std::vector<std::vector<double>> expected;
  for (int i = 0; i < 3; ++i) {
    run.go_on(100);
    recorder.follow(run.simulator->view(), {}, true);
    expected.push_back(bars->measure(run.simulator->view(), 0));
    EXPECT_GT(*std::max_element(expected.back().begin(), expected.back().end()), 0);
  }
  const Recording& recording = recorder.recording();
  const test::TempFolder folder;
  write_file_atomically(folder.path() / "bars.npz", recording_to_npz(recording));
  const Recording read = read_recording(folder.path() / "bars.npz");
  ASSERT_TRUE(read.sensors[0].errors);
  for (std::size_t r = 0; r < expected.size(); ++r) {
    EXPECT_EQ(recording.rows[r].sensors[0].errors, expected[r]);
    EXPECT_EQ(read.rows[r].sensors[0].errors, expected[r]);
  }
  const std::string csv = recording_to_csv(recording);
  EXPECT_NE(csv.find(",taxel_11,taxel_0_error,taxel_1_error,"), std::string::npos) << csv.substr(0, 400);
  EXPECT_EQ(std::count(csv.begin(), csv.begin() + static_cast<std::ptrdiff_t>(csv.find('\n')), ','), 6 + 24);
}

TEST(ErrorBars, AreRecordedForSamplesAndForExactReadings) {
  expect_recorded_bars(finger(ReadingMethod::samples));
  expect_recorded_bars(finger(ReadingMethod::exact));
}

TEST(ErrorBars, SayWhyASensorHasNone) {
  const SensorModelPtr base = test::fingertip_model(2e5);
  Layout layout = base->layout;
  layout.readout.ray = RayDirection::taxel_normal;
  Slide run(build_sensor_model(layout, base->loaded, "", "finger"));
  ErrorBars bars(run.simulator->scene());
  EXPECT_NE(bars.missing(0).find("surface_normal"), std::string::npos);
  EXPECT_THROW(bars.measure(run.simulator->view(), 0), Error);
  RunRecorder recorder(*run.simulator->scene(), std::make_shared<ErrorBars>(run.simulator->scene()));
  recorder.follow(run.simulator->view(), {}, true);
  EXPECT_FALSE(recorder.recording().sensors[0].errors);
  EXPECT_TRUE(recorder.recording().rows[0].sensors[0].errors.empty());
}

}  // namespace
}  // namespace taxel
