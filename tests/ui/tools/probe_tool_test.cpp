// The probe as the pointer moves, presses and releases it.
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/probe/probe_state.h"
#include "ui/tools/pointer.h"
#include "ui/tools/tool_scene.h"

#include <gtest/gtest.h>

namespace taxel::ui {
namespace {

const dvec2 kMiddle(400, 300), kBackground(5, 5);  // [pixels]

/// A probe that was taken up over a ball.
struct ProbeScene {
  test::ToolScene ball{{dvec3(1, 0, 0)}};
  App& app = ball.app;
  ProbeState& probe = app.get<ProbeState>();
  bool has_other_tool = false;

  ProbeScene() { toggle(); }
  void toggle() { toggle_probe(*app.viewer, app.shown->document, probe); }
  bool handle(const PointerEvent& event) {
    return handle_probe_mouse(*app.ui, *app.viewer, *app.shown, has_other_tool, probe, event);
  }
  bool click(const dvec2& at) { return handle(test::press(at)) && handle(test::release(at)); }
  [[nodiscard]] double size() const { return app.shown->document.model->mesh->bounds().diagonal(); }
};

TEST(ProbeTool, IsHeldOnceItIsTakenUp) {
  ProbeScene scene;
  EXPECT_TRUE(scene.probe.on && scene.probe.held);
  EXPECT_FALSE(scene.probe.at) << "the pointer was not over the skin yet";
}

TEST(ProbeTool, StaysOffInSimulate) {
  ProbeScene scene;
  scene.toggle();
  scene.app.viewer->mode = Mode::simulate;
  scene.toggle();
  EXPECT_FALSE(scene.probe.on);
}

TEST(ProbeTool, IsFittedToTheSensorOnce) {
  ProbeScene scene;
  EXPECT_LE(scene.probe.settings.sphere().radius, 0.15 * scene.size());
  scene.probe.settings.depth = 0.3 * scene.size();
  scene.toggle();
  scene.toggle();
  EXPECT_EQ(scene.probe.settings.depth, 0.3 * scene.size());
}

TEST(ProbeTool, FollowsThePointerOverTheSkin) {
  ProbeScene scene;
  EXPECT_FALSE(scene.handle(test::hover(kMiddle))) << "the view shows the object under the pointer";
  ASSERT_TRUE(scene.probe.at);
  EXPECT_LT(glm::distance(*scene.probe.at, dvec3(test::kBallRadius, 0, 0)), 1e-4);
}

TEST(ProbeTool, KeepsItsPlaceNextToTheSkin) {
  ProbeScene scene;
  scene.handle(test::hover(kMiddle));
  const dvec3 before = *scene.probe.at;
  scene.handle(test::hover(kBackground));
  EXPECT_EQ(*scene.probe.at, before);
}

TEST(ProbeTool, IsPutDownAndTakenUpByClicks) {
  ProbeScene scene;
  scene.handle(test::hover(kMiddle));
  EXPECT_TRUE(scene.click(kMiddle));
  EXPECT_FALSE(scene.probe.held);
  EXPECT_TRUE(scene.click(kMiddle));
  EXPECT_TRUE(scene.probe.held);
}

TEST(ProbeTool, IgnoresClicksNextToAProbeThatWasPutDown) {
  ProbeScene scene;
  scene.handle(test::hover(kMiddle));
  scene.click(kMiddle);
  EXPECT_FALSE(scene.handle(test::press(kMiddle + dvec2(40, 0))));
  EXPECT_FALSE(scene.probe.pressed);
}

TEST(ProbeTool, StaysWhereADragLeavesIt) {
  ProbeScene scene;
  scene.handle(test::hover(kMiddle));
  scene.click(kMiddle);
  scene.handle(test::press(kMiddle));
  scene.handle(test::drag(kMiddle + dvec2(30, 0), {30, 0}));
  scene.handle(test::release(kMiddle + dvec2(30, 0), true));
  EXPECT_FALSE(scene.probe.held);
  EXPECT_GT(scene.probe.at->y, 1e-4) << "y is to the right";
}

TEST(ProbeTool, ChangesItsDepthByOneNotchOfTheWheel) {
  ProbeScene scene;
  const double notch = probe_notch(scene.size());
  scene.probe.settings.depth = 2 * notch;
  EXPECT_TRUE(scene.handle(test::wheel(kMiddle, 1)));
  EXPECT_NEAR(scene.probe.settings.depth, 3 * notch, 1e-12);
  EXPECT_FALSE(scene.handle(test::wheel(kBackground, 1))) << "the wheel zooms there";
  EXPECT_NEAR(scene.probe.settings.depth, 3 * notch, 1e-12);
}

TEST(ProbeTool, LimitsItsDepth) {
  ProbeScene scene;
  scene.handle(test::wheel(kMiddle, 1e6));
  EXPECT_EQ(scene.probe.settings.depth, kDeepestProbe * scene.size());
  scene.handle(test::wheel(kMiddle, -1e6));
  EXPECT_EQ(scene.probe.settings.depth, 0);
}

TEST(ProbeTool, LeavesTheWheelToTheClipPlaneWithShift) {
  ProbeScene scene;
  const double before = scene.probe.settings.depth;
  PointerEvent event = test::wheel(kMiddle, 1);
  event.shift = true;
  EXPECT_FALSE(scene.handle(event));
  EXPECT_EQ(scene.probe.settings.depth, before);
}

TEST(ProbeTool, GoesDeeperAsThePointerGoesDown) {
  ProbeScene scene;
  scene.probe.settings.depth = 1e-4;
  scene.handle(test::hover(kMiddle));
  scene.handle(test::press(kMiddle));
  scene.handle(test::drag(kMiddle + dvec2(0, 5), {0, 5}));
  const double coarse = scene.probe.settings.depth - 1e-4;
  EXPECT_GT(coarse, 0);
  PointerEvent fine = test::drag(kMiddle + dvec2(0, 10), {0, 5});
  fine.shift = true;
  scene.handle(fine);
  EXPECT_NEAR(scene.probe.settings.depth, 1e-4 + 1.1 * coarse, 1e-12) << "a tenth with Shift";
}

TEST(ProbeTool, StaysInPlaceWhenAnotherToolBegins) {
  ProbeScene scene;
  scene.handle(test::hover(kMiddle));
  scene.has_other_tool = true;
  EXPECT_FALSE(scene.handle(test::press(kMiddle)));
  EXPECT_FALSE(scene.probe.held || scene.probe.pressed);
  EXPECT_TRUE(scene.probe.on && scene.probe.at);
}

TEST(ProbeTool, LeavesClicksToTheViewWithCtrl) {
  ProbeScene scene;
  PointerEvent event = test::press(kMiddle);
  event.ctrl = true;
  EXPECT_FALSE(scene.handle(event));
  EXPECT_FALSE(scene.probe.pressed);
}

TEST(ProbeTool, ForgetsItsPlaceWhenItIsLeft) {
  ProbeScene scene;
  scene.handle(test::hover(kMiddle));
  scene.probe.largest = 7;
  leave_probe(scene.probe);
  EXPECT_FALSE(scene.probe.on || scene.probe.held || scene.probe.at);
  EXPECT_EQ(scene.probe.largest, 0);
}

TEST(ProbeRequest, NeedsAPlaceInLayout) {
  ProbeScene scene;
  EXPECT_FALSE(probe_request(*scene.app.viewer, scene.probe));
  scene.handle(test::hover(kMiddle));
  scene.probe.settings.depth = 5e-4;
  const std::optional<Probe> request = probe_request(*scene.app.viewer, scene.probe);
  ASSERT_TRUE(request);
  EXPECT_EQ(request->point, *scene.probe.at);
  EXPECT_EQ(request->depth, 5e-4);
  scene.app.viewer->mode = Mode::simulate;
  EXPECT_FALSE(probe_request(*scene.app.viewer, scene.probe));
}

TEST(ProbeNotch, IsARoundPartOfTheSensorsSize) {
  EXPECT_NEAR(probe_notch(0.012), 5e-5, 1e-12);
  EXPECT_NEAR(probe_notch(0.025), 1e-4, 1e-12);
  EXPECT_NEAR(probe_notch(0.06), 2e-4, 1e-12);
}

}  // namespace
}  // namespace taxel::ui
