// Shadows and ambient occlusion in the 3-D view.
#include <gtest/gtest.h>

#include "core/mesh/make/primitives.h"
#include "ui/scene/body_scene.h"
#include "ui/scene/finger_scene.h"
#include "ui/scene/passes/look.h"
#include "ui/scene/picture.h"

namespace taxel::ui {
namespace {

constexpr int kWidth = 640, kHeight = 480;
constexpr double kPlate = 0.03, kThin = 0.002, kRadius = 0.006,
                 kHover = 0.012;  // height of the ball over the plate

TriMesh plate() {
  return make_box({kPlate, kPlate, kThin});
}
dvec3 ball_center(double x = 0) {
  return {x - 0.006, 0.006, kHover};
}

Camera from_above() {
  Camera camera;
  camera.target = {0, 0, 0};
  camera.azimuth_deg = 100;
  camera.elevation_deg = 62;
  camera.distance = 0.11;
  return camera;
}

/// Returns the brightness of the pixel at a point, 0 to 255.
double brightness(const gl::RgbImage& image, const Camera& camera, const dvec3& p) {
  const auto pixel = test::pixel_at(image, dvec2(camera.project(p, kWidth, kHeight)));
  return (pixel[0] + pixel[1] + pixel[2]) / 3.0;
}

/// Returns the distance of the ball's centre from a line from p along `direction`, in radii of the ball.
double radii_from_ball(const dvec3& p, const dvec3& direction, const dvec3& center) {
  return glm::length(glm::cross(center - p, direction)) / kRadius;
}

/// Returns the source of a shader with shadows and ambient occlusion removed.
std::string without_shadows(const std::string& name) {
  if (name == "key_shadow.glsl") {
    return "const float key_offset = 0.0;\nuniform sampler2DShadow key_map;\n"
           "vec3 key_map_point(vec3 p_W, vec3 n) { return vec3(0.0); }\n"
           "float key_light_at(vec3 at, bool matters) { return 1.0; }\n";
  }
  return gl::read_embedded_shader(name);
}

/// With the effort of a software renderer, and with that of a GPU.
class LightTest : public ::testing::TestWithParam<RenderEffort> {
 protected:
  static void SetUpTestSuite() { test::context(); }
  LightTest() { renderer_.set_ambient_occlusion(false); }
  gl::RgbImage draw(const SceneInput& input, const Camera& camera = from_above()) {
    renderer_.render(input, camera, kWidth, kHeight);
    return renderer_.picture();
  }
  gl::RgbImage draw_unshaded(const SceneInput& input, const Camera& camera = from_above()) {
    SceneRenderer renderer(without_shadows, GetParam());
    renderer.set_ambient_occlusion(false);
    renderer.render(input, camera, kWidth, kHeight);
    return renderer.picture();
  }
  /// Calls `see(point, radii from the ball towards the light)` for points of the plate's top that the ball does not
  /// hide.
  template <class See>
  static void each_point(const dvec3& ball, const See& see) {
    const dvec3 light = glm::normalize(dvec3(look(true).key_direction));
    for (double x = -kPlate + 0.002; x < kPlate; x += 0.001) {
      for (double y = -kPlate + 0.002; y < kPlate; y += 0.001) {
        const dvec3 p(x, y, kThin);
        if (radii_from_ball(p, glm::normalize(from_above().eye() - p), ball) > 1.1)
          see(p, radii_from_ball(p, light, ball));
      }
    }
  }
  /// Expects the plate to be dark only where the ball is between the plate and the light.
  void expect_shadow_of_ball(const SceneInput& input, const dvec3& ball) {
    const gl::RgbImage shaded = draw(input), unshaded = draw_unshaded(input);
    int umbra = 0, lit = 0;
    each_point(ball, [&](const dvec3& p, double radii) {
      const double darker = brightness(unshaded, from_above(), p) - brightness(shaded, from_above(), p);
      if (radii < 0.8) {
        ++umbra;
        EXPECT_GT(darker, 25) << p.x << ' ' << p.y;
      } else if (radii > 1.25) {
        ++lit;
        EXPECT_LE(std::abs(darker), 1) << p.x << ' ' << p.y;
      }
    });
    EXPECT_GT(umbra, 30);
    EXPECT_GT(lit, 1000);
  }
  SceneRenderer renderer_{gl::read_embedded_shader, GetParam()};
};
INSTANTIATE_TEST_SUITE_P(Efforts, LightTest, ::testing::Values(RenderEffort::software, RenderEffort::gpu),
                         [](const auto& test) { return test.param == RenderEffort::gpu ? "Gpu" : "Software"; });

TEST_P(LightTest, CastsTheShadowOfABallAlongTheKeyLight) {
  const auto ball = std::make_shared<const TriMesh>(make_icosphere(kRadius, 4));
  const auto flat = std::make_shared<const TriMesh>(plate());
  for (const double x : {0.0, 0.01}) {  // the shadow follows the ball
    const SceneInput input = test::bodies({{flat, Pose{}}, {ball, {dquat(1, 0, 0, 0), ball_center(x)}}});
    expect_shadow_of_ball(input, ball_center(x));
    if (x == 0) test::write_picture("key_shadow", draw(input));
  }
}

TEST_P(LightTest, CastsTheShadowOfABodyOntoItself) {
  expect_shadow_of_ball(test::bodies({{test::joined(plate(), make_icosphere(kRadius, 4), ball_center()), Pose{}}}),
                        ball_center());
}

TEST_P(LightTest, DrawsSoftShadowEdges) {
  const auto ball = std::make_shared<const TriMesh>(make_icosphere(kRadius, 4));
  const SceneInput input =
      test::bodies({{std::make_shared<const TriMesh>(plate()), Pose{}}, {ball, {dquat(1, 0, 0, 0), ball_center()}}});
  Camera camera = from_above();
  camera.distance = 0.05;
  const gl::RgbImage image = draw(input, camera);
  const dvec3 light = glm::normalize(dvec3(look(true).key_direction));
  const dvec3 middle = ball_center() - (kHover - kThin) / light.z * light;
  double last = 0, largest_step = 0, darkest = 255, brightest = 0;
  for (double t = 0; t < 2 * kRadius; t += 0.00005) {  // from below the ball outward
    const double now = brightness(image, camera, middle + dvec3(-0.8 * t, -0.6 * t, 0));
    if (t > 0) {
      largest_step = std::max(largest_step, now - last);
      EXPECT_GT(now, last - 2) << t;
    }
    last = now;
    darkest = std::min(darkest, now);
    brightest = std::max(brightest, now);
  }
  EXPECT_GT(brightest - darkest, 25);
  EXPECT_LT(largest_step, 0.5 * (brightest - darkest));
}

TEST_P(LightTest, CastsNoShadowOfConvexBodiesOntoThemselves) {
  for (const auto& [name, mesh] : {std::pair{"ball", make_icosphere(0.02, 5)}, std::pair{"box", make_box(dvec3(0.015))},
                                   std::pair{"fingertip", make_fingertip()}}) {
    const SceneInput input = test::bodies({{std::make_shared<const TriMesh>(mesh), Pose{}}});
    for (const double azimuth : {-40.0, 50.0, 140.0}) {
      Camera camera = from_above();
      camera.azimuth_deg = azimuth;
      camera.elevation_deg = 30;
      camera.frame(mesh.bounds());
      const gl::RgbImage shaded = draw(input, camera), unshaded = draw_unshaded(input, camera);
      int somewhat = 0, much = 0;
      for (std::size_t i = 0; i < shaded.rgb.size(); ++i) {
        const int darker = unshaded.rgb[i] - shaded.rgb[i];
        somewhat += std::abs(darker) > 3 ? 1 : 0;
        much += std::abs(darker) > 14 ? 1 : 0;
      }
      const auto all = static_cast<double>(shaded.rgb.size());
      EXPECT_LT(somewhat, 0.004 * all) << name << ' ' << azimuth;  // where the light grazes the surface
      EXPECT_LT(much, 0.0006 * all) << name << ' ' << azimuth;
      test::write_picture(std::string("unshaded_") + name, shaded);
    }
  }
}

/// Returns the body with an invisible open triangle in its middle. The body is no longer closed, so all its faces are
/// drawn.
TriMeshPtr with_speck(const TriMesh& body) {
  std::vector<dvec3> vertices = body.vertices();
  std::vector<ivec3> faces = body.faces();
  const int first = body.vertex_count();
  for (const double angle : {0.0, 2.0, 4.0})
    vertices.push_back(glm::mix(body.vertices()[0], body.centroid(), 0.5) +
                       1e-5 * dvec3(std::cos(angle), std::sin(angle), 0));
  faces.emplace_back(first, first + 1, first + 2);
  return std::make_shared<const TriMesh>(std::move(vertices), std::move(faces));
}

/// Expects equal images except for some pixels where the light grazes the surface.
void expect_alike(const gl::RgbImage& a, const gl::RgbImage& b) {
  int other = 0, most = 0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) {
    other += a.rgb[i] != b.rgb[i] ? 1 : 0;
    most = std::max(most, std::abs(a.rgb[i] - b.rgb[i]));
  }
  EXPECT_LT(other, 0.002 * static_cast<double>(a.rgb.size()));
  EXPECT_LT(most, 30);
}

TEST_P(LightTest, DrawsClosedBodiesWithoutBackFacesAlike) {
  const TriMesh ball = make_icosphere(kRadius, 3), flat = plate();
  const Pose above{dquat(1, 0, 0, 0), ball_center()};
  const SceneInput closed =
      test::bodies({{std::make_shared<const TriMesh>(flat), Pose{}}, {std::make_shared<const TriMesh>(ball), above}});
  const SceneInput open = test::bodies({{with_speck(flat), Pose{}}, {with_speck(ball), above}});
  ASSERT_FALSE(with_speck(flat)->closed());
  Camera within = from_above();
  within.target = above.p;
  within.distance = 0.5 * kRadius;  // inside the ball
  for (const Camera& camera : {from_above(), within}) expect_alike(draw(closed, camera), draw(open, camera));
}

TEST_P(LightTest, DrawsClosedSensorsWithoutBackFacesAlike) {
  const SensorModelPtr closed = test::finger_model(300);
  const auto open = std::make_shared<SensorModel>(*closed);
  open->mesh = with_speck(*closed->mesh);
  const auto drawn = [&](const SensorModelPtr& model) {
    const SimFramePtr frame = test::finger_frame(closed, 0.01);
    auto scene = std::make_shared<SimScene>(*frame->scene);
    scene->sensors = {model};
    const auto shown = std::make_shared<SimFrame>(*frame);
    shown->scene = scene;
    SceneInput input = test::finger_input(shown);
    input.overlays.sensor_transparent = false;
    return draw(input, test::finger_camera());
  };
  expect_alike(drawn(closed), drawn(open));
}

/// Returns a box next to a taller one, like stairs.
TriMeshPtr step() {
  return test::joined(make_box({0.02, 0.02, 0.005}), make_box({0.01, 0.02, 0.01}), {-0.01, 0, 0.01});
}

TEST_P(LightTest, DarkensOnlyACreaseByAmbientOcclusion) {
  const SceneInput input = test::bodies({{step(), Pose{}}});
  Camera camera = from_above();
  camera.azimuth_deg = 60;
  camera.elevation_deg = 35;
  const gl::RgbImage without = draw(input, camera);
  renderer_.set_ambient_occlusion(true);
  const gl::RgbImage with = draw(input, camera);
  test::write_picture("occlusion_off", without);
  test::write_picture("occlusion_on", with);
  const double radius = 0.05 * step()->bounds().diagonal();
  const auto darker = [&](double x) {  // returns the darkening on the lower step at a distance x from the wall
    double sum = 0;
    for (double y = -0.012; y <= 0.012; y += 0.001)
      sum += brightness(without, camera, {x, y, 0.005}) - brightness(with, camera, {x, y, 0.005});
    return sum / 25;
  };
  EXPECT_GT(darker(0.15 * radius), 12);
  EXPECT_GT(darker(0.15 * radius), darker(0.5 * radius) + 4);
  EXPECT_NEAR(darker(1.8 * radius), 0, 0.5);
  for (const dvec2& at : {dvec2(3, 3), dvec2(kWidth - 3, 3), dvec2(kWidth / 2, 20)})
    EXPECT_EQ(test::pixel_at(with, at), test::pixel_at(without, at)) << "the background";
  renderer_.set_ambient_occlusion(false);
  EXPECT_EQ(draw(input, camera), without);
}

TEST_P(LightTest, LeavesAFlatPlateUnchangedByAmbientOcclusion) {
  const SceneInput input = test::bodies({{std::make_shared<const TriMesh>(plate()), Pose{}}});
  for (const double elevation : {20.0, 45.0, 80.0}) {
    Camera camera = from_above();
    camera.elevation_deg = elevation;
    renderer_.set_ambient_occlusion(false);
    const gl::RgbImage without = draw(input, camera);
    renderer_.set_ambient_occlusion(true);
    const gl::RgbImage with = draw(input, camera);
    int changed = 0;
    for (std::size_t i = 0; i < with.rgb.size(); ++i) changed += std::abs(with.rgb[i] - without.rgb[i]) > 1 ? 1 : 0;
    const int at_its_edge = GetParam() == RenderEffort::gpu ? 1 : 0;  // multisampling rounds
    EXPECT_LE(changed, at_its_edge) << elevation;
  }
}

TEST_P(LightTest, LeavesPressuresAndSamplesUnchangedByAmbientOcclusion) {
  const SensorModelPtr model = test::finger_model(1500);
  SceneInput input = test::finger_input(test::finger_frame(model, 0.003));
  const Camera camera = test::finger_camera();
  const gl::RgbImage without = draw(input, camera);
  renderer_.set_ambient_occlusion(true);
  const gl::RgbImage with = draw(input, camera);
  const SensorStep& state = input.frame->sensors[0];
  int compared = 0;
  for (const ContactPolygon& polygon : state.surfaces[0].polygons) {
    const dvec2 at(camera.project(state.X_WM * polygon.centroid, kWidth, kHeight));
    EXPECT_EQ(test::pixel_at(with, at), test::pixel_at(without, at));
    ++compared;
  }
  EXPECT_GT(compared, 100);
}

}  // namespace
}  // namespace taxel::ui
