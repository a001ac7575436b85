// One contact read by other models: MuJoCo's own sensors compared with geometry and known forces, the other models bit
// for bit with the code that computes them elsewhere.
#include <gtest/gtest.h>

#include "core/mesh/make/primitives.h"
#include "core/sensor/readout/reading.h"
#include "core/sim/compare/model_comparison.h"
#include "core/sim/simulator.h"
#include "fixtures/box_sweep.h"
#include "fixtures/fill_frame.h"
#include "fixtures/sweep_model.h"

namespace taxel {
namespace {

constexpr double kR = 0.01;  // radius of the ball that is the sensor
const dvec3 kMiddle(0.003, 0.001, 0.002);

/// Returns a ball off its frame's origin, with taxels in the given directions.
SensorModelPtr ball_sensor(const std::vector<dvec3>& directions) {
  auto model = std::make_shared<SensorModel>();
  const TriMesh ball = make_icosphere(kR, 4);
  std::vector<dvec3> vertices;
  for (const dvec3& v : ball.vertices()) vertices.push_back(v + kMiddle);
  model->mesh = std::make_shared<const TriMesh>(vertices, ball.faces());
  model->skin = std::make_shared<const MeshIndex>(model->mesh);
  for (const dvec3& direction : directions) {
    Taxel& taxel = model->layout.taxels.emplace_back();
    taxel.normal = glm::normalize(direction);
    taxel.center = kMiddle + kR * taxel.normal;
    taxel.radius = 0.003;
  }
  return model;
}

TouchedBody object(const Shape& shape) {
  TouchedBody body;
  body.name = "object";
  body.shape = std::make_shared<const Shape>(shape);
  body.body = make_body(shape, Material{}, "object");
  return body;
}

Shape shape(ShapeType type, const dvec3& size) {
  Shape out;
  out.type = type;
  out.size = size;
  return out;
}

/// Returns the pose with the ball's centre at p_W, rotated about it.
Pose ball_at(const dvec3& p_W, const dquat& q) {
  Pose X_WM{q, dvec3(0)};
  X_WM.p = p_W - X_WM.rotate(kMiddle);
  return X_WM;
}

const dquat kTurned = glm::angleAxis(0.7, glm::normalize(dvec3(1, 2, -0.5)));
const Pose kOn = ball_at({0, 0, kR - 0.001}, kTurned);  // 1 mm deep in a body that ends at z = 0

/// Returns the direction straight below the turned ball, and directions slightly off it.
std::vector<dvec3> below() {
  std::vector<dvec3> out;
  for (const dvec3& d : {dvec3(0, 0, -1), dvec3(0.3, 0, -1), dvec3(0, -0.2, -1), dvec3(1, 0, 0)})
    out.push_back(glm::conjugate(kTurned) * d);
  return out;
}

// Depth is geometry: -z for a plane, a box and a mesh; R - |p - c| for a ball. The mesh is the one of MuJoCo's octree.
TEST(MujocoSensors, GiveTheDepthOfTheGeometry) {
  const SensorModelPtr ball = ball_sensor(below());
  struct Case {
    Shape what;
    dvec3 center;
    double tolerance;
  };
  Shape mesh = shape(ShapeType::mesh, dvec3(0));
  mesh.mesh = std::make_shared<const TriMesh>(make_box(dvec3(0.05, 0.05, 0.02)));
  const std::vector<Case> cases{{shape(ShapeType::plane, dvec3(1)), dvec3(0), 1e-7},
                                {shape(ShapeType::box, dvec3(0.05, 0.05, 0.02)), dvec3(0, 0, -0.02), 5e-6},
                                {mesh, dvec3(0, 0, -0.02), 1e-6},
                                {shape(ShapeType::sphere, dvec3(0.03, 0, 0)), dvec3(0, 0, -0.03), 1e-7}};
  for (const Case& c : cases) {
    MujocoSensors sensors(*ball, {object(c.what)}, {});
    const MujocoReadings found = sensors.read(kOn, {Pose{{1, 0, 0, 0}, c.center}}, {dvec3(0, 0, 2.5)});
    for (std::size_t k = 0; k < 4; ++k) {
      const dvec3 p = kOn * ball->layout.taxels[k].center;
      const double depth = c.what.type == ShapeType::sphere ? 0.03 - glm::distance(p, c.center) : -p.z;
      EXPECT_NEAR(found.depth[k], std::max(0.0, depth), c.tolerance) << static_cast<int>(c.what.type) << " " << k;
    }
    EXPECT_NEAR(found.depth[0], 0.001, c.tolerance);
  }
}

// For a taxel with samples, the depth is the weighted mean over the samples.
TEST(MujocoSensors, GiveTheMeanDepthOverTheField) {
  auto ball = std::make_shared<SensorModel>(*ball_sensor(below()));
  for (const Taxel& taxel : ball->layout.taxels) {
    SurfaceSample& sample = ball->samples.emplace_back();
    sample.position = taxel.center;
  }
  ball->fields.first = {0, 2, 3, 3, 3};
  ball->fields.entries = {{0, 0, 1e-6}, {1, 0, 3e-6}, {2, 0, 5e-6}};
  MujocoSensors sensors(*ball, {object(shape(ShapeType::plane, dvec3(1)))}, {});
  const std::vector<double> depth = sensors.read(kOn, {Pose{}}, {dvec3(0, 0, 1)}).depth;
  const auto below_plane = [&](std::size_t k) { return std::max(0.0, -(kOn * ball->layout.taxels[k].center).z); };
  EXPECT_NEAR(depth[0], (below_plane(0) + 3 * below_plane(1)) / 4, 1e-7);
  EXPECT_NEAR(depth[1], below_plane(2), 1e-7);
  EXPECT_NEAR(depth[2], below_plane(2), 1e-7) << "without samples its centre";
  EXPECT_GT(depth[0], 5e-4);
}

// A known weight rests on one contact point or is shared by several. A taxel over all of them feels the whole weight.
TEST(MujocoSensors, GiveTheWeightAsTouch) {
  const SensorModelPtr ball = ball_sensor(below());
  for (const Shape& what : {shape(ShapeType::plane, dvec3(1)), shape(ShapeType::sphere, dvec3(0.03, 0, 0))}) {
    const dvec3 center = what.type == ShapeType::plane ? dvec3(0) : dvec3(0, 0, -0.03);
    for (const double weight : {0.02, 2.5}) {
      MujocoSensors sensors(*ball, {object(what)}, {});
      const MujocoReadings found = sensors.read(kOn, {Pose{{1, 0, 0, 0}, center}}, {dvec3(0, 0, weight)});
      EXPECT_NEAR(found.touch[0], weight, 3e-4 * weight);
      EXPECT_EQ(found.touch[3], 0);
    }
  }
}

TEST(MujocoSensors, IgnoreAPairWithoutForceAndEarlierSteps) {
  const SensorModelPtr ball = ball_sensor(below());
  const std::vector<TouchedBody> both{object(shape(ShapeType::plane, dvec3(1))),
                                      object(shape(ShapeType::sphere, dvec3(0.03, 0, 0)))};
  const std::vector<Pose> X_WB{Pose{}, Pose{{1, 0, 0, 0}, dvec3(0.035, 0, 0.01)}};
  MujocoSensors sensors(*ball, both, {});
  const MujocoReadings first = sensors.read(kOn, X_WB, {dvec3(0, 0, 2.5), dvec3(0)});
  EXPECT_NEAR(first.touch[0], 2.5, 1e-3);
  EXPECT_EQ(first.touch[3], 0);
  const MujocoReadings other = sensors.read(kOn, X_WB, {dvec3(0, 0, 1), dvec3(-0.7, 0, 0)});
  EXPECT_NEAR(other.touch[3], 0.7, 1e-3) << "each pair carries its own force";
  EXPECT_GT(other.depth[3], 0.001);
  const MujocoReadings again = sensors.read(kOn, X_WB, {dvec3(0, 0, 2.5), dvec3(0)});
  EXPECT_EQ(again.touch, first.touch);
  EXPECT_EQ(again.depth, first.depth);
  const MujocoReadings none = sensors.read(kOn, X_WB, {dvec3(0), dvec3(0)});
  EXPECT_EQ(none.touch, std::vector<double>(4, 0.0));
  EXPECT_EQ(none.depth, std::vector<double>(4, 0.0));
}

class Comparison : public testing::Test {
 protected:
  static void SetUpTestSuite() { model_ = test::fingertip_model(1e6); }
  static void TearDownTestSuite() { model_.reset(); }
  static SimFrame after(Simulator& simulator, int steps) {
    for (int i = 0; i < steps; ++i) simulator.step();
    SimFrame frame;
    test::fill_frame(simulator, frame);
    return frame;
  }
  static SensorModelPtr model_;
};
SensorModelPtr Comparison::model_;

TEST_F(Comparison, ReadsTheStepLikeEachModelAlone) {
  const auto simulator = Simulator::make_scenario(model_, test::box_sweep());
  const SimFrame frame = after(*simulator, 1300);
  const SensorStep& state = frame.sensors[0];
  ModelComparison comparison(frame.scene, 0);
  const ModelReadings found = comparison.read(view_of(frame));
  for (const ReadingModel m : kReadingModels) {
    EXPECT_EQ(found[m].values.size(), 12U) << to_word(m) << ": " << found[m].missing;
    EXPECT_EQ(found[m].missing, "") << to_word(m);
  }
  EXPECT_EQ(found[ReadingModel::reading].values, state.readings);
  std::vector<const ContactSurface*> surfaces;
  for (const ContactSurface& surface : state.surfaces) surfaces.push_back(&surface);
  double largest = 0;
  for (std::size_t k = 0; k < 12; ++k) {
    // The sum of w p by the definition: weights are (r - d)^2 of the samples.
    double sum = 0;
    const auto first = static_cast<std::size_t>(model_->fields.first[k]),
               last = static_cast<std::size_t>(model_->fields.first[k + 1]);
    for (std::size_t e = first; e < last; ++e)
      sum += model_->fields.entries[e].weight *
             state.hits[static_cast<std::size_t>(model_->readout_table.ray_of_entry[e])].pressure;
    EXPECT_NEAR(found[ReadingModel::weighted_sum].values[k], sum, 1e-12 * std::max(1e-6, sum)) << k;
    EXPECT_EQ(found[ReadingModel::exact].values[k], *exact_reading(*model_, static_cast<int>(k), surfaces).value);
    largest = std::max(largest, found[ReadingModel::tactile].values[k]);
  }
  EXPECT_GT(found[ReadingModel::weighted_sum].values[10], 0);
  EXPECT_GT(largest, 2e-5) << "the tip is in the box";
  EXPECT_LT(largest, 3e-3);
}

// A layout that was compiled with a star reads the same poses with the same bits.
TEST_F(Comparison, EqualsAStarLayoutForTheStar) {
  const auto simulator = Simulator::make_scenario(model_, test::box_sweep());
  const SimFrame frame = after(*simulator, 1250);
  ModelComparison comparison(frame.scene, 0);
  Layout layout = model_->layout;
  layout.material.field = FieldKind::star;
  const SensorModelPtr star = build_sensor_model(layout, model_->mesh, "", "star");
  const auto by_star = Simulator::make_scenario(star, test::box_sweep());
  const std::vector<Pose> X_WM{frame.sensors[0].X_WM};
  const SensorStep contact = by_star->contact_at(0, X_WM, frame.geom_poses);
  const std::vector<double> found = comparison.read(view_of(frame))[ReadingModel::star].values;
  EXPECT_EQ(found, contact.readings);
  EXPECT_NE(found, frame.sensors[0].readings);
  EXPECT_GT(*std::max_element(found.begin(), found.end()), 0);
}

TEST_F(Comparison, DoesNotInfluenceTheSimulation) {
  const auto compared = Simulator::make_scenario(model_, test::box_sweep());
  const auto alone = Simulator::make_scenario(model_, test::box_sweep());
  const SimFrame frame = after(*compared, 1100);
  after(*alone, 1100);
  ModelComparison comparison(frame.scene, 0);
  const ModelReadings first = comparison.read(view_of(frame));
  const SimFrame a = after(*compared, 10), b = after(*alone, 10);
  EXPECT_EQ(a.sensors[0].readings, b.sensors[0].readings);
  EXPECT_EQ(a.sensors[0].X_WM.p, b.sensors[0].X_WM.p);
  EXPECT_EQ(comparison.read(view_of(a))[ReadingModel::reading].values, a.sensors[0].readings);
  const ModelReadings again = comparison.read(view_of(frame));
  for (const ReadingModel m : kReadingModels) EXPECT_EQ(again[m].values, first[m].values) << to_word(m);
}

TEST_F(Comparison, ReportsWhyAModelIsMissing) {
  const auto simulator = Simulator::make_scenario(model_, test::box_sweep());
  const SimFrame frame = after(*simulator, 1200);
  auto scene = std::make_shared<SimScene>(*frame.scene);
  scene->touched.clear();  // as in a step that an earlier version saved
  ModelComparison comparison(scene, 0);
  const ModelReadings found = comparison.read(view_of(frame));
  EXPECT_TRUE(found[ReadingModel::star].values.empty());
  for (const ReadingModel m : {ReadingModel::star, ReadingModel::tactile, ReadingModel::touch})
    EXPECT_NE(found[m].missing.find("read from a file"), std::string::npos) << to_word(m);
  EXPECT_EQ(found[ReadingModel::exact].values.size(), 12U);
  EXPECT_THROW(ModelComparison(scene, 3), Error);
}

}  // namespace
}  // namespace taxel
