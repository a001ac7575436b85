// The marks that are drawn in SIMULATE: few arrows and ids, discs that glow with their readings, net forces.
#include "ui/scene/marks/marks.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "app/studio/nouns/view/view_panel.h"
#include "core/mesh/make/primitives.h"
#include "finger_scene.h"
#include "picture.h"
#include "ui/scene/geometry/field_patch.h"
#include "ui/scene/scene_labels.h"

namespace taxel::ui {
namespace {

constexpr int kViewWidth = 700, kViewHeight = 400;

/// Returns a ball of radius 20 mm with `count` taxels spread over it, with the ids 100, 101, ...
SensorModelPtr ball(int count) {
  auto model = std::make_shared<SensorModel>();
  model->mesh = std::make_shared<const TriMesh>(make_icosphere(0.02, 3));
  model->skin = std::make_shared<const MeshIndex>(model->mesh);
  for (int k = 0; k < count; ++k) {
    const double z = 1 - (2 * k + 1.0) / count, turn = 2.399963 * k, r = std::sqrt(1 - z * z);
    Taxel& taxel = model->layout.taxels.emplace_back();
    taxel.id = 100 + k;
    taxel.normal = {r * std::cos(turn), r * std::sin(turn), z};
    taxel.center = 0.02 * taxel.normal;
    taxel.radius = 0.003;
  }
  return model;
}

/// Returns the scene of balls next to each other in SIMULATE, with a reading of 0 at each taxel.
SceneInput balls(int sensors, int taxels, std::shared_ptr<SimFrame>& frame) {
  const SensorModelPtr model = ball(taxels);
  auto scene = std::make_shared<SimScene>();
  frame = std::make_shared<SimFrame>();
  for (int s = 0; s < sensors; ++s) {
    scene->sensors.push_back(model);
    scene->sensor_geoms.push_back("finger" + std::to_string(s));
    SensorStep& state = frame->sensors.emplace_back();
    state.X_WM.p = {0.05 * s, 0, 0};
    state.readings.assign(static_cast<std::size_t>(taxels), 0.0);
  }
  frame->scene = scene;
  SceneInput input;
  input.frame = frame;
  input.overlays = overlays_of_run();
  input.reading_range.hi = 1000;
  return input;
}

std::vector<std::vector<int>> marked(const SceneInput& input) {
  return marked_taxels(input, sensor_views(input));
}

TEST(MarkedTaxels, AreThoseOfInterestOnly) {
  std::shared_ptr<SimFrame> frame;
  SceneInput input = balls(2, 30, frame);
  EXPECT_EQ(marked(input), (std::vector<std::vector<int>>{{}, {}})) << "nothing is touched";
  frame->sensors[0].readings[7] = 500;
  frame->sensors[1].readings[9] = 500;
  frame->sensors[1].readings[3] = 5;  // too little to be seen
  input.selected_taxel = 2;
  input.hovered_sensor = 1, input.hovered_taxel = 4;
  EXPECT_EQ(marked(input), (std::vector<std::vector<int>>{{2, 7}, {4, 9}}));
  input.overlays.all_taxels = true;
  EXPECT_EQ(marked(input)[0].size(), 30U);
}

TEST(MarkedTaxels, AreAtMostSixtyWithTheLargestReadings) {
  std::shared_ptr<SimFrame> frame;
  SceneInput input = balls(1, 256, frame);
  for (int k = 0; k < 256; ++k) frame->sensors[0].readings[static_cast<std::size_t>(k)] = 100 + k;
  input.selected_taxel = 0;
  const std::vector<int> taxels = marked(input)[0];
  ASSERT_EQ(taxels.size(), 60U);
  EXPECT_EQ(taxels[0], 0) << "the selected one";
  EXPECT_EQ(taxels[1], 256 - 59);
  EXPECT_EQ(taxels[59], 255);
}

TEST(MarkedTaxels, AreSeenBehindASkinOrABodyOrNot) {
  std::shared_ptr<SimFrame> frame;
  SceneInput input = balls(2, 30, frame);
  const std::vector<SensorView> views = sensor_views(input);
  const dvec3 above(0, 0, 0.2);
  EXPECT_EQ(sighting(input, views, views[0], 0, above), Sighting::clear);
  EXPECT_EQ(sighting(input, views, views[0], 29, above), Sighting::behind) << "on the far side of its own skin";
  EXPECT_EQ(sighting(input, views, views[0], 4, {0.3, 0, 0}), Sighting::behind) << "behind the other ball";
  input.overlays.sensor_transparent = false;
  EXPECT_EQ(sighting(input, views, views[0], 29, above), Sighting::hidden);
  input.overlays.sensor_transparent = true;
  auto with_wall = std::make_shared<SimScene>(*frame->scene);
  SceneGeom& wall = with_wall->geoms.emplace_back();
  wall.mesh = std::make_shared<const TriMesh>(make_box({0.05, 0.05, 0.005}));
  frame->scene = with_wall;
  frame->geom_poses = {Pose{dquat(1, 0, 0, 0), dvec3(0, 0, 0.1)}};
  EXPECT_EQ(sighting(input, sensor_views(input), views[0], 0, above), Sighting::hidden);
}

bool overlap(const SceneLabel& a, const SceneLabel& b, double letter) {
  const dvec2 apart = glm::abs(a.pixel - b.pixel);
  const double width = 0.62 * letter * static_cast<double>(a.text.size() + b.text.size()) / 2;
  return apart.x < width && apart.y < letter;
}

TEST(Labels, NameTheSensorAndMoveAsideWithALeader) {
  std::shared_ptr<SimFrame> frame;
  SceneInput input = balls(2, 240, frame);
  for (int k = 0; k < 20; ++k) frame->sensors[0].readings[static_cast<std::size_t>(k)] = 900 - k;
  Camera camera;
  camera.elevation_deg = 80;
  camera.distance = 0.35;
  const std::vector<SceneLabel> labels = scene_labels(input, camera, kViewWidth, kViewHeight, {.text_height = 13});
  EXPECT_GE(labels.size(), 15U);
  EXPECT_LE(labels.size(), 20U);
  int leaders = 0;
  std::set<std::string> texts;
  for (const SceneLabel& label : labels) {
    EXPECT_TRUE(texts.insert(label.text).second) << label.text;
    EXPECT_EQ(label.text.substr(0, 9), "finger0 1");
    leaders += label.leader ? 1 : 0;
    for (const SceneLabel& other : labels)
      EXPECT_TRUE(&other == &label || !overlap(label, other, 13)) << label.text << " and " << other.text;
  }
  EXPECT_GE(leaders, 3);
  EXPECT_TRUE(texts.contains("finger0 100")) << "the largest reading";
}

/// Returns two balls, on one of which `count` neighbouring taxels respond, seen from above.
struct CrowdedBall {
  std::shared_ptr<SimFrame> frame;
  SceneInput input = balls(2, 240, frame);
  Camera camera;

