// The brush: its radius, the region it changes, and the faces of skin and mesh.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/brush/brush.h"
#include "app/studio/nouns/history/edit_commands.h"
#include "ui/tools/tool_scene.h"

namespace taxel::ui {
namespace {

/// A ball and a brush on the ball.
struct BrushBall : test::ToolScene {
  ToolState tool;
  BrushBall() : ToolScene({}) {}
  [[nodiscard]] const SensorModel& model() const { return *app.shown->document.model; }
  [[nodiscard]] double diagonal() const { return model().mesh->bounds().diagonal(); }
  [[nodiscard]] std::vector<int> all_faces() const {
    std::vector<int> faces(static_cast<std::size_t>(model().mesh->face_count()));
    std::iota(faces.begin(), faces.end(), 0);
    return faces;
  }
  void paint(const std::vector<int>& faces) {
    project.layout.sampling.region = faces;
    publish();
  }
  /// The region that the last change asks for.
  std::vector<int> changed(RegionChange change) {
    change_region(*app.ui, *app.viewer, *app.shown, change);
    return std::get<SetRegion>(asked<EditProject>()->edit).faces;
  }
};

TEST(BrushRadius, DependsOnTheMeshUntilItIsChosen) {
  BrushBall ball;
  EXPECT_NEAR(brush_radius(ball.tool, ball.model()), 0.06 * ball.diagonal(), 1e-15);
  set_brush_radius(ball.tool, ball.model(), 0.004);
  EXPECT_EQ(brush_radius(ball.tool, ball.model()), 0.004);
}

TEST(SetBrushRadius, LimitsTheRadiusToTheMesh) {
  BrushBall ball;
  set_brush_radius(ball.tool, ball.model(), 10);
  EXPECT_EQ(brush_radius(ball.tool, ball.model()), ball.diagonal());
}

TEST(SetBrushRadius, RefusesRadiiThatAreNotPositive) {
  for (const double radius : {0.0, -0.001, std::nan(""), std::numeric_limits<double>::infinity()}) {
    BrushBall ball;
    ball.tool.brush.radius = 0.003;
    set_brush_radius(ball.tool, ball.model(), radius);
    EXPECT_EQ(ball.tool.brush.radius, 0.003);
    EXPECT_EQ(ball.tool.problem, "Brush radius: must be greater than 0");
  }
}

TEST(ResizeBrush, ChangesTheRadiusByATenthPerNotch) {
  BrushBall ball;
  ball.tool.brush.radius = 0.002;
  resize_brush(ball.tool, ball.model(), 2);
  EXPECT_NEAR(ball.tool.brush.radius, 1.21 * 0.002, 1e-15);
  resize_brush(ball.tool, ball.model(), -2);
  EXPECT_NEAR(ball.tool.brush.radius, 0.002, 1e-15);
}

TEST(ResizeBrush, StopsAtAThousandthOfTheMesh) {
  BrushBall ball;
  resize_brush(ball.tool, ball.model(), -1000);
  EXPECT_NEAR(ball.tool.brush.radius, 1e-3 * ball.diagonal(), 1e-15);
  EXPECT_TRUE(ball.tool.problem.empty());
}

TEST(BrushPlace, IsEmptyOutsideTheSkinAndInSimulate) {
  BrushBall ball;
  const std::optional<SurfacePlace> place = brush_place(*ball.app.viewer, *ball.app.shown, 400, 300);
  ASSERT_TRUE(place);
  EXPECT_LT(glm::distance(place->position, dvec3(test::kBallRadius, 0, 0)), 1e-6);
  EXPECT_FALSE(brush_place(*ball.app.viewer, *ball.app.shown, 5, 5));
  ball.app.viewer->mode = Mode::simulate;
  EXPECT_FALSE(brush_place(*ball.app.viewer, *ball.app.shown, 400, 300));
}

TEST(ChangeRegion, PaintsAllFaces) {
  BrushBall ball;
  ball.paint({3});
  EXPECT_EQ(ball.changed(RegionChange::all), ball.all_faces());
}

TEST(ChangeRegion, InvertsThePaintedFaces) {
  BrushBall ball;
  ball.paint({0, 2});
  std::vector<int> others = ball.all_faces();
  others.erase(others.begin() + 2);
  others.erase(others.begin());
  EXPECT_EQ(ball.changed(RegionChange::invert), others);
}

TEST(ChangeRegion, PostsNoEditWithoutAChange) {
  BrushBall ball;
  change_region(*ball.app.ui, *ball.app.viewer, *ball.app.shown, RegionChange::clear);
  ball.paint(ball.all_faces());
  change_region(*ball.app.ui, *ball.app.viewer, *ball.app.shown, RegionChange::all);
  ball.app.viewer->mode = Mode::simulate;
  change_region(*ball.app.ui, *ball.app.viewer, *ball.app.shown, RegionChange::clear);
  EXPECT_TRUE(ball.app.ui->commands.empty());
}

TEST(SkinFaces, UndoMeshFaces) {
  BrushBall ball;
  const std::vector<int> faces{0, 5, 7};
  EXPECT_EQ(skin_faces(ball.model(), mesh_faces(ball.model(), faces)), faces);
  EXPECT_TRUE(skin_faces(ball.model(), {ball.model().mesh->face_count()}).empty()) << "no face of the mesh";
}

}  // namespace
}  // namespace taxel::ui
