// A user's scene is drawn with the materials, lights, planes and sky of its file, and no skin flickers.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "core/sim/simulator.h"
#include "fixtures/fill_frame.h"
#include "fixtures/sensor_scene.h"
#include "ui/gl/image_texture.h"
#include "ui/scene/passes/scene_lighting.h"
#include "ui/scene/passes/scene_passes.h"
#include "ui/scene/picture.h"
#include "ui/scene/scene_parts.h"
#include "ui/scene/scene_renderer.h"

namespace taxel::ui {
namespace {

constexpr int kLookWidth = 480, kLookHeight = 400;

SceneInput scene_of(const std::string& xml, const std::vector<SceneAttachment>& attachments = {}) {
  const test::SensorScene s;
  write_file_atomically(s.folder / "scene.xml", xml);
  const auto simulator = Simulator::load(s.folder / "scene.xml", attachments);
  auto frame = std::make_shared<SimFrame>();
  test::fill_frame(*simulator, *frame);
  SceneInput input;
  input.frame = frame;
  Overlays& show = input.overlays;
  show.samples = show.taxels = show.receptive_fields = show.rays = show.taxel_labels = false;
  return input;
}

class SceneLookPicture : public ::testing::Test {
 protected:
  static void SetUpTestSuite() { test::context(); }
  gl::RgbImage draw(const SceneInput& input, const Camera& camera) {
    renderer_.render(input, camera, kLookWidth, kLookHeight);
    return renderer_.picture();
  }
  std::array<int, 3> color_at(const gl::RgbImage& image, const Camera& camera, const dvec3& p_W) const {
    return test::pixel_at(image, dvec2(camera.project(p_W, kLookWidth, kLookHeight)));
  }
  SceneRenderer renderer_;
};

Camera turned_camera(const dvec3& target, double azimuth, double distance) {
  Camera camera;
  camera.target = target;
  camera.azimuth_deg = azimuth;
  camera.elevation_deg = 25;
  camera.distance = distance;
  return camera;
}

/// Returns a finger with a skin, and a blue visual geom with the mesh asset `v`.
SceneInput finger_with_visual(const std::string& visual_mesh) {
  const std::string mesh = TAXEL_SOURCE_DIR "/assets/meshes/fingertip.obj";
  return scene_of(fmt::format(R"(<mujoco><asset><mesh name='m' file='{}'/>{}</asset><worldbody><body name='tip'>
      <geom name='skin' type='mesh' mesh='m' group='3'/>
      <geom name='visual' type='mesh' mesh='v' contype='0' conaffinity='0' rgba='0 0 1 1'/></body></worldbody></mujoco>)",
                              mesh, visual_mesh),
                  {{"skin", TAXEL_SOURCE_DIR "/assets/layouts/fingertip.taxels.json"}});
}

/// Returns the number of skin points, seen in 20 frames of a turning camera, that are bluer than red.
int blue_points(const SceneInput& input, const std::function<gl::RgbImage(const Camera&)>& draw, int& seen) {
  const SensorModel& model = *input.frame->scene->sensors.at(0);
  const Pose X_WM = input.frame->sensors.at(0).X_WM;
  const std::size_t step = model.samples.size() / 100;
  int blue = 0;
  for (int i = 0; i < 20; ++i) {
    const Camera camera = turned_camera(X_WM * model.mesh->bounds().center(), 18.0 * i, 0.1);
    const gl::RgbImage image = draw(camera);
    if (i == 3) test::write_picture("scene_skin", image);
    for (std::size_t k = 0; k < 100; ++k) {
      const SurfaceSample& sample = model.samples[k * step];
      const dvec3 p_W = X_WM * dvec3(sample.position), to_eye = camera.eye() - p_W;
      if (glm::dot(X_WM.rotate(dvec3(sample.normal)), glm::normalize(to_eye)) < 0.3) continue;
      ++seen;
      const auto pixel = test::pixel_at(image, dvec2(camera.project(p_W, kLookWidth, kLookHeight)));
      if (pixel[2] > pixel[0]) ++blue;
    }
  }
  return blue;
}

TEST_F(SceneLookPicture, ShowsNothingThroughASkinThatCoversAGeom) {
  const SceneInput base =
      finger_with_visual("<mesh name='v' file='" TAXEL_SOURCE_DIR "/assets/meshes/fingertip.obj'/>");
  for (const bool transparent : {false, true}) {
    SceneInput input = base;
    input.overlays.sensor_transparent = transparent;
    int seen = 0;
    EXPECT_EQ(blue_points(
                  input, [&](const Camera& camera) { return draw(input, camera); }, seen),
              0)
        << (transparent ? "transparent" : "opaque");
    EXPECT_GT(seen, 500);
  }
}

// A skin may cover a geom only in part. Such a geom is drawn, and the skin in front of it.
TEST_F(SceneLookPicture, DrawsASkinBeforeAGeomAtTheSamePlace) {
  SceneInput input = finger_with_visual("<mesh name='v' file='" TAXEL_SOURCE_DIR "/assets/meshes/fingertip.obj'/>");
  auto scene = std::make_shared<SimScene>(*input.frame->scene);
  for (SceneGeom& geom : scene->geoms) geom.covered_by = -1;
  auto frame = std::make_shared<SimFrame>(*input.frame);
  frame->scene = scene;
  input.frame = frame;
  input.overlays.sensor_transparent = false;
  int seen = 0;
  EXPECT_EQ(blue_points(
                input, [&](const Camera& camera) { return draw(input, camera); }, seen),
            0);
  EXPECT_GT(seen, 500);
}

/// An image of 2 x 2 pixels: red and green above, blue and white below.
constexpr unsigned char kFourColors[] = {
    0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x48, 0x44, 0x52, 0x00, 0x00, 0x00,
    0x02, 0x00, 0x00, 0x00, 0x02, 0x08, 0x02, 0x00, 0x00, 0x00, 0xfd, 0xd4, 0x9a, 0x73, 0x00, 0x00, 0x00, 0x13, 0x49,
    0x44, 0x41, 0x54, 0x78, 0xda, 0x63, 0xf8, 0xc5, 0xc5, 0xc5, 0xf5, 0x8b, 0x8b, 0x01, 0x48, 0x00, 0x01, 0x00, 0x21,
    0x56, 0x06, 0x19, 0x00, 0x7f, 0x62, 0xbd, 0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82};

/// Returns a square of 0.4 m at 0.3 m height that faces up, above a plane. Its corners have the corners of kFourColors:
/// the place (0, 0) of an OBJ is at the lower left of an image. Its other faces are blue. `geom` and `material` are
/// more attributes of both. With `finger`, a skin touches the square at (-0.1, 0.1).
SceneInput textured_square(const std::string& geom = "", const std::string& material = "", bool finger = false) {
  const test::SensorScene s;
  write_file_atomically(s.folder / "square.obj",
                        "v -.2 -.2 0\nv .2 -.2 0\nv .2 .2 0\nv -.2 .2 0\nv 0 0 -.1\n"
                        "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt .25 .25\n"
                        "f 1/1 2/2 3/3\nf 1/1 3/3 4/4\nf 2/5 1/5 5/5\nf 3/5 2/5 5/5\nf 4/5 3/5 5/5\nf 1/5 4/5 5/5\n");
  write_file_atomically(s.folder / "image.png", {reinterpret_cast<const char*>(kFourColors), sizeof(kFourColors)});
  const std::string tip =
      finger ? "<body pos='-.1 .1 .3061' quat='1 1 0 0'><geom name='tip' type='mesh' mesh='tip'/></body>" : "";
  write_file_atomically(
      s.folder / "scene.xml",
      fmt::format(R"(<mujoco><asset><mesh name='square' file='square.obj'/><mesh name='tip' file='{}'/>
      <texture name='image' type='2d' file='image.png'/><material name='image' texture='image' {}/>
      <material name='mirror' rgba='.3 .3 .3 1' reflectance='.8'/></asset><worldbody>
      <light type='directional' dir='0 0 -1' diffuse='.6 .6 .6'/><geom type='plane' size='0 0 1' material='mirror'/>
      <body pos='0 0 .3'><freejoint/><geom type='mesh' mesh='square' material='image' {}/></body>{}
      </worldbody></mujoco>)",
                  TAXEL_SOURCE_DIR "/assets/meshes/fingertip.obj", material, geom, tip));
  std::vector<SceneAttachment> attachments;
  if (finger) attachments.push_back({"tip", TAXEL_SOURCE_DIR "/assets/layouts/fingertip.taxels.json"});
  const auto simulator = Simulator::load(s.folder / "scene.xml", attachments);
  auto frame = std::make_shared<SimFrame>();
  test::fill_frame(*simulator, *frame);
  SceneInput input;
  input.frame = frame;
  return input;
}

