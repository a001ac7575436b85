// The mesh: tip and pad of the finger, and the text about the repair.
#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/history/edit_commands.h"
#include "app/studio/nouns/mesh/mesh_state.h"
#include "app/studio/nouns/taxel/tool_state.h"
#include "ui/tools/tool_scene.h"

namespace taxel::ui {
namespace {

/// A ball whose tip and pad can be set.
struct FrameBall : test::ToolScene {
  MeshState mesh;
  FrameBall() : ToolScene({}) {}
  bool click(double x, double y) {
    return pick_frame(*app.ui, *app.viewer, *app.shown, app.get<ToolState>(), mesh, x, y);
  }
};

TEST(WithDirection, SnapsToAnAxisWithin25Degrees) {
  const double angle = glm::radians(24.0);
  const SensorFrame near = with_direction({}, FramePick::pad, {std::cos(angle), 0, std::sin(angle)});
  EXPECT_EQ(near.pad, dvec3(1, 0, 0));
  EXPECT_EQ(near.distal, dvec3(0, 0, 1));
  const dvec3 far(std::cos(glm::radians(26.0)), std::sin(glm::radians(26.0)), 0);
  EXPECT_LT(glm::distance(with_direction({}, FramePick::pad, far).pad, far), 1e-15);
}

TEST(WithDirection, ExchangesDirectionsThatWouldBeParallel) {
  const SensorFrame frame{{0, 0, 1}, {0, -1, 0}};
  const SensorFrame pad_up = with_direction(frame, FramePick::pad, {0, 0, 1});
  EXPECT_EQ(pad_up.pad, dvec3(0, 0, 1));
  EXPECT_EQ(pad_up.distal, dvec3(0, -1, 0)) << "where the pad was";
  const SensorFrame tip_back = with_direction(frame, FramePick::tip, {0, 1, 0});
  EXPECT_EQ(tip_back.distal, dvec3(0, 1, 0));
  EXPECT_EQ(tip_back.pad, dvec3(0, 0, 1)) << "where the tip was";
}

TEST(WithDirection, TurnsTheOtherDirectionToARightAngle) {
  const double half = std::sqrt(0.5);
  const SensorFrame frame = with_direction({{0, 0, 1}, {0, -1, 0}}, FramePick::tip, {0, -half, half});
  EXPECT_LT(glm::distance(frame.distal, dvec3(0, -half, half)), 1e-15);
  EXPECT_LT(glm::distance(frame.pad, dvec3(0, -half, -half)), 1e-15);
}

TEST(FrameArrows, AppearWhileTheFrameIsAGuess) {
  FrameBall ball;
  EXPECT_TRUE(frame_arrows(*ball.app.viewer, *ball.app.shown, ball.mesh).empty());
  ball.mesh.frame_is_guess = true;
  EXPECT_EQ(frame_arrows(*ball.app.viewer, *ball.app.shown, ball.mesh).size(), 2U);
  ball.app.viewer->mode = Mode::simulate;
  EXPECT_TRUE(frame_arrows(*ball.app.viewer, *ball.app.shown, ball.mesh).empty());
}

TEST(FrameArrows, ReachThreeTenthsBeyondTheMesh) {
  FrameBall ball;
  ball.mesh.pick = FramePick::tip;
  const std::vector<FrameArrow> arrows = frame_arrows(*ball.app.viewer, *ball.app.shown, ball.mesh);
  ASSERT_EQ(arrows.size(), 2U);
  EXPECT_LT(glm::length(arrows[0].from_W), 1e-12);
  EXPECT_LT(glm::distance(arrows[0].to_W, 1.3 * test::kBallRadius * dvec3(0, 0, 1)), 1e-12) << "tip";
  EXPECT_LT(glm::distance(arrows[1].to_W, 1.3 * test::kBallRadius * dvec3(0, -1, 0)), 1e-12) << "pad";
}

TEST(PickFrame, SetsThePadToTheFaceUnderThePointer) {
  FrameBall ball;
  ball.mesh.frame_is_guess = true;
  ball.mesh.pick = FramePick::pad;
  EXPECT_TRUE(ball.click(400, 300));
  EXPECT_EQ(std::get<SetFrame>(ball.asked<EditProject>()->edit).frame.pad, dvec3(1, 0, 0));
  EXPECT_FALSE(ball.mesh.frame_is_guess) << "the user has set the pad";
  EXPECT_EQ(ball.mesh.pick, FramePick::none) << "the next click does something else";
}

TEST(PickFrame, KeepsWaitingAfterAClickOnTheBackground) {
  FrameBall ball;
  ball.mesh.pick = FramePick::tip;
  EXPECT_TRUE(ball.click(5, 5)) << "the click does not select";
  EXPECT_EQ(ball.mesh.pick, FramePick::tip);
  EXPECT_TRUE(ball.app.ui->commands.empty());
}

TEST(PickFrame, LeavesOtherClicksAlone) {
  FrameBall ball;
  EXPECT_FALSE(ball.click(400, 300));
  ball.mesh.pick = FramePick::tip;
  ball.app.viewer->mode = Mode::simulate;
  EXPECT_FALSE(ball.click(400, 300));
  EXPECT_TRUE(ball.app.ui->commands.empty());
}

/// A model of a closed tetrahedron that was repaired.
SensorModel repaired_tetrahedron(const RepairReport& report) {
  const std::vector<dvec3> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const std::vector<ivec3> faces{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  RepairedMesh repaired;
  repaired.mesh = std::make_shared<const TriMesh>(corners, faces);
  repaired.report = report;
  SensorModel model;
  model.loaded = std::make_shared<const TriMesh>(corners, std::vector<ivec3>(faces.begin(), faces.end() - 1));
  model.mesh = repaired.mesh;
  model.repaired = std::make_shared<const RepairedMesh>(std::move(repaired));
  return model;
}

TEST(MeshStateText, SaysWhetherAnUnrepairedMeshIsClosed) {
  SensorModel model = repaired_tetrahedron({});
  model.loaded = model.mesh;
  EXPECT_EQ(mesh_state_text(model), "closed");
  SensorModel open = repaired_tetrahedron({});
  open.mesh = open.loaded;
  EXPECT_EQ(mesh_state_text(open), "open");
}

TEST(MeshStateText, GivesTheDistancesOfAWrap) {
  RepairReport report;
  report.level = RepairLevel::wrap;
  report.distance_rms = 0.12e-3, report.distance_max = 0.5e-3;
  EXPECT_EQ(mesh_state_text(repaired_tetrahedron(report)), "wrapped, off by 0.120 mm rms, 0.500 mm at most");
}

TEST(MeshStateText, GivesTheLargestMoveOfAnExactRepair) {
  RepairReport report;
  report.level = RepairLevel::exact;
  EXPECT_EQ(mesh_state_text(repaired_tetrahedron(report)), "repaired exactly, no vertex moved");
  report.vertices_moved = 2, report.largest_move = 0.3e-3;
  EXPECT_EQ(mesh_state_text(repaired_tetrahedron(report)), "repaired exactly, moved by 0.3000 mm at most");
  report.largest_move = 4e-8;
  EXPECT_EQ(mesh_state_text(repaired_tetrahedron(report)), "repaired exactly, joined within rounding");
}

}  // namespace
}  // namespace taxel::ui
