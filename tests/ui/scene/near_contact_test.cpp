// Surfaces next to a contact: the object is partly transparent there, and the skin, which looks like silicone, gets
// less light.
#include <gtest/gtest.h>

#include "core/mesh/make/primitives.h"
#include "ui/scene/finger_view.h"
#include "ui/scene/passes/look.h"
#include "ui/scene/scene_parts.h"

namespace taxel::ui {
namespace {

int channels_of(const std::array<int, 3>& pixel) {
  return pixel[0] + pixel[1] + pixel[2];
}

class NearContact : public FingerView {
 protected:
  /// Returns the finger on the box without marks and without the contact surface.
  static SceneInput bare(bool transparent) {
    auto frame = std::make_shared<SimFrame>(*frame_);
    frame->sensors[0].force_W = dvec3(0);
    SceneInput input = test::finger_input(frame);
    Overlays& show = input.overlays;
    show.rays = show.contact_surface = show.samples = show.taxels = show.taxel_labels = show.receptive_fields =
        show.path = show.grid = false;
    show.sensor_transparent = transparent;
    return input;
  }
  static SceneInput without_contact(SceneInput input) {
    auto frame = std::make_shared<SimFrame>(*input.frame);
    frame->sensors[0].surfaces.clear();
    input.frame = frame;
    return input;
  }
  /// Returns the camera that sees the side of the box below its edge.
  static Camera at_side() {
    Camera camera = from_above();
    camera.azimuth_deg = -160;
    camera.elevation_deg = -8;
    camera.distance = 0.05;
    return camera;
  }
};

TEST_F(NearContact, HasASphereAroundEachContact) {
  const SceneInput input = bare(false);
  const std::vector<glm::vec4> spheres = contact_spheres(input, 8);
  ASSERT_EQ(spheres.size(), 1U);
  const SensorStep& state = input.frame->sensors[0];
  for (const dvec3& p : state.surfaces[0].vertices)
    EXPECT_LE(glm::distance(state.X_WM * p, dvec3(spheres[0])), 1.001 * static_cast<double>(spheres[0].w));
  EXPECT_LT(spheres[0].w, 0.01f);
  EXPECT_TRUE(contact_spheres(input, 0).empty());
  EXPECT_TRUE(contact_spheres(without_contact(input), 8).empty());
}

TEST_F(NearContact, DrawsTheObjectTransparentThereOnly) {
  const SceneInput input = bare(false);
  SceneInput alone = input;
  alone.overlays.geom_groups = {};
  const Camera camera = at_side();
  const gl::RgbImage mixed = draw(input, camera), opaque = draw(without_contact(input), camera),
                     skin = draw(alone, camera);
  test::write_picture("near_contact", mixed);
  const glm::vec4 sphere = contact_spheres(input, 1).at(0);
  int near = 0, mixed_well = 0, far = 0, changed = 0;
  for (int y = 0; y < kHeight; y += 2)
    for (int x = 0; x < kWidth; x += 2) {
      const dvec2 at(x + 0.5, y + 0.5);
      const Ray ray = camera.pixel_ray(at.x, at.y, kWidth, kHeight);
      const std::optional<GeomHit> hit = cast_geoms(input, ray);
      if (!hit) continue;
      const dvec3 p_W = ray.origin + hit->t * ray.direction;
      const double away = glm::distance(p_W, dvec3(sphere)) / sphere.w;
      const auto skin_hit = model_->skin->cast(in_frame(input.frame->sensors[0].X_WM, ray));
      if (away > 2.1 && std::abs(p_W.z) > 1e-3) {
        ++far;
        changed += test::pixel_at(mixed, at) != test::pixel_at(opaque, at) ? 1 : 0;
      }
      if (away > 0.9 || !skin_hit || skin_hit->t < hit->t + 3e-4) continue;
      ++near;  // 60 % of the skin inside the box, and 40 % of the box, which gets at least 0.6 of its light here
      const double box = (channels_of(test::pixel_at(mixed, at)) - 0.6 * channels_of(test::pixel_at(skin, at))) /
                         channels_of(test::pixel_at(opaque, at));
      mixed_well += box > 0.4 * 0.6 - 0.04 && box < 0.4 + 0.04 ? 1 : 0;
    }
  EXPECT_GT(near, 50);
  EXPECT_GT(mixed_well, 0.95 * near) << "all but outlines";
  EXPECT_GT(far, 5000);
  EXPECT_EQ(changed, 0) << "opaque two radii of the contact away";
}

TEST_F(NearContact, ShowsTheContactThroughTheObject) {
  SceneInput input = bare(true);
  const Camera camera = at_side();
  const gl::RgbImage without = draw(input, camera);
  input.overlays.contact_surface = true;
  const gl::RgbImage with = draw(input, camera);
  const SensorStep& state = input.frame->sensors[0];
  int exact = 0;
  for (const ContactPolygon& polygon : state.surfaces[0].polygons) {
    const dvec2 at(camera.project(state.X_WM * polygon.centroid, kWidth, kHeight));
    if (test::pixel_at(with, at) != test::pixel_at(without, at)) ++exact;
  }
  EXPECT_GT(exact, static_cast<int>(state.surfaces[0].polygons.size()) / 3) << "polygons seen through the box";
}

TEST_F(NearContact, DarkensTheSkin) {
  const SceneInput input = bare(false);
  const Camera camera = at_side();
  const gl::RgbImage touching = draw(input, camera), apart = draw(without_contact(input), camera);
  const glm::vec4 sphere = contact_spheres(input, 1).at(0);
  const SensorStep& state = input.frame->sensors[0];
  double near = 0, far = 0;
  int near_count = 0, far_count = 0;
  for (int y = 0; y < kHeight; y += 3)
    for (int x = 0; x < kWidth; x += 3) {
      const Ray ray = camera.pixel_ray(x + 0.5, y + 0.5, kWidth, kHeight);
      const auto hit = model_->skin->cast(in_frame(state.X_WM, ray));
      const std::optional<GeomHit> box = cast_geoms(input, ray);
      if (!hit || (box && box->t < hit->t)) continue;
      const double away = glm::distance(ray.origin + hit->t * ray.direction, dvec3(sphere)) / sphere.w;
      const dvec2 at(x + 0.5, y + 0.5);
      const double ratio = double(channels_of(test::pixel_at(touching, at))) / channels_of(test::pixel_at(apart, at));
      if (away < 1.2) near += ratio, ++near_count;
      if (away > 2.2) far += ratio, ++far_count;
    }
  ASSERT_GT(near_count, 20);
  ASSERT_GT(far_count, 500);
  EXPECT_LT(near / near_count, 0.9);
  EXPECT_NEAR(far / far_count, 1, 0.01);
}

TEST(Silicone, HasASoftHighlightTowardsTheLight) {
  test::context();
  auto ball = std::make_shared<SensorModel>();
  ball->mesh = std::make_shared<const TriMesh>(make_icosphere(0.02, 5));
  ball->skin = std::make_shared<const MeshIndex>(ball->mesh);
  SceneInput input;
  input.document_model = ball;
  input.overlays.sensor_transparent = input.overlays.grid = false;
  Camera camera;
  camera.azimuth_deg = -60;
  camera.elevation_deg = 10;
  camera.distance = 0.1;
  SceneRenderer renderer;
  for (const bool dark : {true, false}) {
    input.dark = dark;
    renderer.render(input, camera, 400, 400);
    const gl::RgbImage image = renderer.picture();
    test::write_picture(dark ? "silicone_dark" : "silicone_light", image);
    const dvec3 light = glm::normalize(dvec3(look(dark).key_direction)), eye = glm::normalize(camera.eye());
    const dvec3 half = glm::normalize(light + eye);
    const auto brightness = [&](const dvec3& n) {
      return channels_of(test::pixel_at(image, dvec2(camera.project(0.02 * glm::normalize(n), 400, 400))));
    };
    const dvec3 aside = glm::normalize(glm::cross(half, light));
    EXPECT_GT(brightness(half), brightness(glm::normalize(half + 0.7 * aside)) + 40) << "the highlight";
    EXPECT_GT(brightness(glm::normalize(half + 0.2 * aside)), brightness(glm::normalize(half + 0.45 * aside)) + 10)
        << "fades softly";
    EXPECT_LT(brightness(half), 3 * 252) << "is not cut off";
  }
}

}  // namespace
}  // namespace taxel::ui