/// Returns the channels of a colour that are clearly brighter than its darkest one, as bits: 1 red, 2 green, 4 blue;
/// 0 if it is grey.
int hue(const std::array<int, 3>& pixel) {
  const int least = *std::min_element(pixel.begin(), pixel.end());
  return (pixel[0] > least + 40 ? 1 : 0) + (pixel[1] > least + 40 ? 2 : 0) + (pixel[2] > least + 40 ? 4 : 0);
}

class TexturedMesh : public SceneLookPicture {
 protected:
  TexturedMesh() : camera_(turned_camera({0, 0, 0.3}, -90, 1.2)) { camera_.elevation_deg = 70; }
  /// Returns the hues in the middle of the quarters of the square: above left and right, below left and right.
  std::array<int, 4> hues(const SceneInput& input, const std::string& name) {
    const gl::RgbImage image = draw(input, camera_);
    test::write_picture(name, image);
    std::array<int, 4> found{};
    for (int i = 0; i < 4; ++i)
      found[at(i)] = hue(color_at(image, camera_, {i % 2 == 0 ? -0.1 : 0.1, i < 2 ? 0.1 : -0.1, 0.3}));
    return found;
  }
  static constexpr std::array<int, 4> kColors{1, 2, 4, 0};
  Camera camera_;
};

