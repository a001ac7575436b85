// Picking of taxels, samples, polygons and bodies, labels, and the gizmo of the axes.
#include "ui/scene/picking.h"

#include <gtest/gtest.h>

#include <cmath>

#include "ui/scene/camera.h"
#include "ui/scene/finger_scene.h"
#include "ui/scene/scene_labels.h"
#include "ui/scene/scene_parts.h"

namespace taxel::ui {
namespace {

constexpr int kWidth = 800, kHeight = 560;

class PickingTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    model_ = test::finger_model(4000);
    frame_ = test::finger_frame(model_, 0.003);
  }
  static void TearDownTestSuite() {
    model_.reset();
    frame_.reset();
  }
  static SceneInput layout_input() {
    SceneInput input;
    input.document_model = model_;
    return input;
  }
  static Camera layout_camera() {
    Camera camera;
    camera.frame(model_->mesh->bounds());
    camera.azimuth_deg = -90;
    camera.elevation_deg = 5;
    return camera;
  }
  static SensorModelPtr model_;
  static SimFramePtr frame_;
};
SensorModelPtr PickingTest::model_;
SimFramePtr PickingTest::frame_;

class PickingIn : public PickingTest, public ::testing::WithParamInterface<bool> {
 protected:
  static Camera projected(Camera camera) {
    camera.orthographic = GetParam();
    return camera;
  }
};
INSTANTIATE_TEST_SUITE_P(Projections, PickingIn, ::testing::Bool());

TEST_P(PickingIn, FindsTheTaxelUnderThePointer) {
  const Camera camera = projected(layout_camera());
  int found = 0;
  for (int k = 0; k < model_->taxel_count(); ++k) {
    const Taxel& taxel = model_->layout.taxels[static_cast<std::size_t>(k)];
    const dvec3 pixel = camera.project(taxel.center, kWidth, kHeight);
    const auto picked = pick(layout_input(), camera, pixel.x + 3, pixel.y - 2, kWidth, kHeight);
    if (glm::dot(taxel.normal, camera.eye() - taxel.center) <= 0) {
      EXPECT_FALSE(picked && picked->taxel == k);  // on the far side
      continue;
    }
    ++found;
    ASSERT_TRUE(picked);
    EXPECT_EQ(picked->taxel, k);
    EXPECT_EQ(picked->sensor, 0);
    EXPECT_EQ(picked->position_W, taxel.center);
  }
  EXPECT_GE(found, 6);
}

TEST_P(PickingIn, FindsTheSampleUnderThePointer) {
  const Camera camera = projected(layout_camera());
  SceneInput input = layout_input();
  input.overlays.taxels = false;
  int facing = 0;
  for (std::size_t i = 0; i < model_->samples.size(); i += 97) {
    const SurfaceSample& sample = model_->samples[i];
    if (glm::dot(sample.normal, glm::normalize(camera.eye() - sample.position)) < 0.3) continue;
    ++facing;
    const dvec3 pixel = camera.project(sample.position, kWidth, kHeight);
    const auto picked = pick(input, camera, pixel.x, pixel.y, kWidth, kHeight);
    ASSERT_TRUE(picked);
    EXPECT_EQ(picked->sample, static_cast<int>(i));
    EXPECT_LT(glm::length(picked->position_W - sample.position), 1e-9);
  }
  EXPECT_GT(facing, 0);
}

