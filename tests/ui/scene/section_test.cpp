// The section through a taxel: plane, outlines of bodies, contact and rays.
#include "ui/scene/section.h"

#include <gtest/gtest.h>

#include "app/studio/nouns/section/section_state.h"
#include "core/mesh/make/primitives.h"
#include "core/mesh/tri_mesh.h"
#include "ui/scene/color_map.h"
#include "ui/scene/finger_scene.h"
#include "ui/scene/picture.h"

namespace taxel::ui {
namespace {

class SectionTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    model_ = test::finger_model(8000);
    frame_ = test::finger_frame(model_, 0.003);
  }
  static void TearDownTestSuite() {
    model_.reset();
    frame_.reset();
  }
  static Section section(int taxel) {
    SceneInput input = test::finger_input(frame_);
    input.selected_taxel = taxel;
    return make_section(input, sensor_views(input).front(), 2e-4);
  }
  static dvec3 lift(const SectionPlane& plane, const dvec2& p) {
    return plane.origin_W + p.x * plane.x + p.y * plane.y;
  }
  static SensorModelPtr model_;
  static SimFramePtr frame_;
};
SensorModelPtr SectionTest::model_;
SimFramePtr SectionTest::frame_;

TEST_F(SectionTest, ContainsTheTaxelItsNormalAndTheTravel) {
  const SensorStep& state = frame_->sensors[0];
  for (int k = 0; k < model_->taxel_count(); ++k) {
    const Taxel& taxel = model_->layout.taxels[static_cast<std::size_t>(k)];
    const Section s = section(k);
    EXPECT_NEAR(glm::length(s.plane.origin_W - state.X_WM * taxel.center), 0, 1e-15);
    EXPECT_NEAR(glm::dot(s.plane.z, state.X_WM.rotate(taxel.normal)), 0, 1e-12);
    EXPECT_NEAR(s.plane.z.x, 0, 1e-12);  // the travel is along x
    EXPECT_GT(s.plane.x.x, 0);           // and x points to the right
    EXPECT_NEAR(glm::dot(glm::cross(s.plane.x, s.plane.y), s.plane.z), 1, 1e-12);
    EXPECT_EQ(s.radius, taxel.radius);
  }
}

TEST_F(SectionTest, GivesClosedOutlinesOfTheExactAreaForClosedBodies) {
  // A box is cut across its middle. A sphere cut at a height gives the circle at this height.
  const SectionPlane level{{0, 0, 0.3}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const auto area = [&](const TriMesh& mesh) {
    const auto outlines = join_outlines(slice_mesh(mesh, level.origin_W, level.z), level, Pose{});
    EXPECT_EQ(outlines.size(), 1u);
    EXPECT_TRUE(outlines.front().closed);
    return outlines.front().area;
  };
  EXPECT_NEAR(area(make_box({1, 2, 3})), 8.0, 1e-12);
  EXPECT_NEAR(area(make_icosphere(1, 5)), kPi * (1 - 0.09), 0.01);
  TriMesh box = make_box({1, 1, 1});
  std::vector<ivec3> inward = box.faces();
  for (ivec3& f : inward) std::swap(f[1], f[2]);
  EXPECT_NEAR(area(TriMesh(box.vertices(), inward)), -4.0, 1e-12);  // a cavity
}

TEST_F(SectionTest, GivesContactPiecesOnTheSurfaceWithItsPressure) {
  const SensorStep& state = frame_->sensors[0];
  const Section s = section(-1);
  ASSERT_GT(s.contact.size(), 5u);
  double length = 0;
  for (const auto& piece : s.contact) {
    length += glm::length(piece.b - piece.a);
    const dvec3 p_M = state.X_WM.inverse() * lift(s.plane, piece.a);
    double best = std::numeric_limits<double>::infinity();
    for (const ContactPolygon& polygon : state.surfaces[0].polygons) {
      if (std::abs(glm::dot(p_M - polygon.centroid, polygon.normal)) > 1e-9) continue;
      const double pressure = polygon.pressure + glm::dot(polygon.gradient, p_M - polygon.centroid);
      best = std::min(best, std::abs(pressure - piece.pressure_a));
    }
    EXPECT_LT(best, 1e-6 * state.surfaces[0].max_pressure());
  }
  EXPECT_GT(length, 0.003);  // some millimetres of contact
}

TEST_F(SectionTest, GivesRaysThatEndOnTheContactOrAreStubs) {
  const Section s = section(-1);
  int hits = 0;
  for (const auto& ray : s.rays) {
    if (!ray.hit) {
      EXPECT_EQ(ray.pressure, 0);
      continue;
    }
    ++hits;
    EXPECT_GE(ray.pressure, 0);
    const dvec3 end = lift(s.plane, ray.to);  // on the box's top, z = 0, or below its edge on the side, x = -25 mm
    EXPECT_LT(std::min(std::abs(end.z), end.z < 0 ? std::abs(end.x + 0.025) : 1.0), 2e-5) << end.x << " " << end.z;
  }
  EXPECT_GT(hits, 3);
  for (const auto& sample : s.samples) EXPECT_LT(sample.color, model_->taxel_count());
}

TEST_F(SectionTest, LooksAtTheContactSoCloselyThatItsRaysAreSeen) {
  const Section s = section(-1);
  ASSERT_FALSE(s.contact.empty());
  double longest = 0, farthest = 0;
  for (const Section::RayPiece& ray : s.rays) {
    if (!ray.hit) continue;
    longest = std::max(longest, glm::distance(ray.from, ray.to));
    farthest = std::max({farthest, std::abs(ray.from.x - s.focus.x), std::abs(ray.from.y - s.focus.y)});
  }
  EXPECT_GT(longest, 0.15 * s.size) << "15 pixels in a panel of 200";
  EXPECT_LT(farthest, s.size) << "and all are inside";
}

TEST_F(SectionTest, CutsTheLayoutWithoutASimulation) {
  SceneInput input;
  input.document_model = model_;
  const Section s = make_section(input, sensor_views(input).front(), 2e-4);
  EXPECT_EQ(s.skin.size(), 1u);
  EXPECT_TRUE(s.objects.empty());
  EXPECT_TRUE(s.rays.empty());
  EXPECT_NEAR(std::abs(s.plane.z.x), 1, 1e-12);  // the finger's plane of symmetry
}

TEST_F(SectionTest, ShowsTheContactInItsColoursInThePanel) {
  SceneInput input = test::finger_input(frame_);
  input.overlays.rays = false;
  SectionState state;
  for (const bool dark : {true, false}) {
    input.dark = dark;
    const gl::RgbImage image = test::panel_picture(420, 320, dark, [&] { section_panel(input, state); });
    test::write_picture(dark ? "section_dark" : "section_light", image);
    const glm::vec3 brightest = kColorMaps.front().at(0.95);
    int near_top = 0;
    for (int y = 0; y < image.height; ++y) {
      for (int x = 0; x < image.width; ++x) {
        const auto p = test::pixel_at(image, dvec2(x, y));
        const glm::vec3 c = glm::vec3(p[0], p[1], p[2]) / 255.0f;
        if (glm::length(c - brightest) < 0.12f) ++near_top;
      }
    }
    EXPECT_GT(near_top, 3);
  }
  input.selected_taxel = 3;
  input.overlays.rays = true;
  test::write_picture("section_taxel", test::panel_picture(420, 320, false, [&] { section_panel(input, state); }));
  EXPECT_NO_THROW(test::panel_picture(300, 200, true, [&] { section_panel(SceneInput{}, state); }));
}

}  // namespace
}  // namespace taxel::ui