// MuJoCo's own renderer shows the image upright as well, and does not repeat it at the coordinates of a file.
TEST_F(TexturedMesh, HasTheColorsOfTheImageAtItsCoordinates) {
  EXPECT_EQ(hues(textured_square(), "textured_square"), kColors);
  EXPECT_EQ(hues(textured_square("rgba='1 1 1 .6'"), "textured_glass"), (std::array{5, 6, 4, 4}))
      << "the blue faces below are seen through it";
  EXPECT_EQ(hues(textured_square("", "texrepeat='5 5'"), "textured_repeat"), kColors);
  EXPECT_EQ(hues(textured_square("rgba='1 0 0 1'"), "textured_red")[3], 1) << "the colour of the geom multiplies it";
}

TEST_F(TexturedMesh, HasTheColorOfTheGeomWithoutCoordinates) {
  SceneInput input = textured_square();
  auto scene = std::make_shared<SimScene>(*input.frame->scene);
  for (SceneGeom& geom : scene->geoms) geom.texture_coords = nullptr;
  auto frame = std::make_shared<SimFrame>(*input.frame);
  frame->scene = scene;
  input.frame = frame;
  EXPECT_EQ(hues(input, "textured_none"), (std::array{0, 0, 0, 0}));
}

TEST_F(TexturedMesh, KeepsItsTextureWhereItIsTouchedAndInAMirror) {
  const SceneInput input = textured_square("", "", true);
  ASSERT_FALSE(contact_spheres(input, 1).empty());
  const std::array<int, 4> touched = hues(input, "textured_touched");
  for (int i = 1; i < 4; ++i) EXPECT_EQ(touched[at(i)], kColors[at(i)]) << i;
  Camera low = turned_camera({0, 0, 0}, -90, 1.2);
  low.elevation_deg = 10;
  const SceneInput alone = textured_square();
  const gl::RgbImage image = draw(alone, low);
  test::write_picture("textured_mirror", image);
  EXPECT_EQ(hue(color_at(image, low, {0, -0.1, -0.25})), 4) << "the mirrored underside";
}

