// The renderer of the 3-D view: colours, overlays, transparency, sizes and errors of shaders.
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "ui/scene/color_map.h"
#include "ui/scene/finger_view.h"
#include "ui/scene/picture.h"
#include "ui/scene/scene_parts.h"

namespace taxel::ui {
namespace {

Overlays nothing() {
  Overlays o;
  o.rays = o.contact_surface = o.samples = o.taxels = o.taxel_labels = o.receptive_fields = o.path = o.grid = false;
  return o;
}

int largest_difference(const std::array<int, 3>& pixel, const glm::vec3& color) {
  int worst = 0;
  for (int i = 0; i < 3; ++i) {
    worst =
        std::max(worst, std::abs(pixel[static_cast<std::size_t>(i)] - static_cast<int>(std::lround(255 * color[i]))));
  }
  return worst;
}

int pixels_changed(const gl::RgbImage& a, const gl::RgbImage& b) {
  int count = 0;
  for (std::size_t i = 0; i < a.rgb.size(); i += 3) {
    count +=
        std::equal(a.rgb.begin() + static_cast<std::ptrdiff_t>(i), a.rgb.begin() + static_cast<std::ptrdiff_t>(i + 3),
                   b.rgb.begin() + static_cast<std::ptrdiff_t>(i))
            ? 0
            : 1;
  }
  return count;
}

/// Returns whether p is inside the polygon, seen along its normal.
bool inside(const ContactSurface& surface, const ContactPolygon& polygon, const dvec3& p) {
  for (int i = 0; i < polygon.count; ++i) {
    const dvec3& a = surface.vertices[static_cast<std::size_t>(polygon.first + i)];
    const dvec3& b = surface.vertices[static_cast<std::size_t>(polygon.first + (i + 1) % polygon.count)];
    if (glm::dot(glm::cross(b - a, p - a), polygon.normal) < 0) return false;
  }
  return true;
}

/// Returns whether no other polygon is in front of this one on the ray, and none is seen almost edge-on.
bool is_first(const ContactSurface& surface, const ContactPolygon& polygon, const Ray& ray, double t) {
  for (const ContactPolygon& other : surface.polygons) {
    const double slope = glm::dot(ray.direction, other.normal);
    const double t_other = glm::dot(other.centroid - ray.origin, other.normal) / slope;
    if (&other != &polygon && t_other < t && inside(surface, other, ray.origin + t_other * ray.direction)) return false;
  }
  return std::abs(glm::dot(ray.direction, polygon.normal)) > 0.2;
}

/// Compares the pixel at each projected polygon with the colour of the pressure at the centre of the pixel.
struct ContactCheck {
  int compared = 0, worst = 0;
};
ContactCheck check_contact(const SceneInput& input, const Camera& camera, const gl::RgbImage& image) {
  ContactCheck out;
  const SensorStep& state = input.frame->sensors[0];
  const ContactSurface& surface = state.surfaces[0];
  for (const ContactPolygon& polygon : surface.polygons) {
    const dvec3 projected = camera.project(state.X_WM * polygon.centroid, image.width, image.height);
    const dvec2 middle(std::floor(projected.x) + 0.5, std::floor(projected.y) + 0.5);
    if (middle.x < 0 || middle.y < 0 || middle.x >= image.width || middle.y >= image.height) continue;
    const Ray ray = in_frame(state.X_WM, camera.pixel_ray(middle.x, middle.y, image.width, image.height));
    const double t = glm::dot(polygon.centroid - ray.origin, polygon.normal) / glm::dot(ray.direction, polygon.normal);
    const dvec3 p = ray.origin + t * ray.direction;
    if (!inside(surface, polygon, p) || !is_first(surface, polygon, ray, t)) continue;
    const double pressure = polygon.pressure + glm::dot(polygon.gradient, p - polygon.centroid);
    ++out.compared;
    out.worst = std::max(out.worst, largest_difference(test::pixel_at(image, middle), input.range.color(pressure)));
  }
  return out;
}

class SceneRendererTest : public FingerView {};

TEST_F(SceneRendererTest, DrawsAPolygonInTheColourOfItsPressure) {
  SceneInput input = test::finger_input(frame_);
  input.overlays = nothing();
  input.overlays.contact_surface = true;
  auto frame = std::make_shared<SimFrame>(*frame_);
  frame->sensors[0].force_W = dvec3(0);  // no arrow in front of the polygons
  input.frame = frame;
  const ContactCheck alone = check_contact(input, from_above(), draw(input, from_above()));
  EXPECT_GT(alone.compared, 150);
  EXPECT_LE(alone.worst, 1);
  Camera orthographic = from_above();
  orthographic.orthographic = true;
  const ContactCheck parallel = check_contact(input, orthographic, draw(input, orthographic));
  EXPECT_GT(parallel.compared, 150);
  EXPECT_LE(parallel.worst, 1) << "without perspective";
  // The skin in front of the contact, rays and samples must not tint it.
  input.overlays = Overlays{};
  input.overlays.taxels = input.overlays.path = false;
  const gl::RgbImage image = draw(input, from_above());
  test::write_picture("contact_from_above", image);
  const ContactCheck with_all = check_contact(input, from_above(), image);
  EXPECT_EQ(with_all.compared, alone.compared);
  EXPECT_LE(with_all.worst, 1);
}

TEST_F(SceneRendererTest, DrawsTheContactInTheMapOfItsRange) {
  std::array<Rgb8, 256> table{};
  for (std::size_t i = 0; i < table.size(); ++i) table[i] = {static_cast<std::uint8_t>(255 - i), 0, 128};
  const ColorMap falling{"falling", "Falling", table};
  SceneInput input = test::finger_input(frame_);
  input.overlays = nothing();
  input.overlays.contact_surface = true;
  auto frame = std::make_shared<SimFrame>(*frame_);
  frame->sensors[0].force_W = dvec3(0);  // no arrow in front of the contact
  input.frame = frame;
  const ColorMap* usual = input.range.colors;
  for (const ColorMap* map : {&falling, usual}) {
    input.range.colors = map;
    const ContactCheck check = check_contact(input, from_above(), draw(input, from_above()));
    EXPECT_GT(check.compared, 150) << map->word;
    EXPECT_LE(check.worst, 1) << map->word;
  }
}

TEST_F(SceneRendererTest, ClampsPressuresOutsideTheRangeOfColours) {
  SceneInput input = test::finger_input(frame_);
  input.overlays = nothing();
  input.overlays.contact_surface = true;
  auto frame = std::make_shared<SimFrame>(*frame_);
  frame->sensors[0].force_W = dvec3(0);
  input.frame = frame;
  input.range = {0.2 * input.range.hi, 0.5 * input.range.hi, false};
  EXPECT_LE(check_contact(input, from_above(), draw(input, from_above())).worst, 1);
}

TEST_F(SceneRendererTest, ShowsTheContactThroughTransparentSkinOnly) {
  SceneInput input = test::finger_input(frame_);
  input.overlays = nothing();
  input.overlays.contact_surface = true;
  auto frame = std::make_shared<SimFrame>(*frame_);
  frame->sensors[0].force_W = dvec3(0);
  input.frame = frame;
  input.overlays.sensor_transparent = false;
  Camera above = from_above();
  above.elevation_deg = 80;
  EXPECT_GT(check_contact(input, above, draw(input, above)).worst, 50);
  input.overlays.sensor_transparent = true;
  EXPECT_LE(check_contact(input, above, draw(input, above)).worst, 1);
  // Far from the contact, the box is opaque: from below, the contact does not shine through.
  Camera below = from_above();
  below.elevation_deg = -85;
  below.distance = 0.2;
  EXPECT_GT(check_contact(input, below, draw(input, below)).worst, 50);
}

TEST_F(SceneRendererTest, ShowsTheBackgroundThroughTransparentSkinOnly) {
  SceneInput input;
  input.document_model = model_;
  input.overlays = nothing();
  Camera camera;
  camera.frame(model_->mesh->bounds());
  const dvec2 middle(0.5 * kWidth, 0.5 * kHeight);
  const auto dark_minus_light = [&](bool transparent) {
    input.overlays.sensor_transparent = transparent;
    input.dark = true;
    const auto dark = test::pixel_at(draw(input, camera), middle);
    input.dark = false;
    const auto light = test::pixel_at(draw(input, camera), middle);
    return light[1] - dark[1];
  };
  EXPECT_GT(dark_minus_light(true), dark_minus_light(false) + 40);
}

TEST_F(SceneRendererTest, DrawsASampleInTheColourOfItsTaxel) {
  const auto sparse = test::finger_model(1500);
  SceneInput input;
  input.document_model = sparse;
  input.overlays = nothing();
  input.overlays.samples = true;
  Camera camera;
  camera.frame(sparse->mesh->bounds());
  camera.azimuth_deg = -75;
  for (const bool transparent : {true, false}) {
    input.overlays.sensor_transparent = transparent;
    const gl::RgbImage image = draw(input, camera);
    test::write_picture(transparent ? "samples" : "samples_on_solid_skin", image);
    int compared = 0;
    for (std::size_t i = 0; i < sparse->samples.size(); ++i) {
      const SurfaceSample& sample = sparse->samples[i];
      const dvec3 to_eye = glm::normalize(camera.eye() - sample.position);
      if (sparse->taxels_of_sample[i].empty() || glm::dot(sample.normal, to_eye) < 0.3) continue;
      ++compared;
      const auto pixel = test::pixel_at(image, dvec2(camera.project(sample.position, kWidth, kHeight)));
      EXPECT_EQ(largest_difference(pixel, taxel_color(sparse->taxels_of_sample[i].front())), 0) << "sample " << i;
    }
    EXPECT_GT(compared, 150);
  }
}

class SceneRendererIn : public SceneRendererTest, public ::testing::WithParamInterface<bool> {};
INSTANTIATE_TEST_SUITE_P(Projections, SceneRendererIn, ::testing::Bool());

TEST_P(SceneRendererIn, DrawsTheCentreOfATaxelInItsColour) {
  SceneInput input;
  input.document_model = model_;
  Camera camera;
  camera.frame(model_->mesh->bounds());
  camera.azimuth_deg = -90;
  camera.orthographic = GetParam();
  const gl::RgbImage image = draw(input, camera);
  test::write_picture(GetParam() ? "layout_orthographic" : "layout", image);
  int compared = 0;
  for (int k = 0; k < model_->taxel_count(); ++k) {
    const Taxel& taxel = model_->layout.taxels[static_cast<std::size_t>(k)];
    if (glm::dot(taxel.normal, glm::normalize(camera.eye() - taxel.center)) < 0.2) continue;
    ++compared;
    const auto pixel = test::pixel_at(image, dvec2(camera.project(taxel.center, kWidth, kHeight)));
    EXPECT_EQ(largest_difference(pixel, taxel_color(k)), 0) << "taxel " << k;
  }
  EXPECT_GE(compared, 6);
}

TEST_F(SceneRendererTest, DrawsEveryOverlay) {
  const SceneInput all = [&] {
    SceneInput input = test::finger_input(frame_);
    input.overlays.contact_edges = input.overlays.sample_normals = input.overlays.wireframe = true;
    input.overlays.sensor_transparent = true;
    return input;
  }();
  Camera camera = test::finger_camera();
  camera.distance = 0.06;
  const gl::RgbImage whole = draw(all, camera);
  test::write_picture("everything", whole);
  const std::vector<std::pair<const char*, bool Overlays::*>> parts{
      {"sensor_transparent", &Overlays::sensor_transparent},
      {"wireframe", &Overlays::wireframe},
      {"rays", &Overlays::rays},
      {"contact_surface", &Overlays::contact_surface},
      {"contact_edges", &Overlays::contact_edges},
      {"samples", &Overlays::samples},
      {"sample_normals", &Overlays::sample_normals},
      {"taxels", &Overlays::taxels},
      {"receptive_fields", &Overlays::receptive_fields},
      {"path", &Overlays::path},
      {"grid", &Overlays::grid},
      {"all_rays", &Overlays::all_rays}};
  for (const auto& [name, member] : parts) {
    SceneInput input = all;
    input.overlays.*member = !(input.overlays.*member);
    EXPECT_GT(pixels_changed(whole, draw(input, camera)), 60) << name;
  }
  SceneInput input = all;
  input.selected_taxel = 3;
  EXPECT_GT(pixels_changed(whole, draw(input, camera)), 200);
}

TEST_F(SceneRendererTest, OutlinesFilteredPolygonsInTheColourOfTheReason) {
  auto frame = std::make_shared<SimFrame>(*frame_);
  ContactSurface& surface = frame->sensors[0].surfaces[0];
  surface.filtered.clear();
  surface.filtered_vertices.clear();
  const auto add = [&](Rejection reason, const ContactPolygon& like) {
    surface.filtered.push_back({reason, static_cast<int>(surface.filtered_vertices.size()), like.count});
    for (int i = 0; i < like.count; ++i)
      surface.filtered_vertices.push_back(surface.vertices[static_cast<std::size_t>(like.first + i)]);
  };
  for (std::size_t i = 0; i < surface.polygons.size(); i += 5)
    add(i % 2 == 0 ? Rejection::sliver : Rejection::touching, surface.polygons[i]);
  SceneInput input = test::finger_input(frame);
  Camera camera = test::finger_camera();
  camera.distance = 0.06;
  const gl::RgbImage without = draw(input, camera);
  EXPECT_EQ(without, draw(test::finger_input(frame_), camera));  // off by default
  input.overlays.filtered_polygons = true;
  const gl::RgbImage with = draw(input, camera);
  test::write_picture("filtered", with);
  const auto count = [](const gl::RgbImage& image, const glm::vec3& color) {
    int found = 0;
    for (std::size_t i = 0; i + 2 < image.rgb.size(); i += 3) {
      bool same = true;
      for (std::size_t k = 0; k < 3; ++k)
        same = same && std::abs(image.rgb[i + k] - 255.0f * color[static_cast<int>(k)]) <= 2;
      found += same ? 1 : 0;
    }
    return found;
  };
  for (const Rejection reason : {Rejection::sliver, Rejection::touching}) {
    EXPECT_GT(count(with, rejection_color(reason)), 20) << to_string(reason);
    EXPECT_EQ(count(without, rejection_color(reason)), 0) << to_string(reason);
  }
}

TEST_F(SceneRendererTest, GivesTheSameBytesForTheSameInput) {
  const SceneInput input = test::finger_input(frame_);
  const Camera camera = test::finger_camera();
  const gl::RgbImage first = draw(input, camera);
  test::write_picture("sweep_dark", first);
  Camera other = camera;
  other.orbit(90, 20);
  SceneInput light = input;
  light.dark = false;
  test::write_picture("sweep_light", draw(light, camera));
  EXPECT_GT(pixels_changed(first, draw(input, other)), 10000);
  EXPECT_EQ(draw(input, camera), first);  // nothing remains of the images in between
  SceneRenderer fresh;
  fresh.render(input, camera, kWidth, kHeight);
  EXPECT_EQ(fresh.picture(), first);
}

/// Returns the mean difference between the levels of an image and those of one twice as large, four pixels for one.
double difference_to_half(const gl::RgbImage& picture, const gl::RgbImage& twice) {
  const auto level = [](const gl::RgbImage& image, int x, int y, int k) {
    return static_cast<double>(image.rgb[static_cast<std::size_t>(3 * (y * image.width + x) + k)]);
  };
  double sum = 0;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      for (int k = 0; k < 3; ++k) {
        const double half = 0.25 * (level(twice, 2 * x, 2 * y, k) + level(twice, 2 * x + 1, 2 * y, k) +
                                    level(twice, 2 * x, 2 * y + 1, k) + level(twice, 2 * x + 1, 2 * y + 1, k));
        sum += std::abs(half - level(picture, x, y, k));
      }
    }
  }
  return sum / (3.0 * picture.width * picture.height);
}