TEST_P(PickingIn, FindsThePolygonAndItsPressure) {
  const SceneInput input = [] {
    SceneInput in = test::finger_input(frame_);
    in.overlays.taxels = false;
    return in;
  }();
  Camera camera = projected(test::finger_camera());
  camera.elevation_deg = 55;
  camera.distance = 0.03;
  const SensorStep& state = frame_->sensors[0];
  for (std::size_t i = 0; i < state.surfaces[0].polygons.size(); i += 7) {
    const ContactPolygon& polygon = state.surfaces[0].polygons[i];
    const dvec3 pixel = camera.project(state.X_WM * polygon.centroid, kWidth, kHeight);
    const auto picked = pick(input, camera, pixel.x, pixel.y, kWidth, kHeight);
    ASSERT_TRUE(picked);
    EXPECT_EQ(picked->polygon, static_cast<int>(i));
    EXPECT_EQ(picked->surface, 0);
    EXPECT_NEAR(picked->pressure, polygon.pressure, 1e-6 * input.range.hi);
  }
  camera.elevation_deg = -50;  // the box is in front of the contact
  const auto& polygons = state.surfaces[0].polygons;
  const auto deepest = std::max_element(polygons.begin(), polygons.end(),
                                        [](const auto& a, const auto& b) { return a.pressure < b.pressure; });
  const dvec3 pixel = camera.project(state.X_WM * deepest->centroid, kWidth, kHeight);
  const auto below = pick(input, camera, pixel.x, pixel.y, kWidth, kHeight);
  ASSERT_TRUE(below);
  EXPECT_EQ(below->polygon, -1);
}

TEST_F(PickingTest, SkipsTaxelsBehindABody) {
  SceneInput input = test::finger_input(frame_);
  Camera below = test::finger_camera();  // the box is between the eye and the fingertip
  below.azimuth_deg = 0;
  below.elevation_deg = -60;
  below.target = {0, 0, -0.02};
  below.distance = 0.2;
  const Pose& X_WM = frame_->sensors[0].X_WM;
  int behind = 0;
  for (int k = 0; k < model_->taxel_count(); ++k) {
    const Taxel& taxel = model_->layout.taxels[static_cast<std::size_t>(k)];
    const dvec3 center = X_WM * taxel.center, pixel = below.project(center, kWidth, kHeight);
    if (glm::dot(X_WM.rotate(taxel.normal), below.eye() - center) <= 0) continue;
    const auto body = cast_geoms(input, below.pixel_ray(pixel.x, pixel.y, kWidth, kHeight));
    if (!body || body->t > 0.98 * glm::distance(center, below.eye())) continue;
    ++behind;
    const auto hidden = pick(input, below, pixel.x, pixel.y, kWidth, kHeight);
    ASSERT_TRUE(hidden);
    EXPECT_EQ(hidden->taxel, -1) << "taxel " << taxel.id;
    EXPECT_EQ(hidden->geom_name, "box");
    SceneInput alone = input;  // the same taxel without the box
    auto frame = std::make_shared<SimFrame>(*frame_);
    frame->geom_poses[0].p.x += 1;
    alone.frame = frame;
    const auto seen = pick(alone, below, pixel.x, pixel.y, kWidth, kHeight);
    ASSERT_TRUE(seen);
    EXPECT_GE(seen->taxel, 0);
  }
  EXPECT_GE(behind, 1);
}

TEST_F(PickingTest, FindsOtherBodiesAndNothingOnTheBackground) {
  const SceneInput input = test::finger_input(frame_);
  const Camera camera = test::finger_camera();
  const dvec3 corner = camera.project({0.02, -0.024, 0}, kWidth, kHeight);
  const auto box = pick(input, camera, corner.x, corner.y, kWidth, kHeight);
  ASSERT_TRUE(box);
  EXPECT_EQ(box->geom_name, "box");
  EXPECT_EQ(box->sensor, -1);
  EXPECT_NEAR(box->position_W.z, 0, 1e-12);
  EXPECT_NEAR(glm::length(box->position_W - dvec3(0.02, -0.024, 0)), 0, 1e-9);
  EXPECT_FALSE(pick(input, camera, 5, 5, kWidth, kHeight));
}

TEST_F(PickingTest, OmitsLabelsWhosePixelIsNotFinite) {
  for (const double coordinate : {1e308, std::nan("")}) {
    Camera camera = layout_camera();
    camera.target = dvec3(coordinate);
    camera.distance = coordinate;
    EXPECT_TRUE(scene_labels(layout_input(), camera, kWidth, kHeight).empty()) << coordinate;
    EXPECT_TRUE(scene_labels(test::finger_input(frame_), camera, kWidth, kHeight).empty()) << coordinate;
  }
}