constexpr const char* kFloorScene = R"(<mujoco><asset>
  <texture type='skybox' builtin='gradient' rgb1='0 1 0' rgb2='0 1 0' width='8' height='48'/>
  <texture name='check' type='2d' builtin='checker' rgb1='.05 .05 .05' rgb2='.9 .9 .9' width='64' height='64'/>
  <material name='floor' texture='check' texrepeat='1 1' texuniform='true'/>
  <material name='black' rgba='.02 .02 .02 1' specular='1' shininess='.8'/></asset><worldbody>
  <light type='directional' dir='0 0 -1'/><geom type='plane' size='0 0 1' material='floor'/>
  <body pos='0 0 .3'><geom size='.1' material='black'/></body></worldbody></mujoco>)";

double brightness_of_pixel(const std::array<int, 3>& pixel) {
  return (pixel[0] + pixel[1] + pixel[2]) / 3.0;
}

TEST_F(SceneLookPicture, HasCheckeredFloorSkyAndShadow) {
  const SceneInput input = scene_of(kFloorScene);
  const Camera camera = turned_camera({0, 0, 0.2}, 30, 4);
  const gl::RgbImage image = draw(input, camera);
  test::write_picture("scene_floor", image);
  // MuJoCo repeats the texture every 2 m, two cells each way; its middle is a corner of cells.
  const double bright = brightness_of_pixel(color_at(image, camera, {0.5, 0.5, 0})),
               dark = brightness_of_pixel(color_at(image, camera, {0.5, -0.5, 0}));
  EXPECT_GT(bright - dark, 60) << "neighbouring cells";
  EXPECT_NEAR(brightness_of_pixel(color_at(image, camera, {-0.5, -0.5, 0})), bright, 12) << "across a corner";
  Camera level = turned_camera({0, 0, 0.2}, 30, 4);
  level.elevation_deg = 1;
  const auto sky = test::pixel_at(draw(input, level), {0.5 * kLookWidth, 2});
  EXPECT_GT(sky[1], sky[0] + 60) << "green above the haze";
  const Camera above = turned_camera({0, 0, 0}, 30, 2);
  const gl::RgbImage near = draw(input, above);
  const double lit = brightness_of_pixel(color_at(near, above, {0.2, 0.2, 0})),  // both in one bright cell
      shaded = brightness_of_pixel(color_at(near, above, {0.05, 0.05, 0}));
  EXPECT_LT(shaded, 0.8 * lit) << "below the ball";
}

TEST_F(SceneLookPicture, ShowsBlackPlasticAsMoreThanASilhouette) {
  const SceneInput input = scene_of(kFloorScene);
  const Camera camera = turned_camera({0, 0, 0.3}, 30, 0.6);
  const gl::RgbImage image = draw(input, camera);
  test::write_picture("scene_black", image);
  double darkest = 255, brightest = 0;
  for (double u = -0.7; u <= 0.7; u += 0.1) {
    for (double v = -0.7; v <= 0.7; v += 0.1) {
      if (u * u + v * v > 0.8) continue;
      const double pixels = 0.1 * kLookHeight / (2 * 0.6 * std::tan(glm::radians(20.0)));  // of the ball's radius
      const double level =
          brightness_of_pixel(test::pixel_at(image, {0.5 * kLookWidth + u * pixels, 0.5 * kLookHeight + v * pixels}));
      darkest = std::min(darkest, level);
      brightest = std::max(brightest, level);
    }
  }
  EXPECT_GT(brightest - darkest, 40) << "highlights and the reflected sky give it a shape";
}

