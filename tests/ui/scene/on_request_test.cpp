// Frames that are only prepared: no pixel is drawn until a picture is requested, which is then the usual one.
#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include "ui/scene/finger_view.h"

namespace taxel::ui {
namespace {

/// Returns the number of samples that `draw` draws.
template <class Draw>
GLuint samples_of(const Draw& draw) {
  GLuint query = 0, samples = 0;
  glGenQueries(1, &query);
  glBeginQuery(GL_SAMPLES_PASSED, query);
  draw();
  glEndQuery(GL_SAMPLES_PASSED);
  glGetQueryObjectuiv(query, GL_QUERY_RESULT, &samples);
  glDeleteQueries(1, &query);
  return samples;
}

class OnRequest : public FingerView {};

TEST_F(OnRequest, DrawsNothingUntilAPictureIsRequested) {
  SceneInput input = test::finger_input(frame_);
  input.overlays.tractions = true;
  const gl::RgbImage above = draw(input, from_above()), usual = draw(input, test::finger_camera());
  const FieldNumbers numbers = renderer_.field_numbers();
  SceneRenderer other;
  other.set_draws_on_request(true);
  EXPECT_EQ(samples_of([&] { other.render(input, from_above(), kWidth, kHeight); }), 0U);
  EXPECT_EQ(samples_of([&] { other.render(input, test::finger_camera(), kWidth, kHeight); }), 0U);
  EXPECT_EQ(other.field_numbers().marks, numbers.marks);
  ASSERT_TRUE(numbers.tractions && other.field_numbers().tractions);
  EXPECT_EQ(other.field_numbers().tractions->polygons, numbers.tractions->polygons);
  EXPECT_GT(samples_of([&] { other.draw_prepared(); }), 0U);
  EXPECT_EQ(samples_of([&] { other.draw_prepared(); }), 0U) << "it is drawn already";
  EXPECT_EQ(other.picture().rgb, usual.rgb);
  other.render(input, from_above(), kWidth, kHeight);
  EXPECT_EQ(other.picture().rgb, above.rgb) << "a picture needs no other call";
}

/// Shadows and background are kept between frames. A frame that is only prepared must not keep them.
TEST_F(OnRequest, DrawsTheShadowsOfMovedBodies) {
  SceneInput input = test::finger_input(frame_);
  SceneInput moved = input;
  moved.frame = test::finger_frame(model_, 0.006);
  moved.dark = !input.dark;
  const gl::RgbImage usual = draw(moved, from_above());
  SceneRenderer other;
  other.render(input, from_above(), kWidth, kHeight);
  other.set_draws_on_request(true);
  other.render(moved, from_above(), kWidth, kHeight);
  EXPECT_EQ(other.picture().rgb, usual.rgb);
  other.set_draws_on_request(false);
  const gl::RgbImage drawn_again = draw(input, from_above());
  other.render(input, from_above(), kWidth, kHeight);
  EXPECT_EQ(other.picture().rgb, drawn_again.rgb);
}

TEST_F(OnRequest, LeavesExportsAsTheyAre) {
  const SceneInput input = test::finger_input(frame_);
  const gl::RgbaImage usual = renderer_.cut_out(input, from_above(), kWidth, kHeight);
  SceneRenderer other;
  other.set_draws_on_request(true);
  other.render(input, test::finger_camera(), kWidth, kHeight);
  EXPECT_EQ(other.cut_out(input, from_above(), kWidth, kHeight).rgba, usual.rgba);
}

}  // namespace
}  // namespace taxel::ui
