// Generating taxels: the frame and the lengths of a pattern, its preview, and adding the previewed taxels.
#include <gtest/gtest.h>

#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/generate/generate_state.h"
#include "app/studio/nouns/history/edit_commands.h"
#include "ui/tools/tool_scene.h"

namespace taxel::ui {
namespace {

/// A ball with taxel 1, and the Generate panel.
struct GenerateBall : test::ToolScene {
  ToolState tool;
  GenerateState generate;
  GenerateBall() : ToolScene({dvec3(1, 0, 0)}) {}
  void toggle() { toggle_generate(*app.ui, *app.viewer, *app.shown, tool, generate); }
  void keep_current() { keep_preview_current(*app.viewer, *app.shown, generate); }
  [[nodiscard]] bool can_accept() const { return can_accept_generate(*app.viewer, *app.shown, generate); }
  /// Returns the pattern, which is a grid.
  patterns::Grid& grid() { return std::get<patterns::Grid>(generate.pattern.shape); }
  /// Returns the last values of a kind.
  template <class Kind>
  [[nodiscard]] const Kind& last() const {
    return std::get<Kind>(generate.shapes[PatternShape(Kind()).index()]);
  }
  /// The preview of the present pattern arrives: one taxel with an id that is in use.
  void preview_arrives() {
    Taxel taxel;
    taxel.id = 1;
    generate.ghosts = std::make_shared<const std::vector<Taxel>>(1, taxel);
    generate.shown = generate.number;
  }
};

TEST(TurnPattern, TurnsFiveDegreesPerNotch) {
  GenerateState generate;
  turn_pattern(generate, 3);
  EXPECT_EQ(generate.pattern.turn_deg, 15);
  generate.pattern.turn_deg = 175;
  turn_pattern(generate, 2);
  EXPECT_EQ(generate.pattern.turn_deg, -175) << "beyond half a turn";
}

TEST(OpenGenerate, PutsTheFrameOnThePadFromAnyView) {
  for (const dvec3 target : {dvec3(0), dvec3(0, 0.05, 0)}) {
    GenerateBall ball;
    ball.app.viewer->camera().target = target;
    ball.toggle();
    const PlacingFrame& frame = ball.generate.frame;
    EXPECT_LT(glm::distance(frame.center, dvec3(0, -test::kBallRadius, 0)), 1e-6) << "the pad of a new layout is -y";
    EXPECT_LT(frame.normal.y, -0.99);
    EXPECT_NEAR(glm::dot(frame.along_row, frame.normal), 0, 1e-12);
  }
}

TEST(OpenGenerate, SetsLengthsInHalfMillimetres) {
  GenerateBall ball;  // the diagonal of its box is 20 mm times the root of 3: 34.64 mm
  ball.toggle();
  EXPECT_NEAR(ball.grid().row_pitch, 0.004, 1e-15) << "0.11 of 34.64 mm is 3.81 mm";
  EXPECT_NEAR(ball.generate.pattern.radius, 0.003, 1e-15) << "0.8 of 4 mm is 3.2 mm";
  EXPECT_NEAR(ball.last<patterns::Spiral>().disc_radius, 0.007, 1e-15) << "0.2 of 34.64 mm is 6.93 mm";
  EXPECT_NEAR(ball.last<patterns::Helix>().rise, 0.0085, 1e-15) << "0.25 of 34.64 mm is 8.66 mm";
  EXPECT_NEAR(ball.last<patterns::Image>().width, 0.014, 1e-15) << "0.4 of 34.64 mm is 13.86 mm";
}

TEST(OpenGenerate, RestoresTheLengthsOfTheUser) {
  GenerateBall ball;
  ball.toggle();
  ball.grid().row_pitch = 0.001;
  ball.toggle();
  ball.toggle();
  EXPECT_TRUE(ball.generate.open);
  EXPECT_EQ(ball.grid().row_pitch, 0.001);
}

TEST(KeepPreviewCurrent, RequestsAPreviewPerChange) {
  GenerateBall ball;
  ball.toggle();
  ball.keep_current();
  const std::uint64_t first = ball.generate.number;
  EXPECT_TRUE(ball.generate.waiting());
  ball.keep_current();
  EXPECT_EQ(ball.generate.number, first) << "without a change";
  ball.grid().rows = 7;
  ball.keep_current();
  EXPECT_EQ(ball.generate.number, first + 1);
}

TEST(KeepPreviewCurrent, IgnoresTheFrameOfAnEvenSpread) {
  GenerateBall ball;
  ball.toggle();
  change_kind<patterns::Spread>(ball.generate);
  ball.keep_current();
  const std::uint64_t first = ball.generate.number;
  ball.generate.frame.center = {0, 0, test::kBallRadius};
  ball.keep_current();
  EXPECT_EQ(ball.generate.number, first);
  ball.project.layout.sampling.region = std::vector<int>{0, 1};
  ball.publish();
  ball.keep_current();
  EXPECT_EQ(ball.generate.number, first + 1) << "the taxels spread over the painted region";
}

TEST(KeepPreviewCurrent, ClosesThePanelInSimulate) {
  GenerateBall ball;
  ball.toggle();
  ball.app.viewer->mode = Mode::simulate;
  ball.keep_current();
  EXPECT_FALSE(ball.generate.open);
  EXPECT_FALSE(ball.generate.waiting());
}

TEST(CanAcceptGenerate, NeedsThePreviewOfThePresentPattern) {
  GenerateBall ball;
  ball.toggle();
  ball.keep_current();
  EXPECT_FALSE(ball.can_accept()) << "the preview is being made";
  ball.preview_arrives();
  EXPECT_TRUE(ball.can_accept());
  ball.generate.pattern.radius *= 2;
  EXPECT_FALSE(ball.can_accept()) << "the preview is of another radius";
}

TEST(CanAcceptGenerate, NeedsATaxel) {
  GenerateBall ball;
  ball.toggle();
  ball.keep_current();
  ball.preview_arrives();
  ball.generate.ghosts = std::make_shared<const std::vector<Taxel>>();
  EXPECT_FALSE(ball.can_accept());
}

TEST(AcceptGenerate, AddsAndSelectsTaxelsWithNewIds) {
  GenerateBall ball;
  ball.toggle();
  ball.keep_current();
  ball.preview_arrives();
  accept_generate(*ball.app.ui, *ball.app.viewer, *ball.app.shown, ball.generate);
  const auto& added = std::get<AddTaxels>(ball.asked<EditProject>()->edit).taxels;
  ASSERT_EQ(added.size(), 1U);
  EXPECT_EQ(added[0].id, 2) << "taxel 1 exists";
  EXPECT_EQ(ball.app.viewer->selection.taxels, (std::vector<int>{2}));
  EXPECT_FALSE(ball.generate.open);
}

}  // namespace
}  // namespace taxel::ui