TEST_F(SceneLookPicture, ReflectsBodiesInAFloor) {
  std::string xml = kFloorScene;
  const SceneInput plain = scene_of(xml);
  xml.replace(xml.find("texuniform='true'"), 17, "texuniform='true' reflectance='.8'");
  xml.replace(xml.find("rgba='.02 .02 .02 1'"), 20, "rgba='1 0 0 1' emission='1'");
  const SceneInput mirror = scene_of(xml);
  Camera camera = turned_camera({0, 0, 0.1}, 30, 1.5);
  camera.elevation_deg = 15;
  // The image of the ball's middle is as far below the floor as the ball is above it.
  const auto image = color_at(draw(mirror, camera), camera, {0, 0, -0.3});
  EXPECT_GT(image[0], image[1] + 60) << "red";
  const auto without = color_at(draw(plain, camera), camera, {0, 0, -0.3});
  EXPECT_LT(std::abs(without[0] - without[1]), 40);
}

TEST(SceneLighting, DimsLightsThatWouldWashOutWhiteBodies) {
  std::string lights;
  for (int i = 0; i < 6; ++i) lights += "<light type='directional' diffuse='1 1 1' dir='0 0 -1'/>";
  const SceneInput many = scene_of("<mujoco><worldbody>" + lights + "<geom size='.1'/></worldbody></mujoco>");
  const SceneLighting lighting = scene_lighting(many, look(true), glm::vec3(0.15f));
  ASSERT_EQ(lighting.sources.size(), kMaxLights);
  glm::vec3 sum(0);
  for (const LitSource& source : lighting.sources) sum += source.diffuse;
  EXPECT_LT(sum.x, 1.6f);
  const SceneLighting none = scene_lighting(scene_of("<mujoco><worldbody><geom size='.1'/></worldbody></mujoco>"),
                                            look(true), glm::vec3(0.15f));
  ASSERT_EQ(none.sources.size(), 2U) << "the studio's key light, and the headlight";
  EXPECT_GT(none.sources[0].diffuse.x, 0.3f);
}

TEST(SceneMaterials, HaveTheHighlightOfMujocosExponent) {
  SceneMaterial material;
  material.specular = 0.5f;
  material.shininess = 0.25f;
  const glm::vec4 finish = finish_of(material);
  const float alpha = finish.x * finish.x;  // Blinn's cos^n has the width of GGX with alpha^2 = 2 / (n + 2)
  EXPECT_NEAR(alpha * alpha, 2.0f / (128 * 0.25f + 2), 1e-6f);
  EXPECT_NEAR(finish.y, 0.04f, 1e-6f) << "of plastic";
  material.specular = 0;
  EXPECT_EQ(finish_of(material).x, 1) << "matte";
  material.roughness = 0.3f;
  material.metallic = 1;
  EXPECT_EQ(finish_of(material).x, 0.3f) << "MJCF's own roughness comes first";
  EXPECT_EQ(finish_of(material).z, 1);
}

TEST(SceneMaterials, RepeatTexturesAsMujocoDoes) {
  SceneMaterial material;
  EXPECT_EQ(repeat_of(material, {1, 1}), glm::vec4(0)) << "no texture";
  material.texture = std::make_shared<const SceneTexture>();
  material.repeat = {4, 6};
  EXPECT_EQ(repeat_of(material, {2, 3}), glm::vec4(1, -1, -0.5f, -0.5f)) << "4 images in 4 m, 6 in 6 m";
  material.uniform = true;
  EXPECT_EQ(repeat_of(material, {2, 3}), glm::vec4(2, -3, -0.5f, -0.5f)) << "4 and 6 in 2 m";
}

TEST_F(SceneLookPicture, UploadsImagesWithAllTheirLevels) {
  const std::vector<std::uint8_t> grey(8 * 4, 77);
  const gl::ImageTexture image(gl::ImageTexture::Kind::flat, 8, 4, 1, grey, false);
  image.bind(0);
  GLint width = 0, green = 0;
  glGetTexLevelParameteriv(GL_TEXTURE_2D, 2, GL_TEXTURE_WIDTH, &width);
  glGetTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_G, &green);
  EXPECT_EQ(width, 2);
  EXPECT_EQ(green, GL_RED) << "one channel is grey, not red";
  glBindTexture(GL_TEXTURE_2D, 0);
}

}  // namespace
}  // namespace taxel::ui