TEST_F(PickingTest, PlacesLabelsPastTheArrowsAndDetectsOcclusion) {
  const Camera camera = layout_camera();
  const auto labels = scene_labels(layout_input(), camera, kWidth, kHeight);
  ASSERT_EQ(static_cast<int>(labels.size()), model_->taxel_count());
  for (const SceneLabel& label : labels) {
    const Taxel& taxel = model_->layout.taxels[static_cast<std::size_t>(label.taxel)];
    EXPECT_EQ(label.text, std::to_string(taxel.id));
    EXPECT_EQ(label.occluded, glm::dot(taxel.normal, camera.eye() - taxel.center) <= 0);
    const dvec3 center = camera.project(taxel.center, kWidth, kHeight);
    const dvec3 outward = camera.project(taxel.center + 1e-4 * taxel.normal, kWidth, kHeight);
    EXPECT_GT(glm::dot(label.pixel - dvec2(center), dvec2(outward - center)), 0);
  }
  SceneInput hidden = layout_input();
  hidden.overlays.taxel_labels = false;
  EXPECT_TRUE(scene_labels(hidden, camera, kWidth, kHeight).empty());

  // From behind the box: the box hides the taxels at the tip, although they face the eye.
  Camera below = test::finger_camera();
  below.azimuth_deg = 0;
  below.elevation_deg = -60;
  below.target = {0, 0, -0.02};
  below.distance = 0.2;
  int facing_but_hidden = 0;
  for (const SceneLabel& label : scene_labels(test::finger_input(frame_), below, kWidth, kHeight)) {
    if (label.taxel < 0) continue;  // the net force
    const Taxel& taxel = model_->layout.taxels[static_cast<std::size_t>(label.taxel)];
    const Pose& X_WM = frame_->sensors[0].X_WM;
    const bool facing = glm::dot(X_WM.rotate(taxel.normal), below.eye() - X_WM * taxel.center) > 0;
    if (facing && label.occluded) ++facing_but_hidden;
  }
  EXPECT_GE(facing_but_hidden, 1);
}

TEST_F(PickingTest, PlacesLabelsOfManyTaxelsWithoutOverlap) {
  Layout layout = model_->layout;
  for (int k = 0; k < 600; ++k) {  // on all sides, some at the same place
    Taxel taxel = layout.taxels[static_cast<std::size_t>(k % 12)];
    taxel.id = 100 + k;
    taxel.center += 2e-4 * dvec3(k % 7, k % 5, k % 11);
    layout.taxels.push_back(taxel);
  }
  auto many = std::make_shared<SensorModel>(*model_);
  many->layout = layout;
  SceneInput input = layout_input();
  input.document_model = many;
  input.selected_taxel = 611;
  const Camera camera = layout_camera();
  const auto labels = scene_labels(input, camera, kWidth, kHeight, {.text_height = 12});
  EXPECT_GT(labels.size(), 12u);
  EXPECT_LE(labels.size(), 250u);
  int selected = 0;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const SceneLabel& a = labels[i];
    selected += a.selected ? 1 : 0;
    const Taxel& taxel = layout.taxels[static_cast<std::size_t>(a.taxel)];
    EXPECT_TRUE(a.selected || glm::dot(taxel.normal, camera.eye() - taxel.center) > 0) << a.text;
    for (std::size_t j = 0; j < i; ++j) {
      const dvec2 apart = glm::abs(a.pixel - labels[j].pixel);
      EXPECT_TRUE(apart.y >= 12 || apart.x >= 0.5 * 7 * (a.text.size() + labels[j].text.size())) << a.text;
    }
  }
  EXPECT_EQ(selected, 1);
}