  explicit CrowdedBall(int count) {
    for (int k = 0; k < count; ++k) reading(k) = 500 + 10 * k;
    camera.elevation_deg = 80;
    camera.distance = 0.35;
  }
  double& reading(int k) { return frame->sensors[0].readings[static_cast<std::size_t>(k)]; }
  [[nodiscard]] std::vector<SceneLabel> labels(std::span<const SceneLabel> previous = {},
                                               std::span<const LabelBox> covered = {}) const {
    return scene_labels(input, camera, kViewWidth, kViewHeight,
                        {.text_height = 13, .covered = covered, .previous = previous});
  }
};

/// Returns the box of a label.
LabelBox box_of(const SceneLabel& label) {
  return {label.pixel - label.half, label.pixel + label.half};
}

bool overlap(const LabelBox& a, const LabelBox& b) {
  return a.lo.x < b.hi.x && b.lo.x < a.hi.x && a.lo.y < b.hi.y && b.lo.y < a.hi.y;
}

/// Returns the place of each label relative to the place that it has alone, by its text.
std::map<std::string, int> slots_of(const std::vector<SceneLabel>& labels) {
  std::map<std::string, int> slots;
  for (const SceneLabel& label : labels) slots[label.text] = label.slot;
  return slots;
}

TEST(Labels, KeepTheirPlacesWhileReadingsVary) {
  CrowdedBall ball(40);
  std::vector<SceneLabel> labels = ball.labels();
  const std::map<std::string, int> first = slots_of(labels);
  ASSERT_GE(first.size(), 20U);
  int moved_without_memory = 0;
  for (int step = 1; step <= 50; ++step) {
    for (int k = 0; k < 40; ++k) ball.reading(k) = (500 + 10 * k) * (1 + 0.1 * std::sin(1.3 * step + 2.1 * k));
    labels = ball.labels(labels);
    EXPECT_EQ(slots_of(labels), first) << step;
    moved_without_memory += slots_of(ball.labels()) == first ? 0 : 1;
  }
  EXPECT_GE(moved_without_memory, 10) << "readings that change the order of labels";
}

TEST(Labels, YieldToAReadingThatIsMuchLarger) {
  CrowdedBall ball(40);
  const std::vector<SceneLabel> labels = ball.labels();
  int hidden = -1;
  for (int k = 0; k < 40 && hidden < 0; ++k)
    if (!slots_of(labels).contains("finger0 " + std::to_string(100 + k))) hidden = k;
  ASSERT_GE(hidden, 0) << "a taxel without a place";
  ball.reading(hidden) = 3000;
  const std::map<std::string, int> after = slots_of(ball.labels(labels));
  ASSERT_TRUE(after.contains("finger0 " + std::to_string(100 + hidden)));
  EXPECT_EQ(after.at("finger0 " + std::to_string(100 + hidden)), 0) << "its own place";
}

TEST(Labels, GiveTheSelectedTaxelItsPlaceBeforeAllOthers) {
  CrowdedBall ball(40);
  ball.input.selected_taxel = 0;  // the smallest reading
  const std::vector<SceneLabel> labels = ball.labels();
  const auto selected = std::find_if(labels.begin(), labels.end(), [](const SceneLabel& l) { return l.selected; });
  ASSERT_NE(selected, labels.end());
  EXPECT_EQ(selected->text, "finger0 100");
  EXPECT_FALSE(selected->leader) << "at its own place";
}

TEST(Labels, AreWholeAndAvoidCoveredBoxes) {
  CrowdedBall ball(60);
  const std::vector<LabelBox> covered{{{0, 0}, {kViewWidth / 2.0, kViewHeight / 2.0}}, {{400, 150}, {440, 260}}};
  for (const double distance : {0.35, 0.12, 0.06}) {
    ball.camera.distance = distance;
    const std::vector<SceneLabel> labels = ball.labels({}, covered);
    EXPECT_GE(labels.size(), 3U);
    for (const SceneLabel& label : labels) {
      const LabelBox box = box_of(label);
      EXPECT_TRUE(box.lo.x >= 0 && box.lo.y >= 0 && box.hi.x <= kViewWidth && box.hi.y <= kViewHeight) << label.text;
      for (const LabelBox& other : covered) EXPECT_FALSE(overlap(box, other)) << label.text;
      for (const SceneLabel& other : labels)
        EXPECT_TRUE(&other == &label || !overlap(box, box_of(other))) << label.text << " and " << other.text;
    }
  }
}

TEST(Labels, FollowTheWidthsOfTheirTexts) {
  CrowdedBall ball(60);
  const std::vector<SceneLabel> labels =
      scene_labels(ball.input, ball.camera, kViewWidth, kViewHeight,
                   {.text_height = 13, .width = [](const std::string& text) { return 20.0 * text.size(); }});
  for (const SceneLabel& label : labels) {
    EXPECT_EQ(label.half.x, 10.0 * static_cast<double>(label.text.size()));
    for (const SceneLabel& other : labels)
      EXPECT_TRUE(&other == &label || !overlap(box_of(label), box_of(other))) << label.text << " and " << other.text;
  }
}

TEST(Labels, AreShortIfThereIsOneSensor) {
  std::shared_ptr<SimFrame> frame;
  SceneInput input = balls(1, 12, frame);
  frame->sensors[0].readings[0] = 900;
  const std::vector<SceneLabel> labels = scene_labels(input, Camera{}, kViewWidth, kViewHeight, {.text_height = 13});
  ASSERT_EQ(labels.size(), 1U);
  EXPECT_EQ(labels[0].text, "100");
}

TEST(Discs, AreTransparentAtZeroAndOpaqueAtATenth) {
  EXPECT_EQ(disc_alpha(0), 0);
  EXPECT_EQ(disc_alpha(-1), 0);
  EXPECT_EQ(disc_alpha(std::numeric_limits<double>::quiet_NaN()), 0);
  EXPECT_GT(disc_alpha(0.1), 0.75f);
  EXPECT_GT(disc_alpha(1), 0.85f);
  EXPECT_LE(disc_alpha(3), 0.9f) << "above the range";
  EXPECT_GT(disc_alpha(0.04), disc_alpha(0.02));
}

/// Returns the scene of the finger with discs, where taxel 0, which looks at the camera, has a reading.
SceneInput finger_with_reading(double reading, int taxel) {
  static const SensorModelPtr model = test::finger_model(2000);
  const auto frame = std::make_shared<SimFrame>(*test::finger_frame(model, 0.004));
  frame->sensors[0].surfaces.clear();
  frame->sensors[0].readings.assign(12, 0.0);
  frame->sensors[0].readings[static_cast<std::size_t>(taxel)] = reading;
  frame->sensors[0].force_W = dvec3(0);
  SceneInput input = test::finger_input(frame);
  input.overlays = overlays_of_run();
  input.overlays.rays = input.overlays.taxels = input.overlays.path = input.overlays.taxel_labels = false;
  input.reading_range.hi = 1000;
  return input;
}

TEST(Discs, HaveTheColourOfTheReading) {
  const SceneInput input = finger_with_reading(500, 3);
  const std::vector<SensorView> views = sensor_views(input);
  const DiscMarks marks = disc_marks(input, views, views[0], dvec3(1), 0.3f);
  EXPECT_EQ(marks.taxels, std::vector<int>{3});
  EXPECT_EQ(marks.fills, std::vector{pack(glm::vec4(input.reading_range.color(500), disc_alpha(0.5)))});
  const SceneInput quiet = finger_with_reading(0, 3);
  const std::vector<SensorView> quiet_views = sensor_views(quiet);
  EXPECT_TRUE(disc_marks(quiet, quiet_views, quiet_views[0], dvec3(1), 0.3f).taxels.empty());
}

/// Returns the camera that looks at a taxel of the finger against its normal.
Camera camera_facing(const SceneInput& input, const Taxel& taxel) {
  const Pose& X_WM = input.frame->sensors[0].X_WM;
  const dvec3 n = glm::normalize(X_WM.rotate(taxel.normal));
  Camera camera;
  camera.target = X_WM * taxel.center;
  camera.azimuth_deg = glm::degrees(std::atan2(n.y, n.x));
  camera.elevation_deg = glm::degrees(std::asin(std::clamp(n.z, -0.99, 0.99)));
  camera.distance = 0.075;
  return camera;
}

/// Draws the finger without the box, with a reading at one taxel, which the camera faces.
gl::RgbImage facing_picture(SceneRenderer& renderer, double reading, int taxel, bool dark, bool transparent) {
  SceneInput input = finger_with_reading(reading, taxel);
  input.dark = dark;
  input.overlays.sensor_transparent = transparent;
  input.overlays.geom_groups = {};
  const Layout& layout = input.frame->scene->sensors[0]->layout;
  renderer.render(input, camera_facing(input, layout.taxels[static_cast<std::size_t>(taxel)]), kViewWidth, kViewHeight);
  EXPECT_EQ(renderer.field_numbers().marks.discs, reading > 0 ? 1 : 0);
  return renderer.picture();
}

constexpr int kHalfSide = 20;  ///< half of the side of the square in the middle of a disc [pixel]

/// Returns the area of that square [pixel] that the rings of other taxels hide at most: the length of each ring in the
/// square times the width of its line (1.5 pixels), of the casing at the inner side (1) and of two smooth edges (0.5
/// each), and another half, because a pixel that is hidden in part counts whole. Rings on the far side count if the
/// skin is transparent.
double area_of_rings(const SceneInput& input, int taxel, bool transparent) {
  constexpr double kRingWidth = 1.5 + 1 + 2 * 0.5 + 0.5;
  const SensorModel& model = *input.frame->scene->sensors[0];
  const Pose& X_WM = input.frame->sensors[0].X_WM;
  const std::vector<Taxel>& taxels = model.layout.taxels;
  const Camera camera = camera_facing(input, taxels[static_cast<std::size_t>(taxel)]);
  const dvec2 middle(kViewWidth / 2.0, kViewHeight / 2.0);
  double length = 0;
  for (std::size_t k = 0; k < taxels.size(); ++k) {
    if (k == static_cast<std::size_t>(taxel)) continue;
    for (const RingPiece& piece : taxel_rings(*model.skin, taxels[k], model.layout.receptive_field)) {
      const dvec2 a(camera.project(X_WM * piece.a, kViewWidth, kViewHeight)),
          b(camera.project(X_WM * piece.b, kViewWidth, kViewHeight));
      const dvec2 away = glm::abs(0.5 * (a + b) - middle);
      const dvec3 normal_W = X_WM.rotate(model.mesh->face_normals()[static_cast<std::size_t>(piece.face)]);
      const bool is_seen = transparent || glm::dot(normal_W, camera.eye() - X_WM * piece.a) > 0;
      if (is_seen && away.x < kHalfSide && away.y < kHalfSide) length += glm::distance(a, b);
    }
  }
  return kRingWidth * length;
}

TEST(Discs, DifferFromTheSkinAtATenthOfTheRange) {
  test::context();
  SceneRenderer renderer;
  for (const bool dark : {true, false})
    for (const bool transparent : {true, false})
      for (const int k : {1, 3, 5, 8}) {
        const gl::RgbImage before = facing_picture(renderer, 0, k, dark, transparent),
                           after = facing_picture(renderer, 100, k, dark, transparent);
        if (k == 3)
          test::write_picture(
              fmt::format("disc_at_a_tenth_{}{}", dark ? "dark" : "light", transparent ? "" : "_opaque"), after);
        int seen = 0;
        for (int y = -kHalfSide; y < kHalfSide; ++y)
          for (int x = -kHalfSide; x < kHalfSide; ++x) {
            const dvec2 at(kViewWidth / 2.0 + x, kViewHeight / 2.0 + y);
            seen += test::color_difference(test::pixel_at(before, at), test::pixel_at(after, at)) >= 15 ? 1 : 0;
          }
        // All of the square, but for the rings of other taxels that cross it: they are the same in both pictures.
        const double rings = area_of_rings(finger_with_reading(100, k), k, transparent),
                     all = 4.0 * kHalfSide * kHalfSide;
        ASSERT_LT(rings, 0.5 * all) << "most of the square is free";
        EXPECT_GE(seen, all - rings) << "taxel " << k << (dark ? " dark" : " light")
                                     << (transparent ? " transparent" : " opaque");
      }
}

/// Returns the largest difference of a pixel within 2 pixels of a place from the pixel itself in the other image.
double difference_near(const gl::RgbImage& a, const gl::RgbImage& b, const dvec2& at) {
  double largest = 0;
  for (int y = -2; y <= 2; ++y)
    for (int x = -2; x <= 2; ++x)
      largest = std::max(
          largest, test::color_difference(test::pixel_at(a, at + dvec2(x, y)), test::pixel_at(b, at + dvec2(x, y))));
  return largest;
}

TEST(Rings, AreSeenAtRestInBothThemes) {
  test::context();
  SceneRenderer renderer;
  Camera camera = test::finger_camera();
  for (const bool dark : {true, false})
    for (const bool transparent : {true, false}) {
      SceneInput input = finger_with_reading(0, 0);
      input.dark = dark;
      input.overlays.sensor_transparent = transparent;
      renderer.render(input, camera, kViewWidth, kViewHeight);
      const gl::RgbImage with = renderer.picture();
      EXPECT_EQ(renderer.field_numbers().marks.rings, 12);
      input.overlays.receptive_fields = false;
      renderer.render(input, camera, kViewWidth, kViewHeight);
      const gl::RgbImage without = renderer.picture();
      EXPECT_EQ(renderer.field_numbers().marks.rings, 0);
      test::write_picture(fmt::format("rings_{}{}", dark ? "dark" : "light", transparent ? "" : "_opaque"), with);
      const SensorStep& state = input.frame->sensors[0];
      const SensorModel& model = *input.frame->scene->sensors[0];
      int seen = 0, points = 0;
      for (const Taxel& taxel : model.layout.taxels)
        for (const RingPiece& piece : taxel_rings(*model.skin, taxel, model.layout.receptive_field)) {
          const dvec3 p_W = state.X_WM * piece.a;
          const dvec3 n_W = state.X_WM.rotate(model.skin->mesh().face_normals()[at(piece.face)]);
          const Ray ray{camera.eye(), glm::normalize(p_W - camera.eye())};
          const double distance = glm::distance(p_W, camera.eye());
          if (glm::dot(n_W, ray.direction) > -0.3 || cast_geoms(input, {ray.origin, ray.direction, 0.999 * distance}))
            continue;
          const dvec2 pixel(camera.project(p_W, kViewWidth, kViewHeight));
          if (pixel.x < 3 || pixel.y < 3 || pixel.x > kViewWidth - 3 || pixel.y > kViewHeight - 3) continue;
          ++points;
          seen += difference_near(with, without, pixel) >= 15 ? 1 : 0;
        }
      EXPECT_GT(points, 100);
      EXPECT_GT(seen, 0.97 * points) << (dark ? "dark" : "light") << (transparent ? " transparent" : " opaque");
    }
}

/// A contact of one triangle with a force of 1 mN.
ContactSurface small_contact() {
  ContactSurface surface;
  for (int i = 0; i < 3; ++i) surface.vertices.push_back(dvec3(0));
  ContactPolygon& polygon = surface.polygons.emplace_back();
  polygon.count = 3;
  polygon.pressure = 1000;
  polygon.area = 1e-6;
  return surface;
}

TEST(ForceMarks, HaveAScaleThatFitsTheSensor) {
  std::shared_ptr<SimFrame> frame;
  SceneInput input = balls(1, 3, frame);
  SensorStep& state = frame->sensors[0];
  state.surfaces.push_back(small_contact());
  state.force_W = {0, 0, 0.84};
  std::vector<SensorView> views = sensor_views(input);
  ASSERT_EQ(force_marks(input, views).size(), 1U);
  EXPECT_EQ(force_of_named_arrow(views), 1) << "10 mm = 1 N";
  EXPECT_NEAR(glm::distance(force_marks(input, views)[0].base_W, force_marks(input, views)[0].tip_W), 0.0084, 1e-12);
  EXPECT_EQ(force_text(force_marks(input, views)[0].force), "0.84 N");
  state.force_W = {0, 0, 30};
  views = sensor_views(input);
  EXPECT_EQ(force_of_named_arrow(views), 10) << "an arrow of 300 mm does not fit";
  EXPECT_NEAR(glm::distance(force_marks(input, views)[0].base_W, force_marks(input, views)[0].tip_W), 0.03, 1e-12);
  bool written = false;
  for (const SceneLabel& label : scene_labels(input, Camera{}, kViewWidth, kViewHeight, {.text_height = 13}))
    written = written || label.text == "30.00 N";
  EXPECT_TRUE(written);
  input.overlays.contact_surface = false;
  EXPECT_TRUE(force_marks(input, views).empty());
}

TEST(ForceMarks, HaveTheirValueBeyondTheTipInEachDirection) {
  std::shared_ptr<SimFrame> frame;
  const SceneInput input = balls(1, 3, frame);
  SensorStep& state = frame->sensors[0];
  state.surfaces.push_back(small_contact());
  const Camera camera;
  for (const dvec3& force_W : {dvec3(0, 0, 0.9), dvec3(0.6, 0.6, 0), dvec3(-0.6, -0.6, 0), dvec3(-0.6, 0.3, 0.6)}) {
    state.force_W = force_W;
    const ForceMark mark = force_marks_aside(input, sensor_views(input), camera).at(0);
    const dvec2 base(camera.project(mark.base_W, kViewWidth, kViewHeight));
    const dvec2 tip(camera.project(mark.tip_W, kViewWidth, kViewHeight));
    const std::vector<SceneLabel> labels = scene_labels(input, camera, kViewWidth, kViewHeight, {.text_height = 13});
    const auto label =
        std::find_if(labels.begin(), labels.end(), [](const SceneLabel& each) { return each.text.ends_with(" N"); });
    ASSERT_NE(label, labels.end());
    for (int i = 0; i <= 100; ++i) {
      const dvec2 off = glm::abs(glm::mix(base, tip, 0.01 * i) - label->pixel);
      EXPECT_TRUE(off.x > label->half.x || off.y > label->half.y) << force_W.x << ": the value covers the arrow";
    }
  }
}

/// Returns a level contact: a disc of this radius [m] at a height.
ContactSurface level_disc(double radius, double height) {
  constexpr int kCorners = 24;
  ContactSurface surface;
  ContactPolygon& polygon = surface.polygons.emplace_back();
  for (int i = 0; i < kCorners; ++i) {
    const double turn = 2 * kPi * i / kCorners;
    surface.vertices.push_back(dvec3(radius * std::cos(turn), radius * std::sin(turn), height));
  }
  polygon.count = kCorners;
  polygon.centroid = {0, 0, height};
  polygon.pressure = 1000;
  polygon.area = kPi * radius * radius;
  return surface;
}

TEST(ForceMarks, AreNextToTheContactFromAllSides) {
  std::shared_ptr<SimFrame> frame;
  SceneInput input = balls(1, 3, frame);
  SensorStep& state = frame->sensors[0];
  state.surfaces.push_back(level_disc(0.004, -0.018));
  state.force_W = {0.2, -0.1, 0.8};
  const std::vector<SensorView> views = sensor_views(input);
  for (const double elevation : {10.0, 42.0, 85.0}) {
    for (double azimuth = -180; azimuth < 180; azimuth += 15) {
      Camera camera;
      camera.azimuth_deg = azimuth;
      camera.elevation_deg = elevation;
      const std::vector<ForceMark> marks = force_marks_aside(input, views, camera);
      ASSERT_EQ(marks.size(), 1U);
      EXPECT_LT(glm::distance(marks[0].tip_W - marks[0].base_W, 0.01 * state.force_W), 1e-12) << "as long as before";
      for (const double along : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        const dvec3 p_W = glm::mix(marks[0].base_W, marks[0].tip_W, along);
        const dvec3 pixel = camera.project(p_W, kViewWidth, kViewHeight);
        const Ray ray = camera.pixel_ray(pixel.x, pixel.y, kViewWidth, kViewHeight);
        const dvec3 at = ray.origin + (-0.018 - ray.origin.z) / ray.direction.z * ray.direction;
        EXPECT_GT(std::hypot(at.x, at.y), 0.004) << azimuth << " " << elevation << " " << along;
      }
    }
  }
}

TEST(SceneLabels, HaveNoIdOfTheFarSideOfAnOpaqueSkin) {
  std::shared_ptr<SimFrame> frame;
  SceneInput input = balls(1, 12, frame);
  const auto ids = [&] {
    std::set<int> taxels;
    for (const SceneLabel& label : scene_labels(input, Camera{}, kViewWidth, kViewHeight, {.text_height = 13}))
      taxels.insert(label.taxel);
    return taxels;
  };
  const std::vector<SensorView> views = sensor_views(input);
  for (const bool all : {true, false}) {
    input.overlays.all_taxels = all;
    frame->sensors[0].readings.assign(12, 500.0);
    input.overlays.sensor_transparent = true;
    const std::set<int> through = ids();
    input.overlays.sensor_transparent = false;
    const std::set<int> opaque = ids();
    EXPECT_GE(opaque.size(), 4U);
    if (!all) {
      EXPECT_LT(opaque.size(), through.size());
    }
    for (const int k : opaque) EXPECT_EQ(sighting(input, views, views[0], k, Camera{}.eye()), Sighting::clear) << k;
  }
}

/// Returns the value of a row of the legend, or "none".
std::string row(const SceneInput& input, const std::string& name) {
  FieldNumbers numbers;
  numbers.marks = {.arrows = 3, .discs = 2, .rings = 1, .samples = 400, .forces = 1};
  for (const MarkRow& each : mark_rows(input, numbers, ReadingUnit{}))
    if (each.name == name) return each.value;
  return "none";
}

TEST(MarkLegend, NamesEveryKindOfMarkWithItsUnit) {
  std::shared_ptr<SimFrame> frame;
  SceneInput input = balls(1, 3, frame);
  frame->sensors[0].surfaces.push_back(small_contact());
  frame->sensors[0].force_W = {0, 0, 0.84};
  auto scene = std::make_shared<SimScene>(*frame->scene);
  scene->path_W = {{0, 0, 0}, {0.03, 0, 0}, {0.03, 0.02, 0}};
  frame->scene = scene;
  frame->constraint_points = {{{}, {}, true}, {{}, {}, false}};
  frame->perturbed.emplace();
  input.before = frame;
  input.overlays.contact_edges = input.overlays.sample_normals = true;
  input.measure_points = {{0, 0, 0}, {1, 0, 0}};
  EXPECT_EQ(row(input, "Net force"), "10 mm = 1 N");
  EXPECT_EQ(row(input, "Path of the finger"), "50.0 mm");
  EXPECT_EQ(row(input, "Rays to the contact"), "true length, mm");
  EXPECT_EQ(row(input, "Pressure at their ends"), "kPa");
  EXPECT_EQ(row(input, "Readings of fields"), "kPa");
  EXPECT_NE(row(input, "Normals of taxels").find("mm long"), std::string::npos);
  EXPECT_EQ(row(input, "Receptive fields"), "true size, mm");
  EXPECT_EQ(row(input, "Samples"), "400");
  for (const char* name : {"Edges of polygons", "Previous step", "Normals of samples", "Measured distance",
                           "Pull on the body", "Held fixed (weld)", "Held at a point"})
    EXPECT_NE(row(input, name), "none") << name;
  input.overlays.path = input.overlays.rays = false;
  EXPECT_EQ(row(input, "Path of the finger"), "none") << "no path is drawn";
  EXPECT_EQ(row(input, "Rays to the contact"), "none");
}

}  // namespace
}  // namespace taxel::ui
