// A body that is pulled or turned with the mouse.
#include <gtest/gtest.h>

#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/perturb/perturb_state.h"
#include "ui/tools/pointer.h"
#include "ui/tools/tool_scene.h"

namespace taxel::ui {
namespace {

/// A selected body at the origin that is drawn as a ball.
struct HeldBody {
  test::ToolScene scene{{dvec3(1, 0, 0)}};
  HeldBody() {
    const auto world = std::make_shared<SimScene>();
    SceneGeom ball;
    ball.name = ball.body = "ball";
    ball.body_index = 1;
    ball.mesh = scene.app.shown->document.model->mesh;
    ball.rgba = {1, 1, 1, 1};
    world->geoms.push_back(ball);
    const auto frame = std::make_shared<SimFrame>();
    frame->scene = world;
    frame->geom_poses = {Pose{}};
    scene.app.shown->run.frame = frame;
    scene.app.viewer->mode = Mode::simulate;
    scene.app.viewer->selection.body = 1;
    scene.app.get<PerturbState>().geom = 0;
  }
  bool handle(PointerEvent event, bool alt = false, bool shift = false) {
    event.ctrl = true, event.alt = alt, event.shift = shift;
    return handle_perturb_mouse(*scene.app.ui, *scene.app.viewer, scene.app.shown->run, scene.app.get<PerturbState>(),
                                event);
  }
  [[nodiscard]] Perturb newest() const { return std::get<Perturb>(scene.asked<EditSceneCommand>()->edit); }
  /// The effect of a drag to the right with these keys.
  Perturb dragged(std::size_t button, bool alt, bool shift) {
    handle(test::press({400, 300}, button), alt, shift);
    handle(test::drag({440, 300}, {40, 0}, button), alt, shift);
    const Perturb perturb = newest();
    handle(test::release({440, 300}, true, button));
    EXPECT_EQ(newest().kind, Perturb::Kind::none);
    return perturb;
  }
};

TEST(BodyDrag, TurnsByCtrlAndPullsByCtrlAltOrRightButton) {
  HeldBody body;
  const Perturb turned = body.dragged(0, false, false);
  EXPECT_EQ(turned.kind, Perturb::Kind::turn);
  EXPECT_GT(glm::axis(turned.turned_W).z, 0.999) << "to the right: about z, as the near side goes";
  const Perturb moved = body.dragged(0, true, false);
  EXPECT_EQ(moved.kind, Perturb::Kind::pull);
  const Perturb pulled = body.dragged(1, false, false);
  EXPECT_EQ(pulled.kind, Perturb::Kind::pull);
  EXPECT_GT(pulled.moved_W.y, 0.001) << "y is to the right";
  EXPECT_NEAR(pulled.moved_W.y, moved.moved_W.y, 1e-12);
  EXPECT_NEAR(pulled.moved_W.x, 0, 1e-12);
  EXPECT_NEAR(pulled.moved_W.z, 0, 1e-12);
}

TEST(BodyDrag, NeedsCtrl) {
  HeldBody body;
  EXPECT_FALSE(handle_perturb_mouse(*body.scene.app.ui, *body.scene.app.viewer, body.scene.app.shown->run,
                                    body.scene.app.get<PerturbState>(), test::press({400, 300})));
  EXPECT_TRUE(body.scene.app.ui->commands.empty());
}

TEST(BodyDrag, NeedsTheBodyThatIsSelected) {
  HeldBody body;
  body.scene.app.viewer->selection.body = 2;
  EXPECT_FALSE(body.handle(test::press({400, 300})));
}

TEST(BodyDrag, IsRefusedInARecordedStep) {
  HeldBody body;
  auto frame = std::make_shared<SimFrame>(*body.scene.app.shown->run.frame);
  frame->recorded = true;
  body.scene.app.shown->run.frame = frame;
  EXPECT_FALSE(body.handle(test::press({400, 300})));
}

TEST(BodyDrag, PullsAlongTheGroundWithShift) {
  HeldBody body;
  body.handle(test::press({400, 300}, 1));
  body.handle(test::drag({400, 260}, {0, -40}, 1));
  EXPECT_GT(body.newest().moved_W.z, 0.001) << "upwards in the plane that faces the camera";
  body.handle(test::drag({400, 261}, {0, 1}, 1), false, true);
  EXPECT_NEAR(body.newest().moved_W.z, 0, 1e-12);
  EXPECT_LT(body.newest().moved_W.x, -0.001) << "away from the eye";
}

TEST(BodyDrag, IsReleasedWhenTheModeChanges) {
  HeldBody body;
  body.handle(test::press({400, 300}));
  body.scene.app.viewer->mode = Mode::layout;
  EXPECT_TRUE(body.handle(test::drag({410, 300}, {10, 0})));
  EXPECT_EQ(body.newest().kind, Perturb::Kind::none);
  EXPECT_FALSE(body.handle(test::hover({410, 300})));
}

TEST(DeselectBody, ReleasesABodyThatIsPulled) {
  HeldBody body;
  body.handle(test::press({400, 300}));
  deselect_body(*body.scene.app.ui, body.scene.app.viewer->selection, body.scene.app.get<PerturbState>());
  EXPECT_EQ(body.newest().kind, Perturb::Kind::none);
  EXPECT_EQ(body.scene.app.viewer->selection.body, -1);
  EXPECT_EQ(body.scene.app.get<PerturbState>().geom, -1);
}

}  // namespace
}  // namespace taxel::ui
