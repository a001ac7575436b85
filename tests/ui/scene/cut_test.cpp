// The cap of bodies that the clip plane cuts open.
#include <gtest/gtest.h>

#include "core/mesh/make/primitives.h"
#include "ui/scene/body_scene.h"
#include "ui/scene/finger_scene.h"
#include "ui/scene/passes/passes.h"
#include "ui/scene/picture.h"

namespace taxel::ui {
namespace {

constexpr int kWidth = 640, kHeight = 480;

/// Returns a scene with one solid body, cut by the plane x = 0. The part at x > 0, towards the eye, is removed.
SceneInput cut_body(const TriMeshPtr& mesh) {
  SceneInput input = test::bodies({{mesh, Pose{}}});
  input.clip = ClipPlane{{1, 0, 0}, 0};
  return input;
}

Camera facing_the_cut() {
  Camera camera;
  camera.target = {0, 0, 0};
  camera.azimuth_deg = 25;
  camera.elevation_deg = 20;
  camera.distance = 0.14;
  return camera;
}

/// Returns the distance of a pixel's colour from the colours between fill and hatching, in levels of 255.
double off_the_cap(const std::array<int, 3>& pixel, const CutColors& cap) {
  const glm::vec3 p = glm::vec3(pixel[0], pixel[1], pixel[2]) / 255.0f, along = cap.line - cap.fill;
  const float part = std::clamp(glm::dot(p - cap.fill, along) / glm::dot(along, along), 0.0f, 1.0f);
  return 255.0 * glm::length(p - cap.fill - part * along);
}

class CutTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() { test::context(); }
  gl::RgbImage draw(const SceneInput& input, const Camera& camera) {
    renderer_.render(input, camera, kWidth, kHeight);
    return renderer_.picture();
  }
  /// Grid points of the cut for which `kind` returns `which`: their number, and the number of them drawn as cap.
  struct Count {
    int points = 0, capped = 0;
  };
  template <class Kind>
  static Count count(const gl::RgbImage& image, const Camera& camera, const SceneInput& input, const Kind& kind,
                     int which) {
    const CutColors cap =
        cut_colors(linear_from_srgb({test::kBodyColor[0], test::kBodyColor[1], test::kBodyColor[2]}), look(input.dark));
    Count out;
    for (double y = -0.0475; y < 0.05; y += 0.0025) {
      for (double z = -0.0475; z < 0.05; z += 0.0025) {
        if (kind(y, z) != which) continue;
        const dvec3 at = camera.project({0, y, z}, kWidth, kHeight);
        if (at.x < 0 || at.y < 0 || at.x >= kWidth || at.y >= kHeight) continue;
        ++out.points;
        out.capped += off_the_cap(test::pixel_at(image, dvec2(at)), cap) < 3 ? 1 : 0;
      }
    }
    return out;
  }
  SceneRenderer renderer_;
};

TEST_F(CutTest, FillsTheCutExceptForCavities) {
  const SceneInput input = cut_body(test::joined(make_box(dvec3(0.03)), make_icosphere(0.018, 4), {0, 0.005, 0}, true));
  const Camera camera = facing_the_cut();
  const gl::RgbImage image = draw(input, camera);
  test::write_picture("cut_with_cavity", image);
  enum { neither, material, cavity, outside };
  const auto kind = [](double y, double z) {  // Omits 1 mm around every edge, where lines are drawn.
    const double r = std::hypot(y - 0.005, z), side = std::max(std::abs(y), std::abs(z));
    return r < 0.017 ? cavity : side > 0.031 ? outside : r > 0.019 && side < 0.029 ? material : neither;
  };
  const Count filled = count(image, camera, input, kind, material);
  EXPECT_GT(filled.points, 200);
  EXPECT_EQ(filled.capped, filled.points);
  for (const int empty : {cavity, outside}) {
    const Count none = count(image, camera, input, kind, empty);
    EXPECT_GT(none.points, 80);
    EXPECT_LT(none.capped, none.points / 10) << empty;  // the lit wall behind has the cap's colour at some points
  }
}

TEST_F(CutTest, FillsOverlappingShellsAsOneArea) {
  const auto box = make_box(dvec3(0.02));
  const SceneInput input = cut_body(test::joined(box, box, {0, 0.015, 0.015}));
  const Camera camera = facing_the_cut();
  const gl::RgbImage image = draw(input, camera);
  test::write_picture("cut_of_overlap", image);
  const auto kind = [](double y, double z) {
    const auto within = [](double a, double b) { return std::max(std::abs(a), std::abs(b)) < 0.0195; };
    return within(y, z) && within(y - 0.015, z - 0.015) ? 2 : 0;
  };
  const Count overlap = count(image, camera, input, kind, 2);
  EXPECT_GT(overlap.points, 60);
  EXPECT_GE(overlap.capped, overlap.points - 12);  // a line is drawn where the shells end inside each other
}

TEST_F(CutTest, DrawsNoCapForAnOpenMesh) {
  const TriMesh box = make_box(dvec3(0.03));
  std::vector<ivec3> faces = box.faces();
  std::erase_if(faces, [&](const ivec3& f) {  // the side at y = +0.03
    return std::min({box.vertices()[static_cast<std::size_t>(f.x)].y, box.vertices()[static_cast<std::size_t>(f.y)].y,
                     box.vertices()[static_cast<std::size_t>(f.z)].y}) > 0;
  });
  ASSERT_EQ(faces.size(), 10u);
  const SceneInput input = cut_body(std::make_shared<const TriMesh>(box.vertices(), faces));
  const Camera camera = facing_the_cut();
  const gl::RgbImage image = draw(input, camera);
  const auto kind = [](double y, double z) { return std::max(std::abs(y), std::abs(z)) < 0.028 ? 1 : 0; };
  const Count inside = count(image, camera, input, kind, 1);
  EXPECT_GT(inside.points, 200);
  EXPECT_LT(inside.capped, inside.points / 10);
}

TEST_F(CutTest, MovesTheCapWithPlaneAndBody) {
  SceneInput input = cut_body(std::make_shared<const TriMesh>(make_box(dvec3(0.03))));
  const Camera camera = facing_the_cut();
  const auto kind = [](double y, double z) {
    return std::max(std::abs(y), std::abs(z)) < 0.028 ? 1 : std::abs(z) > 0.032 && std::abs(y) < 0.028 ? 2 : 0;
  };
  SceneInput whole = input;
  whole.clip.reset();
  const gl::RgbImage before = draw(whole, camera);
  const gl::RgbImage cut = draw(input, camera);
  EXPECT_LT(count(before, camera, input, kind, 1).capped, 20);
  EXPECT_EQ(count(cut, camera, input, kind, 1).capped, count(cut, camera, input, kind, 1).points);
  EXPECT_EQ(count(cut, camera, input, kind, 2).capped, 0);
  auto moved = std::make_shared<SimFrame>(*input.frame);
  moved->geom_poses[0].p.z = 0.02;
  input.frame = moved;
  EXPECT_GT(count(draw(input, camera), camera, input, kind, 2).capped, 50);
  input.clip->offset = 0.2;  // beyond the body
  EXPECT_LT(count(draw(input, camera), camera, input, kind, 1).capped, 20);
  EXPECT_EQ(draw(whole, camera), before);
}

TEST_F(CutTest, KeepsTheContactInsideWhole) {
  const SensorModelPtr model = test::finger_model(3000);
  SceneInput input = test::finger_input(test::finger_frame(model, 0.003));
  input.overlays = {};
  input.overlays.taxels = input.overlays.rays = input.overlays.samples = input.overlays.path = false;
  input.overlays.receptive_fields = false;
  Camera camera = test::finger_camera();
  camera.distance = 0.05;
  const auto force_free = [&] {
    auto frame = std::make_shared<SimFrame>(*input.frame);
    frame->sensors[0].force_W = dvec3(0);
    return frame;
  };
  input.frame = force_free();
  const gl::RgbImage whole = draw(input, camera);
  const dvec3 towards = glm::normalize(dvec3(0, -1, 0.2));
  input.clip = ClipPlane{towards, glm::dot(towards, camera.target) + 0.001};
  for (const bool transparent : {true, false}) {
    input.overlays.sensor_transparent = transparent;
    const gl::RgbImage image = draw(input, camera);
    test::write_picture(transparent ? "cut_finger" : "cut_finger_solid", image);
    int compared = 0, same = 0;
    const SensorStep& state = input.frame->sensors[0];
    for (const ContactPolygon& polygon : state.surfaces[0].polygons) {
      const dvec3 p = state.X_WM * polygon.centroid;
      const dvec2 at(camera.project(p, kWidth, kHeight));
      const auto now = test::pixel_at(image, at), then = test::pixel_at(whole, at);
      ++compared;
      same += now == then ? 1 : 0;
    }
    EXPECT_GT(compared, 100);
    EXPECT_GT(same, compared * 9 / 10) << transparent;
  }
}

}  // namespace
}  // namespace taxel::ui