TEST_F(PickingTest, ReportsDistanceAngleAndWeightOfASamplePerTaxel) {
  int shared = 0;
  for (int s = 0; s < static_cast<int>(model_->samples.size()); ++s) {
    const auto& taxels = model_->taxels_of_sample[static_cast<std::size_t>(s)];
    const std::vector<SampleUse> uses = uses_of_sample(*model_, s);
    ASSERT_EQ(uses.size(), taxels.size());
    shared += uses.size() > 1 ? 1 : 0;
    for (std::size_t i = 0; i < uses.size(); ++i) {
      EXPECT_EQ(uses[i].taxel, taxels[i]);
      const Taxel& taxel = model_->layout.taxels[static_cast<std::size_t>(taxels[i])];
      const SurfaceSample& sample = model_->samples[static_cast<std::size_t>(s)];
      EXPECT_NEAR(uses[i].distance, glm::distance(taxel.center, sample.position), 1e-15);
      EXPECT_NEAR(uses[i].weight, std::pow(taxel.radius - uses[i].distance, 2), 1e-15);
      EXPECT_NEAR(std::cos(glm::radians(uses[i].angle_deg)), glm::dot(sample.normal, glm::normalize(taxel.normal)),
                  1e-9);
      EXPECT_LT(uses[i].angle_deg, 45);
    }
  }
  EXPECT_GT(shared, 10);
}

TEST(Gizmo, LooksFromTheAxisOfAClickedBall) {
  Camera camera;
  camera.target = {0.1, 0.2, 0.3};
  for (const GizmoBall& ball : gizmo_balls(camera, {kWidth, kHeight})) {
    const int hit = gizmo_hit(camera, ball.pixel, {kWidth, kHeight});
    EXPECT_EQ(hit, ball.axis);
    Camera turned = camera;
    look_from_axis(turned, hit);
    const dvec3 direction = glm::normalize(turned.eye() - turned.target);
    EXPECT_GT((ball.positive() ? 1 : -1) * direction[ball.axis / 2], 0.9999);
    EXPECT_EQ(turned.target, camera.target);
    EXPECT_EQ(turned.distance, camera.distance);
    EXPECT_EQ(gizmo_balls(turned, {kWidth, kHeight}).back().axis, ball.axis);  // now nearest
  }
  EXPECT_EQ(gizmo_hit(camera, {0.5 * kWidth, 0.5 * kHeight}, {kWidth, kHeight}), -1);
}

TEST(Gizmo, TakesTheStandardViewsOfBlender) {
  // Direction to the eye, and the direction to the right on the screen, for +x, -x, +y, -y, +z, -z.
  const std::array<std::array<dvec3, 2>, 6> expected{{{dvec3(1, 0, 0), dvec3(0, 1, 0)},
                                                      {dvec3(-1, 0, 0), dvec3(0, -1, 0)},
                                                      {dvec3(0, 1, 0), dvec3(-1, 0, 0)},
                                                      {dvec3(0, -1, 0), dvec3(1, 0, 0)},
                                                      {dvec3(0, 0, 1), dvec3(1, 0, 0)},
                                                      {dvec3(0, 0, -1), dvec3(1, 0, 0)}}};
  const std::array<std::string, 6> names{"Right", "Left", "Back", "Front", "Top", "Bottom"};
  for (int axis = 0; axis < 6; ++axis) {
    Camera camera;
    camera.roll_deg = 20;
    camera.orthographic = axis % 2 == 0;
    take_standard_view(camera, axis);
    const glm::dmat4 view = camera.view();
    const auto& [toward, right] = expected[static_cast<std::size_t>(axis)];
    EXPECT_LT(glm::distance(glm::normalize(camera.eye() - camera.target), toward), 1e-12) << axis;
    EXPECT_LT(glm::distance(dvec3(view[0][0], view[1][0], view[2][0]), right), 1e-12) << axis;
    EXPECT_EQ(standard_view_name(camera), names[static_cast<std::size_t>(axis)]);
    camera.orbit(1, 0);
    EXPECT_EQ(standard_view_name(camera), std::string());
  }
}

}  // namespace
}  // namespace taxel::ui
