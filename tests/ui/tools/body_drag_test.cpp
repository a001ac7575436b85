// A body that is pulled or turned with the mouse.
#include <gtest/gtest.h>

#include "app/studio/features/perturb/perturb_tool.h"
#include "ui/tools/interface_frames.h"
#include "ui/tools/tool_scene.h"

namespace taxel::ui {
namespace {

/// A selected body at the origin that is drawn as a ball.
struct HeldBody {
  test::InterfaceFrames interface;
  test::ToolScene scene{{dvec3(1, 0, 0)}};
  HeldBody() {
    const auto world = std::make_shared<SimScene>();
    SceneGeom ball{"ball", "ball", 0, scene.app.shown.document.model->mesh, {1, 1, 1, 1}, false, -1};
    ball.body_index = 1;
    world->geoms.push_back(ball);
    const auto frame = std::make_shared<SimFrame>();
    frame->scene = world;
    frame->geom_poses = {Pose{}};
    scene.app.shown.run.frame = frame;
    scene.app.viewer.mode = Mode::simulate;
    scene.app.viewer.selection.body = 1;
    scene.app.simulate.perturb.geom = 0;
  }
  /// Returns the perturbation that a drag to the right with these keys requests.
  Perturb dragged(int button, bool alt, bool shift) {
    const auto at = [&](double x) {
      interface.move(x, 300);
      interface.frame([&] {
        handle_perturb_mouse(scene.app.ui, scene.app.viewer, scene.app.shown.run, scene.app.simulate.perturb, x, 300,
                             true);
      });
    };
    at(400);
    interface.key(ImGuiMod_Ctrl, true);
    if (alt) interface.key(ImGuiMod_Alt, true);
    if (shift) interface.key(ImGuiMod_Shift, true);
    ImGui::GetIO().AddMouseButtonEvent(button, true);
    at(400);
    at(440);
    const auto* command = scene.asked<SendCommand>();
    Perturb perturb = std::get<Perturb>(std::get<EditSceneCommand>(command->command).edit);
    ImGui::GetIO().AddMouseButtonEvent(button, false);
    for (const ImGuiKey key : {ImGuiMod_Ctrl, ImGuiMod_Alt, ImGuiMod_Shift}) interface.key(key, false);
    at(440);
    command = scene.asked<SendCommand>();
    EXPECT_EQ(std::get<Perturb>(std::get<EditSceneCommand>(command->command).edit).kind, Perturb::Kind::none);
    return perturb;
  }
};

TEST(BodyDrag, TurnsByCtrlAndPullsByCtrlAltOrRightButton) {
  HeldBody body;
  const Perturb turned = body.dragged(ImGuiMouseButton_Left, false, false);
  EXPECT_EQ(turned.kind, Perturb::Kind::turn);
  EXPECT_GT(glm::axis(turned.turned_W).z, 0.999) << "to the right: about z, as the near side goes";
  const Perturb moved = body.dragged(ImGuiMouseButton_Left, true, false);
  EXPECT_EQ(moved.kind, Perturb::Kind::pull);
  const Perturb pulled = body.dragged(ImGuiMouseButton_Right, false, false);
  EXPECT_EQ(pulled.kind, Perturb::Kind::pull);
  EXPECT_GT(pulled.moved_W.y, 0.001) << "y is to the right";
  EXPECT_NEAR(pulled.moved_W.y, moved.moved_W.y, 1e-12);
  EXPECT_NEAR(pulled.moved_W.x, 0, 1e-12);
  EXPECT_NEAR(pulled.moved_W.z, 0, 1e-12);
}

}  // namespace
}  // namespace taxel::ui
