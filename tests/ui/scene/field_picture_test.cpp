// Receptive fields in the picture: each pixel has the colour that follows from its exact distance to the centre.
#include <gtest/gtest.h>

#include <cmath>

#include "core/mesh/make/primitives.h"
#include "ui/scene/geometry/shown_fields.h"
#include "ui/scene/picture.h"
#include "ui/scene/scene_renderer.h"

namespace taxel::ui {
namespace {

constexpr int kSquareWidth = 400, kSquareHeight = 300;
constexpr double kHalfSquare = 0.05;  // of the square skin [m]

Taxel taxel_on_square(int id, const dvec3& center, double radius) {
  Taxel taxel;
  taxel.id = id;
  taxel.center = center;
  taxel.normal = {0, 0, 1};
  taxel.radius = radius;
  return taxel;
}

/// Returns a layout on a square of two faces in the plane z = 0.
SensorModelPtr on_square(std::vector<Taxel> taxels, Metric metric = Metric::euclidean) {
  auto model = std::make_shared<SensorModel>();
  model->mesh = std::make_shared<const TriMesh>(TriMesh({{-kHalfSquare, -kHalfSquare, 0},
                                                         {kHalfSquare, -kHalfSquare, 0},
                                                         {kHalfSquare, kHalfSquare, 0},
                                                         {-kHalfSquare, kHalfSquare, 0}},
                                                        {{0, 1, 2}, {0, 2, 3}}));
  model->skin = std::make_shared<const MeshIndex>(model->mesh);
  model->layout.taxels = std::move(taxels);
  model->layout.receptive_field.metric = metric;
  return model;
}

SceneInput input_with_map(const SensorModelPtr& model, FieldMap map) {
  SceneInput input;
  input.document_model = model;
  Overlays& show = input.overlays;
  show = {};
  show.samples = show.taxels = show.taxel_labels = show.receptive_fields = show.grid = show.sensor_transparent = false;
  show.fields_filled = map == FieldMap::filled;
  show.coverage = map == FieldMap::coverage;
  auto fields = std::make_shared<ShownFields>();
  FieldMaker().make({{model}, map}, *fields);
  input.fields = fields;
  return input;
}

Camera above_square() {
  Camera camera;
  camera.elevation_deg = 60;
  camera.azimuth_deg = 100;
  camera.distance = 0.08;
  return camera;
}

/// Returns the point of the plane z = 0 at the centre of a pixel.
dvec3 on_square_plane(const Camera& camera, double x, double y) {
  const Ray ray = camera.pixel_ray(x, y, kSquareWidth, kSquareHeight);
  return ray.origin - ray.origin.z / ray.direction.z * ray.direction;
}

class FieldPicture : public ::testing::Test {
 protected:
  static void SetUpTestSuite() { test::context(); }
  gl::RgbImage draw(const SceneInput& input, RenderEffort effort = RenderEffort::software) {
    SceneRenderer renderer(gl::read_embedded_shader, effort);
    renderer.set_ambient_occlusion(false);
    renderer.render(input, above_square(), kSquareWidth, kSquareHeight);
    return renderer.picture();
  }
};

/// Returns the part of a pixel inside a circle around a centre: 0 to 1 within half a pixel of its line.
double part_in_circle(const Camera& camera, const dvec3& center, double radius, int x, int y) {
  const auto distance = [&](double u, double v) { return glm::distance(on_square_plane(camera, u, v), center); };
  const double here = distance(x + 0.5, y + 0.5);
  const dvec2 change(distance(x + 1.0, y + 0.5) - distance(x, y + 0.5),
                     distance(x + 0.5, y + 1.0) - distance(x + 0.5, y));
  return std::clamp(0.5 + (radius - here) / std::max(glm::length(change), 1e-12), 0.0, 1.0);
}

TEST_F(FieldPicture, ShowsASmoothCircleOnTwoLargeFaces) {
  const dvec3 center(0.004, -0.003, 0);
  const double radius = 0.012;
  for (const Metric metric : {Metric::euclidean, Metric::geodesic}) {
    const SensorModelPtr model = on_square({taxel_on_square(1, center, radius)}, metric);
    const gl::RgbImage filled = draw(input_with_map(model, FieldMap::filled)),
                       bare = draw(input_with_map(model, FieldMap::none));
    test::write_picture(metric == Metric::euclidean ? "field_circle" : "field_circle_geodesic", filled);
    const Camera camera = above_square();
    const dvec2 middle(camera.project(center, kSquareWidth, kSquareHeight));
    const auto inner = test::pixel_at(filled, middle);
    const double full = test::pixel_at(bare, middle)[2] - inner[2];
    ASSERT_GT(full, 20) << "orange has less blue than the skin";
    double worst = 0, sum = 0;
    int rim = 0;
    for (int y = 0; y < kSquareHeight; ++y)
      for (int x = 0; x < kSquareWidth; ++x) {
        const double expected = part_in_circle(camera, center, radius, x, y);
        const auto at = dvec2(x + 0.5, y + 0.5);
        const double cover = (test::pixel_at(bare, at)[2] - test::pixel_at(filled, at)[2]) / full;
        worst = std::max(worst, std::abs(cover - expected));
        if (!(expected > 0.05 && expected < 0.95)) continue;
        sum += std::abs(cover - expected);
        ++rim;
      }
    EXPECT_GT(rim, 200) << "the rim is smooth over a pixel";
    EXPECT_LT(worst, metric == Metric::euclidean ? 0.2 : 0.6);
    EXPECT_LT(sum / rim, metric == Metric::euclidean ? 0.08 : 0.2);
  }
}

TEST_F(FieldPicture, MultipliesTheSkinByATintForEachField) {
  const double radius = 0.012;
  Taxel twice = taxel_on_square(3, {0, -0.02, 0}, radius);
  twice.subtaxels = {{{-0.003, -0.02, 0}, {0, 0, 1}, 0.005}, {{0.003, -0.02, 0}, {0, 0, 1}, 0.005}};
  const SensorModelPtr model =
      on_square({taxel_on_square(1, {-0.006, 0, 0}, radius), taxel_on_square(2, {0.006, 0, 0}, radius), twice});
  for (const RenderEffort effort : {RenderEffort::software, RenderEffort::gpu}) {
    const SceneInput input = input_with_map(model, FieldMap::coverage);
    const gl::RgbImage image = draw(input, effort);
    test::write_picture("coverage_of_three", image);
    const Camera camera = above_square();
    const auto pixel = [&](const dvec3& p) {
      const std::array<int, 3> rgb = test::pixel_at(image, dvec2(camera.project(p, kSquareWidth, kSquareHeight)));
      return glm::vec3(rgb[0], rgb[1], rgb[2]);
    };
    const glm::vec3 skin = pixel({0, 0.018, 0});
    const auto expect = [&](const dvec3& p, int taxels, const char* where) {
      const glm::vec3 expected = skin * glm::pow(kCoveredTint, glm::vec3(static_cast<float>(taxels)));
      EXPECT_LT(glm::distance(pixel(p), expected), 8) << where;
    };
    expect({-0.012, 0, 0}, 1, "one field");
    expect({0, 0, 0}, 2, "two fields");
    expect({0, -0.02, 0}, 1, "the subtaxels of one taxel count once");
    expect({0.006, -0.02, 0}, 1, "one subtaxel");
    expect({0, -0.028, 0}, 0, "no field");
    EXPECT_GT(test::color_difference(
                  {static_cast<int>(skin.r), static_cast<int>(skin.g), static_cast<int>(skin.b)},
                  test::pixel_at(image, dvec2(camera.project({-0.012, 0, 0}, kSquareWidth, kSquareHeight)))),
              15)
        << "covered skin is seen at a glance";
  }
  EXPECT_EQ(overlap_color(0), kUncoveredColor);
  EXPECT_LT(glm::distance(overlap_color(2), kUncoveredColor * kCoveredTint * kCoveredTint), 1e-6f);
}

TEST_F(FieldPicture, LightsTheSkinUnderTheCoverage) {
  auto ball = std::make_shared<SensorModel>();
  ball->mesh = std::make_shared<const TriMesh>(make_icosphere(0.02, 4));
  ball->skin = std::make_shared<const MeshIndex>(ball->mesh);
  Taxel taxel = taxel_on_square(1, {0, 0, 0.02}, 0.02);
  ball->layout.taxels = {taxel};
  const gl::RgbImage image = draw(input_with_map(ball, FieldMap::coverage));
  test::write_picture("coverage_of_ball", image);
  const Camera camera = above_square();
  const auto brightness = [&](const dvec3& direction) {
    const auto rgb =
        test::pixel_at(image, dvec2(camera.project(0.02 * glm::normalize(direction), kSquareWidth, kSquareHeight)));
    return rgb[0] + rgb[1] + rgb[2];
  };
  EXPECT_GT(brightness({0.3, -0.3, -0.1}), 1.15 * brightness({-0.3, 0.3, -0.8})) << "uncovered skin, lit and in shade";
}

}  // namespace
}  // namespace taxel::ui
