// A saved step contains the bodies that touch its sensors: every model reads the saved step like the original step.
#include <gtest/gtest.h>

#include "core/mesh/make/primitives.h"
#include "core/run/bundle/frame_bundle.h"
#include "core/sim/compare/model_comparison.h"
#include "core/sim/simulator.h"
#include "fixtures/box_sweep.h"
#include "fixtures/complaint.h"
#include "fixtures/fill_frame.h"
#include "fixtures/sweep_model.h"
#include "fixtures/temp_folder.h"

namespace taxel {
namespace {

/// Expects equal readings of the opened step and the original step, by each sensor and model.
void expect_same_readings(const SimFrame& opened, const SimFrame& frame, const std::vector<ReadingModel>& models) {
  ASSERT_EQ(opened.scene->touched.size(), frame.scene->touched.size());
  for (std::size_t s = 0; s < frame.sensors.size(); ++s) {
    const ModelReadings a = ModelComparison(opened.scene, s).read(view_of(opened)),
                        b = ModelComparison(frame.scene, s).read(view_of(frame));
    for (const ReadingModel m : models) {
      EXPECT_EQ(a[m].missing, b[m].missing) << to_word(m);
      EXPECT_EQ(a[m].values, b[m].values) << to_word(m) << " of sensor " << s;
    }
    EXPECT_GT(*std::max_element(b[ReadingModel::star].values.begin(), b[ReadingModel::star].values.end()), 0);
  }
}

SimFramePtr opened_again(const SimFrame& frame) {
  const test::TempFolder folder;
  const std::filesystem::path file = folder.path() / "step.taxelframe";
  const std::string bytes = frame_to_bundle(frame);
  write_file_atomically(file, bytes);
  SimFramePtr opened = read_frame_bundle(file);
  EXPECT_EQ(frame_to_bundle(*opened), bytes);
  return opened;
}

TEST(BundledBodies, GiveEveryModelTheReadingsOfTheSweep) {
  const auto simulator = Simulator::make_scenario(test::fingertip_model(1e5), test::box_sweep());
  for (int i = 0; i < 1300; ++i) simulator->step();
  SimFrame frame;
  test::fill_frame(*simulator, frame);
  expect_same_readings(*opened_again(frame), frame, {kReadingModels.begin(), kReadingModels.end()});
}

TouchedBody touched(const Shape& shape, const Material& material, const std::string& name) {
  TouchedBody one;
  one.name = name;
  one.body = make_body(shape, material, name);
  one.shape = std::make_shared<const Shape>(shape);
  one.X_WB.p = dvec3(0.1, 1.0 / 3.0, -0.2);
  return one;
}

/// Returns bodies of every kind: one of them twice, the sensor itself as if it were another body, and an unknown one.
std::vector<TouchedBody> all_kinds(const SensorModel& sensor) {
  const Material soft{FieldKind::pad, 1e6, 0.002, 0.5, 0.7}, rigid;
  Shape mesh, ball, plane;
  mesh.type = ShapeType::mesh;
  mesh.mesh = std::make_shared<const TriMesh>(make_icosphere(0.01, 2));
  ball.size = dvec3(0.01, 0, 0);
  plane.type = ShapeType::plane;
  std::vector<TouchedBody> all{touched(mesh, soft, "soft mesh"), touched(mesh, rigid, "mesh"),
                               touched(ball, soft, "ball"), touched(plane, rigid, "floor"),
                               touched(plane, soft, "soft floor")};
  all.push_back(all[1]);
  all.emplace_back().name = "not known";
  TouchedBody& other = all.emplace_back();
  other.sensor = 0;
  other.mirrored = true;
  other.body = sensor.body;
  return all;
}

void expect_same_body(const HydroBody& a, const HydroBody& b) {
  EXPECT_EQ(a.name, b.name);
  ASSERT_EQ(a.geometry.index(), b.geometry.index());
  EXPECT_EQ(a.material, b.material);
  if (const auto* y = std::get_if<SoftBody>(&b.geometry)) {
    const PressureField &of_a = *std::get<SoftBody>(a.geometry).field, &of_b = *y->field;
    EXPECT_EQ(of_a.vertices(), of_b.vertices());
    EXPECT_EQ(of_a.vertex_pressure(), of_b.vertex_pressure());
    EXPECT_EQ(of_a.gradients(), of_b.gradients());
    EXPECT_EQ(of_a.report().core, of_b.report().core);
  } else if (const auto* rigid = std::get_if<RigidMesh>(&b.geometry)) {
    EXPECT_EQ(std::get<RigidMesh>(a.geometry).index->mesh().vertices(), rigid->index->mesh().vertices());
  } else if (const auto* space = std::get_if<SoftHalfSpace>(&b.geometry)) {
    EXPECT_EQ(std::get<SoftHalfSpace>(a.geometry).stiffness, space->stiffness);
    EXPECT_EQ(std::get<SoftHalfSpace>(a.geometry).thickness, space->thickness);
  }
}

SimFrame touching_all() {
  SimFrame frame;
  test::fill_frame(*Simulator::make_scenario(test::fingertip_model(1e5), test::box_sweep()), frame);
  auto scene = std::make_shared<SimScene>(*frame.scene);
  scene->touched[0] = all_kinds(*scene->sensors[0]);
  frame.scene = scene;
  return frame;
}

TEST(BundledBodies, IncludeBodiesOfEveryKind) {
  const SimFrame frame = touching_all();
  const SimFramePtr opened = opened_again(frame);
  const std::vector<TouchedBody>&before = frame.scene->touched[0], &after = opened->scene->touched.at(0);
  ASSERT_EQ(after.size(), before.size());
  for (std::size_t k = 0; k < before.size(); ++k) {
    const TouchedBody &a = after[k], &b = before[k];
    EXPECT_EQ(std::tie(a.name, a.geom, a.sensor, a.mirrored), std::tie(b.name, b.geom, b.sensor, b.mirrored));
    EXPECT_EQ(a.X_WB.p, b.X_WB.p);
    ASSERT_EQ(a.body == nullptr, b.body == nullptr) << b.name;
    ASSERT_EQ(a.shape == nullptr, b.shape == nullptr) << b.name;
    if (b.body) expect_same_body(*a.body, *b.body);
    if (!b.shape) continue;
    EXPECT_EQ(std::tie(a.shape->type, a.shape->size), std::tie(b.shape->type, b.shape->size));
    ASSERT_EQ(a.shape->mesh == nullptr, b.shape->mesh == nullptr);
    if (b.shape->mesh) {
      EXPECT_EQ(a.shape->mesh->vertices(), b.shape->mesh->vertices());
    }
  }
  EXPECT_EQ(after[5].body, after[1].body) << "one body for both";
  EXPECT_EQ(after.back().body, opened->scene->sensors[0]->body);
}

/// An error names the array of a number out of range.
TEST(BundledBodies, RefuseBodiesOfMissingScenes) {
  SimFrame frame = touching_all();
  auto scene = std::make_shared<SimScene>(*frame.scene);
  scene->touched[0][0].geom = 1000;
  frame.scene = scene;
  const std::string said = test::complaint_of([&] { (void)opened_again(frame); });
  EXPECT_NE(said.find("sensor0/touched: 1000 is not among -1 to"), std::string::npos) << said;
}

}  // namespace
}  // namespace taxel
