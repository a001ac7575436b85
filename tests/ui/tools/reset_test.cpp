// The state that another document resets, and the state that it keeps.
#include "app/studio/app/reset.h"

#include <gtest/gtest.h>

#include "app/studio/app/values/app_parts.h"

namespace taxel::ui {
namespace {

TEST(ForgetDocument, ClearsSelectionAndClipPlane) {
  App app;
  app.viewer->selection.taxels = {1, 2};
  app.viewer->selection.body = 3;
  app.viewer->clip = ClipPlane{{0, 0, 1}, 0.5};
  forget_document(app);
  EXPECT_EQ(app.viewer->selection, Selection{});
  EXPECT_FALSE(app.viewer->clip);
}

TEST(ForgetDocument, KeepsOverlaysAndMode) {
  App app;
  app.viewer->mode = Mode::layout;
  app.viewer->overlays().grid = false;
  forget_document(app);
  EXPECT_EQ(app.viewer->mode, Mode::layout);
  EXPECT_FALSE(app.viewer->overlays().grid);
}

TEST(ForgetDocument, EndsToolsOfTheLayout) {
  App app;
  app.layout->tool.tool = Tool::brush;
  app.layout->generate.open = true;
  app.layout->measure.on = true;
  app.layout->mesh.pick = FramePick::tip;
  forget_document(app);
  EXPECT_EQ(app.layout->tool.tool, Tool::none);
  EXPECT_FALSE(app.layout->generate.open || app.layout->measure.on);
  EXPECT_EQ(app.layout->mesh.pick, FramePick::none);
}

TEST(ForgetDocument, RemovesTheProbeAndKeepsItsSettings) {
  App app;
  app.layout->probe.on = app.layout->probe.held = app.layout->probe.sized = true;
  app.layout->probe.at = dvec3(1, 2, 3);
  app.layout->probe.largest = 7;
  app.layout->probe.settings.depth = 0.004;
  forget_document(app);
  EXPECT_FALSE(app.layout->probe.on || app.layout->probe.held || app.layout->probe.sized || app.layout->probe.at);
  EXPECT_EQ(app.layout->probe.largest, 0);
  EXPECT_EQ(app.layout->probe.settings.depth, 0.004);
}

TEST(ForgetDocument, StopsThePathRecordingAndKeepsItsInterval) {
  App app;
  app.simulate->path.recording = PathRecording{};
  app.simulate->path.record_every = 0.2;
  forget_document(app);
  EXPECT_FALSE(app.simulate->path.recording);
  EXPECT_EQ(app.simulate->path.record_every, 0.2);
}

TEST(ForgetDocument, ResetsStudyControlsAndGrabbedBody) {
  App app;
  app.simulate->study.count = 9;
  app.simulate->controls.filter = "finger";
  app.simulate->perturb.geom = 2;
  forget_document(app);
  EXPECT_EQ(app.simulate->study.count, StudyState{}.count);
  EXPECT_EQ(app.simulate->controls.filter, "");
  EXPECT_EQ(app.simulate->perturb.geom, -1);
}

TEST(ForgetDocument, KeepsTheWindowsOwnState) {
  App app;
  app.window->panels.help = true;
  app.window->recent = {"a"};
  app.window->messages.push_back({});
  forget_document(app);
  EXPECT_TRUE(app.window->panels.help);
  EXPECT_EQ(app.window->recent.size(), 1U);
  EXPECT_EQ(app.window->messages.size(), 1U);
}

TEST(VisitFeatures, VisitsEachStateOnce) {
  App app;
  int count = 0;
  visit_features(*app.layout, [&](auto&) { ++count; });
  EXPECT_EQ(count, 9);
  visit_features(*app.simulate, [&](auto&) { ++count; });
  EXPECT_EQ(count, 9 + 19);
  visit_features(*app.window, [&](auto&) { ++count; });
  EXPECT_EQ(count, 9 + 19 + 19);
}

}  // namespace
}  // namespace taxel::ui