TEST_F(SceneRendererTest, DrawsEverythingTwiceAsLargeAtTwiceTheScale) {
  SceneInput input = test::finger_input(frame_);
  const Camera camera = test::finger_camera();
  const gl::RgbImage once = draw(input, camera);
  renderer_.render(input, camera, 2 * kWidth, 2 * kHeight);
  const double thin = difference_to_half(once, renderer_.picture());
  input.scale = 2;
  renderer_.render(input, camera, 2 * kWidth, 2 * kHeight);
  const double scaled = difference_to_half(once, renderer_.picture());
  EXPECT_LT(scaled, 2.5);
  // It is more than 2 times without multisampling, 1.99 times on a GPU, 1.77 times with multisampling by llvmpipe.
  EXPECT_GT(thin, 1.7 * scaled) << "lines, points and the gizmo stay as they were";
}

TEST_F(SceneRendererTest, DrawsACutOutOfTheBodiesAtAnySize) {
  SceneInput input;
  input.document_model = model_;
  input.overlays = nothing();
  input.overlays.grid = true;
  input.overlays.sensor_transparent = false;
  Camera camera;
  camera.frame(model_->mesh->bounds());
  const gl::RgbImage before = draw(input, camera);
  constexpr int kFactor = 3;
  const gl::RgbaImage solid = renderer_.cut_out(input, camera, kFactor * kWidth, kFactor * kHeight);
  ASSERT_EQ(solid.width, kFactor * kWidth);
  ASSERT_EQ(solid.rgba.size(), std::size_t{4} * kFactor * kWidth * kFactor * kHeight);
  const auto pixel = [](const gl::RgbaImage& image, int x, int y) {
    const auto at = static_cast<std::ptrdiff_t>(4) * (y * image.width + x);
    return std::vector<int>(image.rgba.begin() + at, image.rgba.begin() + at + 4);
  };
  EXPECT_EQ(pixel(solid, 0, 0), std::vector<int>({0, 0, 0, 0}));
  EXPECT_EQ(pixel(solid, solid.width - 1, solid.height - 1), std::vector<int>({0, 0, 0, 0}));
  const std::vector<int> skin = pixel(solid, solid.width / 2, solid.height / 2);
  EXPECT_EQ(skin[3], 255);
  const auto opaque = test::pixel_at(before, dvec2(0.5 * kWidth, 0.5 * kHeight));
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(skin[k], opaque[k], 4);
  input.overlays.sensor_transparent = true;
  const std::vector<int> thin = pixel(renderer_.cut_out(input, camera, 400, 300), 200, 150);
  EXPECT_GT(thin[3], 40);
  EXPECT_LT(thin[3], 215);
  EXPECT_GT(thin[0], thin[2] + 15) << "the skin's own colour, not darkened, because there is nothing behind it";
  input.overlays.sensor_transparent = false;
  EXPECT_EQ(draw(input, camera), before);
}

