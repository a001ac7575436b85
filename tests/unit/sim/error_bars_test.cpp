// Error bars of the readings of a run: of samples against their integral, of integrals against a finer tessellation,
// and as columns of a recording.
#include "core/sim/compare/error_bars.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/layout/file/layout_json.h"
#include "core/mesh/make/primitives.h"
#include "core/mesh/topology/remesh.h"
#include "core/run/recording/recording_files.h"
#include "core/run/recording/run_recorder.h"
#include "core/sensor/error_bars.h"
#include "core/sensor/rays/tet_table.h"
#include "core/sensor/readout/reading.h"
#include "core/sensor/sensor_model.h"
#include "core/sim/compare/contact_again.h"
#include "core/sim/simulator.h"
#include "fixtures/box_sweep.h"
#include "fixtures/sensor_scene.h"
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
  fine.ray_tables.tets = nullptr;
  fine.skin_fields = skin_fields_for(fine, IntegralKind::weighted_mean);
  return fine;
}

// The finger's readings against those of a pad with edges 1/8 as long, over a slide.
TEST(FinerTessellation, ContainsTheErrorAgainstAMuchFinerPad) {
  const SensorModelPtr model = finger(ReadingMethod::exact);
  const SensorModel fine = much_finer(*model);
  Slide run(model);
  SensorErrors errors(*run.simulator->scene(), 0);
  int all = 0, within = 0;
  std::vector<double> ratios;
  for (int i = 0; i < 40; ++i) {
    run.go_on(25);
    const StepView view = run.simulator->view();
    const std::vector<double> exact = read_in_place(ReadingModel::finer, fine, view.scene->touched[0], view, 0).values;
    const std::vector<double> bars = errors.read(view).bars;
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

/// A block with a taxel on a soft ball whose edges are long: the error of the ball dominates. The ball is a geom
/// without taxels, or another sensor.
struct BlockOnBall {
  test::SensorScene s;
  std::unique_ptr<Simulator> simulator;
  explicit BlockOnBall(bool is_ball_sensor = false) {
    s.add_sensor("block", make_box({0.03, 0.03, 0.01}), Material{FieldKind::pad, 4e5, 0.005, 5, 0.5});
    Layout layout = read_layout(s.folder / "block.taxels.json");
    layout.readout.method = ReadingMethod::exact;
    layout.taxels[0].radius = 0.004;
    write_layout(s.folder / "block.taxels.json", layout);
    s.add_sensor("ball", make_icosphere(0.02, 2), Material{FieldKind::pad, 1e5, 0.005, 5, 0.5});
    const std::string soft_ball = "<extension><plugin plugin='taxel.contact'><instance name='soft'>" +
                                  test::key("materials", R"({"ball": {"modulus": 1e5, "resolution": 0.005}})") +
                                  "</instance></plugin></extension>";
    write_file_atomically(
        s.folder / "scene.xml",
        "<mujoco><option gravity='0 0 0'/>" + test::sensor_extension("block", test::key("others", "ball")) +
            (is_ball_sensor ? test::sensor_extension("ball", test::key("others", "block")) : soft_ball) +
            R"(<asset><mesh name='block' file='block.obj'/><mesh name='ball' file='ball.obj'/></asset>
      <worldbody><geom name='ball' )" +
            (is_ball_sensor ? "type='mesh' mesh='ball'" : "type='sphere' size='.02'") + R"(/>
      <body pos='0 0 0.028'><freejoint/><geom name='block' type='mesh' mesh='block' mass='1'/></body></worldbody></mujoco>)");
    simulator = Simulator::load(s.folder / "scene.xml");
  }
};

// Both bodies are refined, each by its own model: the bar is 4/3 of the difference from the two finer bodies.
TEST(FinerTessellation, RefinesAnotherSensorByItsOwnModel) {
  const BlockOnBall scene(true);
  const std::shared_ptr<const SimScene> shown = scene.simulator->scene();
  ASSERT_EQ(shown->sensors.size(), 2U);
  const std::vector<TouchedBody>& touched = shown->touched[0];
  ASSERT_EQ(touched.size(), 1U);
  ASSERT_EQ(touched[0].sensor, 1);
  StepView view = scene.simulator->view();
  const Pose X_WM = view.sensors[0].X_WM;
  const std::vector<Pose> X_WB{view.sensors[1].X_WM};
  const std::vector<double> coarse = read_own_contact(*shown->sensors[0], touched, X_WM, X_WB);
  ASSERT_GT(coarse[0], 100);
  view.sensors[0].readings = coarse;
  const SensorModelPtr block = with_finer_body(shown->sensors[0]);
  std::vector<TouchedBody> finer = touched;
  finer[0].body = with_finer_body(shown->sensors[1])->body;
  const std::vector<double> both = richardson_bars(coarse, read_own_contact(*block, finer, X_WM, X_WB));
  const std::vector<double> own = richardson_bars(coarse, read_own_contact(*block, touched, X_WM, X_WB));
  EXPECT_EQ(SensorErrors(*shown, 0).read(view).bars, both);
  EXPECT_GT(both[0], 2 * own[0]) << "the error of the ball dominates";
}

// Of two sensors that touch, one computes the surface and the other mirrors it. The contact that is computed again has
// the bits of the simulation for both.
TEST(FinerTessellation, ComputesTheContactOfBothSensorsAgain) {
  const BlockOnBall scene(true);
  scene.simulator->step();
  const StepView view = scene.simulator->view();
  for (std::size_t i = 0; i < 2; ++i) {
    const std::vector<Pose> X_WB{view.sensors[1 - i].X_WM};
    const std::vector<double> again =
        read_own_contact(*view.scene->sensors[i], view.scene->touched[i], view.sensors[i].X_WM, X_WB);
    EXPECT_EQ(again, std::vector<double>(view.sensors[i].readings.begin(), view.sensors[i].readings.end())) << i;
  }
  EXPECT_NE(view.scene->touched[0][0].mirrored, view.scene->touched[1][0].mirrored);
}

// Readings with a coarse soft ball against those with edges 1/8 as long, at places of the block above the ball.
TEST(FinerTessellation, RefinesSoftGeomsWithoutTaxels) {
  const BlockOnBall scene;
  const std::shared_ptr<const SimScene> shown = scene.simulator->scene();
  ASSERT_EQ(shown->sensors.size(), 2U);
  ASSERT_EQ(shown->touched[0].size(), 1U);
  const TouchedBody& ball = shown->touched[0][0];
  ASSERT_EQ(ball.sensor, 1);
  ASSERT_NE(ball.shape, nullptr);
  EXPECT_EQ(ball.shape->resolution, 0.005);
  const SensorModelPtr model = shown->sensors[0];
  const SensorModel fine = much_finer(*model);
  std::vector<TouchedBody> fine_ball{ball};
  Shape shape = *ball.shape;
  shape.resolution /= 8;
  fine_ball[0].body = make_body(shape, ball.body->material, "ball");
  SensorErrors errors(*shown, 0);
  StepView view = scene.simulator->view();
  const Pose start = view.sensors[0].X_WM;
  int within = 0, all = 0;
  std::vector<double> ratios;
  for (int i = 0; i < 40; ++i) {
    Pose X_WM = start;
    X_WM.p += dvec3(0.0004 * (i % 8 - 4), 0.0007 * (i / 8 - 2), -0.00005 * (i % 5));
    view.sensors[0].X_WM = X_WM;
    const std::vector<Pose> X_WB{view.sensors[1].X_WM};
    const std::vector<double> coarse = read_own_contact(*model, shown->touched[0], X_WM, X_WB);
    view.sensors[0].readings = coarse;
    const double exact = read_own_contact(fine, fine_ball, X_WM, X_WB)[0], error = std::abs(coarse[0] - exact);
    const double bar = errors.read(view).bars[0];
    ASSERT_GT(exact, 100);
    ++all;
    if (error <= bar + 1e-3 * exact) ++within;
    ratios.push_back(bar / error);
  }
  std::sort(ratios.begin(), ratios.end());
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

// A finer body has finer tets, whatever its refinement, and the tables of its own tets.
TEST(FinerBody, HasTheTablesOfItsOwnTets) {
  for (const double refine : {2.0, 0.7}) {
    Layout layout;
    layout.mesh.file = "block";
    layout.mesh.repair.refine = refine;
    layout.sampling.density = 1e5;
    layout.material = {FieldKind::pad, 1e5, 0.005, 5, 0.5};
    layout.taxels = {{0, "", dvec3(0, 0, 0.01), dvec3(0, 0, 1), 0.004, {}}};
    layout.readout.method = ReadingMethod::exact;
    const auto mesh = std::make_shared<const TriMesh>(make_box({0.02, 0.02, 0.01}));
    const SensorModelPtr model = build_sensor_model(layout, mesh, "", "block");
    const SensorModelPtr finer = with_finer_body(model);
    const auto divided = std::make_shared<const TriMesh>(subdivide(*mesh, 1, SubdivisionScheme::midpoint));
    const SensorModelPtr again = build_sensor_model(layout, divided, "", "block");
    const auto tets_of = [](const SensorModel& m) {
      return static_cast<int>(std::get<SoftBody>(m.body->geometry).field->tets().size());
    };
    const int coarse = tets_of(*model), fine = tets_of(*finer);
    EXPECT_GT(fine, 2 * coarse) << refine;
    EXPECT_EQ(fine, tets_of(*again)) << refine << ": the same refinement of faces that are divided once";
    EXPECT_TRUE(finer->ray_tables.tets->has(fine - 1)) << refine;
    EXPECT_FALSE(model->ray_tables.tets->has(coarse)) << refine;
    EXPECT_TRUE(finer->skin_fields->prisms->has(fine - 1)) << refine;
    EXPECT_FALSE(model->skin_fields->prisms->has(coarse)) << refine;
  }
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
