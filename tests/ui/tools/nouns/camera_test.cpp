// The camera: framing, sensors in the view, cameras of the scene, and following a body.
#include "app/studio/nouns/camera/camera_state.h"

#include <gtest/gtest.h>

#include <cmath>

#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "ui/tools/tool_scene.h"

namespace taxel::ui {
namespace {

/// A camera at (1, 0, 0) that looks along -x, with y to the right. At depth d, the square view shows |y| and |z| up to
/// d.
Camera unit_camera() {
  Camera camera;
  camera.azimuth_deg = camera.elevation_deg = 0;
  camera.distance = 1;
  camera.fov_deg = 90;
  return camera;
}

/// The corners of a cube.
BoxCorners cube(const dvec3& center, double half) {
  BoxCorners corners;
  for (std::size_t i = 0; i < corners.size(); ++i)
    corners[i] = center + half * dvec3((i & 1U) != 0 ? 1 : -1, (i & 2U) != 0 ? 1 : -1, (i & 4U) != 0 ? 1 : -1);
  return corners;
}

/// A running scene with three cameras and three bodies: the world, an arm and a hand on the arm.
struct ThreeCameras {
  Viewer viewer;
  Shown shown;
  FollowState follow;
  std::shared_ptr<SimScene> scene = std::make_shared<SimScene>();
  std::shared_ptr<SimFrame> frame = std::make_shared<SimFrame>();
  ThreeCameras() {
    viewer.mode = Mode::simulate;
    scene->marks.cameras = {{"left", 30, false}, {"top", 60, false}, {"plan", 2, true}};
    scene->controls.bodies.resize(3);
    scene->controls.bodies[1].name = "arm";
    scene->controls.bodies[2].parent = 1;
    frame->mark_poses.cameras.resize(3);
    frame->mark_poses.bodies.resize(3);
    frame->scene = scene;
    shown.run.frame = frame;
  }
  void look(int direction) { look_through_next(viewer, shown, follow, direction); }
  void follow_frame() { follow_scene(viewer, shown.run, follow); }
};

TEST(FrameScene, KeepsTheDirectionOfSight) {
  test::ToolScene ball({});
  ball.app.viewer->camera().azimuth_deg = 33;
  frame_scene(*ball.app.viewer, *ball.app.shown);
  const double radius = 0.5 * ball.app.shown->document.model->mesh->bounds().diagonal();
  EXPECT_EQ(ball.app.viewer->camera().azimuth_deg, 33);
  EXPECT_NEAR(ball.app.viewer->camera().distance, 1.1 * radius / std::sin(glm::radians(20.0)), 1e-12);
}

TEST(FrameScene, MovesBackUntilANarrowViewShowsTheSensor) {
  test::ToolScene ball({});
  Viewer& viewer = *ball.app.viewer;
  viewer.view.width = 60;
  frame_scene(viewer, *ball.app.shown);
  const BoxCorners box = sensor_boxes(viewer, *ball.app.shown).at(0);
  EXPECT_TRUE(is_inside_view(box, viewer.camera(), 60, 600));
  viewer.camera().zoom(1);
  EXPECT_FALSE(is_inside_view(box, viewer.camera(), 60, 600)) << "a notch nearer is too near";
}

/// A ball whose taxels and frame have given directions, and the direction and the upward side of its first view.
struct FirstView {
  explicit FirstView(const std::vector<dvec3>& normals, const SensorFrame& frame = {}) : scene({}) {
    auto model = std::make_shared<SensorModel>(*scene.app.shown->document.model);
    model->layout.taxels.clear();
    for (const dvec3& normal : normals) model->layout.taxels.push_back({0, "", dvec3(0), normal, 0.006, {}});
    model->layout.frame = frame;
    scene.app.shown->document.model = model;
    look_at_touching_side(*scene.app.viewer, *scene.app.shown);
    const glm::dmat3 axes = glm::transpose(glm::dmat3(scene.app.viewer->camera().view()));
    back = axes[2];
    up = axes[1];
  }
  test::ToolScene scene;
  dvec3 back{0}, up{0};  ///< towards the eye, and upward in the image
};

TEST(LookAtTouchingSide, IsTwentyDegreesAboveThePadWithTheTipUp) {
  const double c = std::cos(glm::radians(20.0)), s = std::sin(glm::radians(20.0));
  const FirstView by_frame({});
  EXPECT_LT(glm::distance(by_frame.back, dvec3(0, -c, s)), 1e-12) << "the default pad is -y, the tip is +z";
  EXPECT_LT(glm::distance(by_frame.up, dvec3(0, s, c)), 1e-12);
  EXPECT_EQ(by_frame.scene.app.viewer->camera().roll_deg, 0);
  const FirstView by_taxels({{1, 0, 0}, {1, 0, 0.5}, {2, 0.3, 0}, {2, -0.3, 0}});
  EXPECT_LT(glm::distance(by_taxels.back, dvec3(c, 0, s)), 1e-12) << "the taxels face +x";
  const FirstView turned({{0, 0, 1}}, {.distal = {0, 2, 0}, .pad = {1, 0, 0}});
  EXPECT_LT(glm::distance(turned.back, dvec3(0, s, c)), 1e-12) << "the tip is +y";
  EXPECT_LT(glm::distance(turned.up, dvec3(0, c, -s)), 1e-12);
}

TEST(LookAtTouchingSide, LooksDownOnAPlateAndIgnoresTaxelsAllAround) {
  const FirstView plate({{0, 0, 1}, {0, 0, 1}});
  EXPECT_LT(glm::distance(plate.back, glm::normalize(dvec3(0, -1, 1))), 1e-12) << "45 degrees above";
  const FirstView around({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}});
  EXPECT_LT(std::abs(around.back.x), 1e-12) << "the pad of the frame decides";
  EXPECT_LT(around.back.y, -0.9);
}

TEST(LookAtTouchingSide, SeesAHandAtThreeQuartersOfItsPalm) {
  test::ToolScene ball({});
  auto model = std::make_shared<SensorModel>(*ball.app.shown->document.model);
  model->layout.taxels = {{0, "", dvec3(0), {0, -1, 0}, 0.006, {}}};
  auto scene = std::make_shared<SimScene>();
  auto frame = std::make_shared<SimFrame>();
  for (const double tilt : {-0.3, 0.3}) {
    scene->sensors.push_back(model);
    SensorStep& sensor = frame->sensors.emplace_back();
    sensor.model = model;
    sensor.X_WM.q = glm::angleAxis(0.5 * kPi, dvec3(0, 0, 1)) * glm::angleAxis(tilt, dvec3(1, 0, 0));
  }
  frame->scene = scene;
  ball.app.viewer->mode = Mode::simulate;
  ball.app.shown->run.frame = frame;
  look_at_touching_side(*ball.app.viewer, *ball.app.shown);
  EXPECT_NEAR(ball.app.viewer->camera().azimuth_deg, 45, 1e-9) << "the fingers touch along +x";
  EXPECT_NEAR(ball.app.viewer->camera().elevation_deg, 20, 1e-9);
}

TEST(SensorBoxes, ListTheDocumentInLayout) {
  test::ToolScene ball({});
  const std::vector<BoxCorners> boxes = sensor_boxes(*ball.app.viewer, *ball.app.shown);
  ASSERT_EQ(boxes.size(), 1U);
  EXPECT_LT(glm::distance(boxes[0].front(), dvec3(-test::kBallRadius)), 1e-12);
  EXPECT_LT(glm::distance(boxes[0].back(), dvec3(test::kBallRadius)), 1e-12);
}

TEST(IsInsideView, NeedsEveryCorner) {
  EXPECT_TRUE(is_inside_view(cube({0, 0, 0}, 0.1), unit_camera(), 100, 100));
  EXPECT_TRUE(is_inside_view(cube({0, 0.7, 0}, 0.1), unit_camera(), 100, 100)) << "0.8 at a depth of 0.9";
  EXPECT_FALSE(is_inside_view(cube({0, 0.85, 0}, 0.1), unit_camera(), 100, 100)) << "0.95 at a depth of 0.9";
  EXPECT_FALSE(is_inside_view(cube({0.95, 0, 0}, 0.1), unit_camera(), 100, 100)) << "partly behind the eye";
}

TEST(IsOutsideView, NeedsAllCornersBeyondOneSide) {
  EXPECT_FALSE(is_outside_view(cube({0, 1.1, 0}, 0.1), unit_camera(), 100, 100)) << "1.0 at a depth of 1.1";
  for (const dvec3& direction : {dvec3(0, 1, 0), dvec3(0, -1, 0), dvec3(0, 0, 1), dvec3(0, 0, -1)})
    EXPECT_TRUE(is_outside_view(cube(1.25 * direction, 0.1), unit_camera(), 100, 100)) << "1.15 at a depth of 1.1";
  EXPECT_TRUE(is_outside_view(cube({3, 0, 0}, 0.1), unit_camera(), 100, 100)) << "behind the eye";
}

TEST(IsOutsideView, IsFalseForABoxAroundTheView) {
  EXPECT_FALSE(is_outside_view(cube({0, 0, 0}, 5), unit_camera(), 100, 100));
  EXPECT_FALSE(is_inside_view(cube({0, 0, 0}, 5), unit_camera(), 100, 100));
}

TEST(SensorsAreOutsideView, NeedsAViewWithASize) {
  test::ToolScene ball({});
  EXPECT_FALSE(sensors_are_outside_view(*ball.app.viewer, *ball.app.shown)) << "in the middle of the view";
  ball.app.viewer->camera().target = {0, 1, 0};
  EXPECT_TRUE(sensors_are_outside_view(*ball.app.viewer, *ball.app.shown));
  ball.app.viewer->view.width = 0;
  EXPECT_FALSE(sensors_are_outside_view(*ball.app.viewer, *ball.app.shown)) << "before the view was drawn";
}

TEST(LookThroughNext, CyclesThroughTheCameras) {
  ThreeCameras three;
  for (const int camera : {0, 1, 2, 0}) {
    three.look(1);
    EXPECT_EQ(three.follow.camera, camera);
  }
  three.look(-1);
  EXPECT_EQ(three.follow.camera, 2);
  three.follow.camera = -1;
  three.look(-1);
  EXPECT_EQ(three.follow.camera, 2) << "backwards from the free camera";
}

TEST(LookThroughNext, RemembersOnlyTheFreeCamera) {
  ThreeCameras three;
  three.viewer.camera().azimuth_deg = 7;
  three.look(1);
  three.viewer.camera().azimuth_deg = 80;
  three.look(1);
  EXPECT_EQ(three.follow.free.azimuth_deg, 7);
  leave_followed(three.viewer, three.follow);
  EXPECT_EQ(three.viewer.camera().azimuth_deg, 7);
  EXPECT_EQ(three.follow.camera, -1);
}

TEST(FollowScene, LooksFromTheCameraOfTheScene) {
  ThreeCameras three;
  three.frame->mark_poses.cameras[1].p = {0.1, 0.2, 3};  // looks down: along its -z
  three.follow.camera = 1;
  three.follow.depth = 2;
  three.follow_frame();
  EXPECT_LT(glm::distance(three.viewer.camera().eye(), dvec3(0.1, 0.2, 3)), 1e-12);
  EXPECT_LT(glm::distance(three.viewer.camera().target, dvec3(0.1, 0.2, 1)), 1e-12);
  EXPECT_EQ(three.viewer.camera().fov_deg, 60);
}

TEST(FollowScene, ShowsTheHeightOfAnOrthographicCamera) {
  ThreeCameras three;
  three.follow.camera = 2;
  three.follow.depth = 1;  // 2 m high at a distance of 1 m: 45 degrees to each side
  three.follow_frame();
  EXPECT_NEAR(three.viewer.camera().fov_deg, 90, 1e-12);
  EXPECT_TRUE(three.viewer.camera().orthographic);
  three.look(1);
  three.follow_frame();
  EXPECT_FALSE(three.viewer.camera().orthographic) << "the next camera has a perspective";
}

TEST(FollowScene, LeavesACameraThatTheSceneDoesNotHave) {
  ThreeCameras three;
  three.follow.camera = 3;
  three.follow.free.azimuth_deg = 12;
  three.follow_frame();
  EXPECT_EQ(three.follow.camera, -1);
  EXPECT_EQ(three.viewer.camera().azimuth_deg, 12);
}

TEST(FollowScene, MovesTheTargetWithTheBody) {
  ThreeCameras three;
  three.viewer.camera().target = {1, 1, 1};
  three.follow.body = 1;
  three.follow.point_B = {0, 0, 0.5};
  three.follow.point_W = {0, 0, 0.5};
  three.frame->mark_poses.bodies[1].p = {0.1, 0, 0};
  three.follow_frame();
  three.follow_frame();
  EXPECT_LT(glm::distance(three.viewer.camera().target, dvec3(1.1, 1, 1)), 1e-12) << "once, not in every frame";
}

TEST(FollowText, NamesTheCameraOrTheBody) {
  ThreeCameras three;
  EXPECT_EQ(follow_text(three.viewer, three.shown.run, three.follow), "");
  three.follow.body = 1;
  EXPECT_EQ(follow_text(three.viewer, three.shown.run, three.follow), "Tracks arm   Esc frees");
  three.follow.camera = 1;
  EXPECT_EQ(follow_text(three.viewer, three.shown.run, three.follow), "Camera top   [ ] others, Esc frees");
  three.viewer.mode = Mode::layout;
  EXPECT_EQ(follow_text(three.viewer, three.shown.run, three.follow), "");
}

TEST(CanSelectParent, NeedsAParentOtherThanTheWorld) {
  ThreeCameras three;
  EXPECT_FALSE(can_select_parent(three.viewer, three.shown.run)) << "no body is selected";
  three.viewer.selection.body = 1;
  EXPECT_FALSE(can_select_parent(three.viewer, three.shown.run)) << "the arm is on the world";
  three.viewer.selection.body = 2;
  EXPECT_TRUE(can_select_parent(three.viewer, three.shown.run));
  three.viewer.selection.body = 3;
  EXPECT_FALSE(can_select_parent(three.viewer, three.shown.run)) << "the scene has no such body";
}

TEST(LookThroughCamera, ChoosesACameraAndKeepsTheViewOfTheUser) {
  ThreeCameras of;
  of.viewer.camera().azimuth_deg = 33;
  look_through(of.viewer, of.shown, of.follow, 2);
  EXPECT_EQ(of.follow.camera, 2);
  look_through(of.viewer, of.shown, of.follow, 1);
  EXPECT_EQ(of.follow.camera, 1);
  of.viewer.camera().azimuth_deg = 77;
  leave_followed(of.viewer, of.follow);
  EXPECT_EQ(of.follow.camera, -1);
  EXPECT_EQ(of.viewer.camera().azimuth_deg, 33);
}

TEST(ShowSceneFirst, TakesTheViewOfAFileThatSetsOne) {
  for (const bool own : {true, false}) {
    ThreeCameras of;
    SceneLook look;
    look.has_own_view = own;
    of.scene->look = std::make_shared<const SceneLook>(look);
    of.scene->marks.overview = {{1, 2, 3}, 4, 250, 20, 40};
    of.shown.document.is_scene = true;
    show_scene_first(of.viewer, of.shown, true);
    EXPECT_EQ(of.viewer.camera().target == dvec3(1, 2, 3), own);
    EXPECT_EQ(of.viewer.camera().elevation_deg == 20, own);
    if (own) {
      EXPECT_NEAR(of.viewer.camera().distance, 1.5 * 4, 1e-12) << "MuJoCo's free camera";
    }
  }
}

}  // namespace
}  // namespace taxel::ui