TEST_F(SceneRendererTest, FollowsTheSizeOfItsView) {
  const SceneInput input = test::finger_input(frame_);
  const gl::RgbImage first = draw(input, test::finger_camera());
  const gl::RgbImage small = draw(input, test::finger_camera(), 333, 201);
  EXPECT_EQ(small.width, 333);
  EXPECT_EQ(small.height, 201);
  EXPECT_EQ(small.rgb.size(), 3u * 333 * 201);
  EXPECT_EQ(draw(input, test::finger_camera()), first);
  EXPECT_NO_THROW(draw(input, test::finger_camera(), 0, -5));  // a collapsed view
  EXPECT_EQ(draw(input, test::finger_camera()), first);
}

TEST_F(SceneRendererTest, DrawsWithoutAnythingLoaded) {
  SceneInput input;
  const gl::RgbImage empty = draw(input, Camera{});
  test::write_picture("empty", empty);
  input.overlays.grid = false;
  EXPECT_GT(pixels_changed(empty, draw(input, Camera{})), 2000);  // the grid was drawn
}

TEST_F(SceneRendererTest, HidesObjectsBelowAPlaneGeom) {
  auto scene = std::make_shared<SimScene>(*frame_->scene);
  scene->geoms[0].plane = true;  // the box becomes the floor at its own pose
  auto frame = std::make_shared<SimFrame>(*frame_);
  frame->scene = scene;
  frame->geom_poses[0] = {dquat(1, 0, 0, 0), dvec3(0, 0, 0)};
  SceneInput input = test::finger_input(frame);
  input.overlays = nothing();
  input.overlays.path = true;  // 1.5 mm below the floor
  const Camera camera = test::finger_camera();
  const gl::RgbImage image = draw(input, camera);
  input.overlays.grid = true;
  test::write_picture("plane", draw(input, camera));
  const dvec3 on_path = 0.5 * (scene->path_W[0] + scene->path_W[1]) - dvec3(0.008, 0, 0);
  const auto pixel = test::pixel_at(image, dvec2(camera.project(on_path, kWidth, kHeight)));
  EXPECT_LT(pixel[0], 140);  // dimmed red over the floor
  EXPECT_GT(pixel[0], pixel[1] + 15);
}

TEST_F(SceneRendererTest, NamesABrokenShaderWithItsLine) {
  const auto broken = [](const std::string& file, const std::string& text) {
    return [=](const std::string& name) { return name == file ? text : gl::read_embedded_shader(name); };
  };
  try {
    const SceneRenderer r(broken("line.frag", "#version 410 core\nout vec4 c;\nvoid main() { c = nonsense; }\n"));
    FAIL() << "compiled";
  } catch (const Error& e) {
    EXPECT_EQ(e.file(), "line.frag");
    EXPECT_EQ(e.where(), "line 3");
    EXPECT_NE(e.message().find("nonsense"), std::string::npos);
  }
  try {
    const SceneRenderer r(broken("color.glsl", "float half_of(float x) {\n  return 0.5 * y;\n}\n"));
    FAIL() << "compiled";
  } catch (const Error& e) {
    EXPECT_EQ(e.file(), "color.glsl") << e.what();
    EXPECT_EQ(e.where(), "line 2");
  }
}

}  // namespace
}  // namespace taxel::ui
