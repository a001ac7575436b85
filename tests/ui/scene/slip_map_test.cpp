// The slip map: the contact surface in the colours of the part that slips.
#include <gtest/gtest.h>

#include "ui/scene/color_map.h"
#include "ui/scene/finger_view.h"
#include "ui/scene/paint/paint.h"

namespace taxel::ui {
namespace {

/// Returns a root at each polygon, of which those with centroids beyond `limit` in x slip.
StickingFriction roots_on(const ContactSurface& surface, double limit) {
  StickingFriction friction;
  friction.reach = 2e-4;
  for (const ContactPolygon& polygon : surface.polygons)
    friction.roots.push_back({polygon.centroid, polygon.normal, polygon.area, dvec3(0), polygon.centroid.x > limit});
  return friction;
}

int pixels_of(const gl::RgbImage& image, const glm::vec3& color) {
  int count = 0;
  for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
    bool same = true;
    for (std::size_t k = 0; k < 3; ++k)
      same = same && std::abs(image.rgb[i + k] - std::lround(255 * color[static_cast<int>(k)])) <= 1;
    count += same ? 1 : 0;
  }
  return count;
}

class SlipMapTest : public FingerView {
 protected:
  /// Draws the contact alone, with friction that slips beyond `limit`; without memory if there is no limit.
  gl::RgbImage draw_contact(std::optional<double> limit, bool slip_map) {
    auto frame = std::make_shared<SimFrame>(*frame_);
    frame->sensors[0].force_W = dvec3(0);  // no arrow in front of the contact
    if (limit)
      for (const ContactSurface& surface : frame->sensors[0].surfaces)
        frame->sensors[0].sticking.push_back(roots_on(surface, *limit));
    SceneInput input = test::finger_input(frame);
    Overlays& show = input.overlays;
    show.rays = show.samples = show.taxels = show.taxel_labels = show.receptive_fields = show.path = show.grid = false;
    show.contact_surface = true;
    show.slip_map = slip_map;
    return draw(input, from_above());
  }
};

TEST(SlipValues, AreThoseOfTheNearestRoots) {
  ContactSurface surface;
  for (const double x : {-0.002, 0.0, 0.002}) {
    surface.vertices.emplace_back(x, 0, 0);
    surface.pressure.push_back(1e4);
  }
  StickingFriction friction;
  friction.reach = 0.001;
  friction.roots = {{{-0.001, 0, 0}, {0, 0, 1}, 1e-6, dvec3(0), false},
                    {{0.001, 0, 0}, {0, 0, 1}, 1e-6, dvec3(0), true}};
  EXPECT_EQ(slip_values(surface, friction), (std::vector<double>{0, 0.5, 1}));
  EXPECT_EQ(slip_values(surface, {}), (std::vector<double>{0, 0, 0}));
}

TEST_F(SlipMapTest, ColoursThePartThatSlipsBrightAndTheRestDark) {
  const glm::vec3 sticks = kSlipRange.color(0), slips = kSlipRange.color(1);
  const ContactSurface& surface = frame_->sensors[0].surfaces[0];
  const gl::RgbImage all_slips = draw_contact(-1, true), all_sticks = draw_contact(1, true);
  const int all = pixels_of(all_slips, slips);
  EXPECT_GT(all, 1000);
  EXPECT_EQ(pixels_of(all_slips, sticks), 0);
  EXPECT_NEAR(pixels_of(all_sticks, sticks), all, 0.001 * all);  // a few pixels of the skin have the dark colour
  EXPECT_EQ(pixels_of(all_sticks, slips), 0);
  dvec3 middle(0);
  double area = 0;
  for (const ContactPolygon& polygon : surface.polygons)
    middle += polygon.area * polygon.centroid, area += polygon.area;
  const gl::RgbImage half = draw_contact(middle.x / area, true);
  test::write_picture("slip_map", half);
  EXPECT_GT(pixels_of(half, sticks), 0.2 * all);
  EXPECT_GT(pixels_of(half, slips), 0.2 * all);
}

TEST_F(SlipMapTest, LeavesThePressureWhereFrictionHasNoMemory) {
  const gl::RgbImage pressure = draw_contact({}, false);
  EXPECT_EQ(draw_contact({}, true).rgb, pressure.rgb);
  EXPECT_EQ(draw_contact(0, false).rgb, pressure.rgb);
  EXPECT_NE(draw_contact(0, true).rgb, pressure.rgb);
}

}  // namespace
}  // namespace taxel::ui
