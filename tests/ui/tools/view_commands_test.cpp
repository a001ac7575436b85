// Commands about the window, the 3-D view and the recorded steps.
#include <gtest/gtest.h>

#include "app/studio/app/perform.h"
#include "app/studio/app/values/layout_features.h"
#include "app/studio/app/values/shown.h"
#include "app/studio/app/values/simulate_features.h"
#include "app/studio/app/values/viewer.h"
#include "app/studio/app/values/window_features.h"
#include "app/studio/app/values/window_ui.h"
#include "app/studio/features/camera/camera_follow.h"
#include "ui/tools/running.h"

namespace taxel::ui {
namespace {

using test::Running;

/// A ball with one taxel, open in LAYOUT.
struct Window : test::ToolScene {
  Window() : ToolScene({dvec3(1, 0, 0)}) {}
  template <class C>
  void run(const C& command) {
    perform(command, app);
  }
  template <class C>
  [[nodiscard]] bool checked(const C& command) const {
    return is_checked(binding_of(command), app);
  }
  template <class C>
  [[nodiscard]] bool enabled(const C& command) const {
    return is_enabled(binding_of(command), app);
  }
};

TEST(Escape, CancelsTheVideoFirst) {
  Window window;
  window.app.layout->tool.tool = Tool::place;
  window.app.simulate->video.progress.active = true;
  window.run(Escape{});
  EXPECT_NE(window.asked<CancelVideo>(), nullptr);
  EXPECT_EQ(window.app.layout->tool.tool, Tool::place);
}

TEST(Escape, CancelsTheToolBeforeTheTour) {
  Window window;
  window.app.layout->tool.tool = Tool::place;
  window.app.window->tour.step = 2;
  window.run(Escape{});
  EXPECT_EQ(window.app.layout->tool.tool, Tool::none);
  EXPECT_EQ(window.app.window->tour.step, 2);
  window.run(Escape{});
  EXPECT_EQ(window.app.window->tour.step, -1);
}

TEST(Escape, ClosesGenerateBeforeTheHelp) {
  Window window;
  window.app.layout->generate.open = window.app.window->panels.help = true;
  window.run(Escape{});
  EXPECT_FALSE(window.app.layout->generate.open);
  EXPECT_TRUE(window.app.window->panels.help);
  window.run(Escape{});
  EXPECT_FALSE(window.app.window->panels.help);
}

TEST(Escape, LeavesThePickOfTheFrameBeforeTheMeasurement) {
  Window window;
  window.app.layout->mesh.pick = FramePick::tip;
  window.app.layout->measure.on = true;
  window.run(Escape{});
  EXPECT_EQ(window.app.layout->mesh.pick, FramePick::none);
  EXPECT_TRUE(window.app.layout->measure.on);
}

TEST(Escape, LeavesTheMeasurementBeforeTheProbe) {
  Window window;
  window.app.layout->measure.on = window.app.layout->probe.on = true;
  window.run(Escape{});
  EXPECT_FALSE(window.app.layout->measure.on);
  EXPECT_TRUE(window.app.layout->probe.on);
  window.run(Escape{});
  EXPECT_FALSE(window.app.layout->probe.on);
}

TEST(Escape, ReleasesADraggedWaypointBeforeItsSelection) {
  Window window;
  window.app.simulate->path.held = window.app.simulate->path.moved = true;
  window.app.simulate->path.selected = 1;
  window.app.simulate->path.gesture = 7;
  window.run(Escape{});
  EXPECT_EQ(window.asked<CancelGesture>()->number, 7U);
  EXPECT_EQ(window.app.simulate->path.selected, 1);
  window.run(Escape{});
  EXPECT_EQ(window.app.simulate->path.selected, -1);
}

TEST(Escape, ClearsTheSelectionOfTaxelsAndBody) {
  Window window;
  window.app.viewer->selection.taxels = {1};
  window.app.viewer->selection.body = 2;
  window.run(Escape{});
  EXPECT_TRUE(window.app.viewer->selection.empty());
  EXPECT_EQ(window.app.viewer->selection.body, -1);
}

TEST(Escape, FreesTheCameraLast) {
  Window window;
  window.app.viewer->mode = Mode::simulate;
  window.app.simulate->follow.body = 1;
  window.app.viewer->selection.taxels = {1};
  window.run(Escape{});
  EXPECT_EQ(window.app.simulate->follow.body, 1);
  window.run(Escape{});
  EXPECT_EQ(window.app.simulate->follow.body, -1);
}

TEST(ToggleClipPlane, CutsThroughTheMiddleTowardsTheEye) {
  Window window;
  window.run(ToggleClipPlane{});
  ASSERT_TRUE(window.app.viewer->clip.has_value());
  EXPECT_NEAR(window.app.viewer->clip->normal.x, 1, 1e-12) << "the eye is at +x";
  EXPECT_NEAR(window.app.viewer->clip->offset, 0, 1e-4) << "the ball is about the origin";
  EXPECT_TRUE(window.checked(ToggleClipPlane{}));
  window.run(ToggleClipPlane{});
  EXPECT_FALSE(window.app.viewer->clip.has_value());
}

TEST(FlipClipPlane, KeepsThePlaneAndTurnsItsNormal) {
  Window window;
  EXPECT_FALSE(window.enabled(FlipClipPlane{}));
  window.app.viewer->clip = ClipPlane{dvec3(0, 0, 1), 0.002};
  window.run(FlipClipPlane{});
  EXPECT_EQ(window.app.viewer->clip->normal, dvec3(0, 0, -1));
  EXPECT_EQ(window.app.viewer->clip->offset, -0.002);
}

TEST(FrameCamera, TargetsTheMiddleOfTheBall) {
  Window window;
  window.app.viewer->camera().target = dvec3(1, 2, 3);
  window.run(FrameCamera{false});
  EXPECT_LT(glm::length(window.app.viewer->camera().target), 1e-4);
}

TEST(FrameCamera, TargetsTheSelectedTaxel) {
  Window window;
  EXPECT_FALSE(window.enabled(FrameCamera{true})) << "no taxel is selected";
  window.app.viewer->selection.set(1);
  window.run(FrameCamera{true});
  EXPECT_LT(glm::distance(window.app.viewer->camera().target, window.project.layout.taxels[0].center), 1e-9);
}

TEST(FrameCamera, IsDisabledWithoutADocument) {
  Window window;
  *window.app.shown = {};
  EXPECT_FALSE(window.enabled(FrameCamera{false}));
  EXPECT_FALSE(window.enabled(AlignCamera{}));
}

TEST(AlignCamera, LooksFromTheFirstDirection) {
  Window window;
  window.run(AlignCamera{});
  EXPECT_EQ(window.app.viewer->camera().azimuth_deg, first_camera(Mode::layout).azimuth_deg);
  EXPECT_EQ(window.app.viewer->camera().elevation_deg, first_camera(Mode::layout).elevation_deg);
}

TEST(ToggleRangeLock, KeepsTheRangeAsItIs) {
  Window window;
  window.run(ToggleRangeLock{});
  EXPECT_FALSE(window.app.viewer->range.automatic);
  EXPECT_TRUE(window.checked(ToggleRangeLock{}));
}

TEST(ToggleTheme, TicksTheLightTheme) {
  Window window;
  EXPECT_FALSE(window.checked(ToggleTheme{}));
  window.run(ToggleTheme{});
  EXPECT_FALSE(window.app.window->appearance.dark);
  EXPECT_TRUE(window.checked(ToggleTheme{}));
}

TEST(ToggleFullScreen, TicksItsEntry) {
  Window window;
  window.run(ToggleFullScreen{});
  EXPECT_TRUE(window.app.window->full_screen);
  EXPECT_TRUE(window.checked(ToggleFullScreen{}));
}

TEST(ResetArrangement, OpensThePanelsThatAreOpenAtFirst) {
  Window window;
  window.app.window->panels.inspector = false;
  window.app.window->panels.study = true;
  window.run(ResetArrangement{});
  EXPECT_TRUE(window.app.window->panels.inspector);
  EXPECT_FALSE(window.app.window->panels.study);
  EXPECT_TRUE(window.app.window->arrangement.reset);
}

TEST(OpenPalette, ForgetsTheLastText) {
  Window window;
  window.app.window->palette.typed = "export";
  window.app.window->palette.chosen = 3;
  window.run(OpenPalette{});
  EXPECT_TRUE(window.app.window->palette.open && window.app.window->palette.wants_focus);
  EXPECT_EQ(window.app.window->palette.typed, "");
  EXPECT_EQ(window.app.window->palette.chosen, 0);
}

TEST(StartTour, ShowsTheFirstStep) {
  Window window;
  window.run(StartTour{});
  EXPECT_EQ(window.app.window->tour.step, 0);
}

TEST(ShowOpenDialog, ListsTheFolderOfTheDialog) {
  Window window;
  window.app.window->dialog.folder = "/somewhere";
  window.app.window->dialog.path = "old";
  window.run(ShowOpenDialog{});
  EXPECT_TRUE(window.app.window->dialog.open);
  EXPECT_EQ(window.app.window->dialog.path, "");
  EXPECT_EQ(window.asked<ListFolder>()->path, "/somewhere");
}

TEST(SetMode, IsPostedAndNotYetInEffect) {
  Window window;
  window.run(SetMode{Mode::simulate});
  EXPECT_EQ(window.asked<SetMode>()->mode, Mode::simulate);
  EXPECT_EQ(window.app.viewer->mode, Mode::layout) << "the program may refuse it";
  EXPECT_TRUE(window.checked(SetMode{Mode::layout}));
  EXPECT_FALSE(window.checked(SetMode{Mode::simulate}));
}

TEST(StepOnce, NeedsTaxelsOrARun) {
  Window window;
  window.run(StepOnce{});
  EXPECT_NE(window.asked<StepOnce>(), nullptr);
  Window empty;
  *empty.app.shown = {};
  empty.run(StepOnce{});
  EXPECT_EQ(empty.asked<StepOnce>(), nullptr);
}

TEST(CycleFrames, NeedsASceneInSimulate) {
  Window layout;
  layout.run(CycleFrames{});
  EXPECT_EQ(layout.app.viewer->overlays().frames, FramesShown::none);
  Running run;
  perform(CycleFrames{}, run.scene.app);
  EXPECT_NE(run.scene.app.viewer->overlays().frames, FramesShown::none);
  perform(CycleLabels{}, run.scene.app);
  EXPECT_NE(run.scene.app.viewer->overlays().labels, LabelsShown::none);
}

TEST(GoToEvent, PostsNothingBeyondTheLastEvent) {
  Running run;
  const auto frame = std::make_shared<SimFrame>(*run.scene.app.shown->run.frame);
  frame->step = 17;
  run.scene.app.shown->run.frame = frame;
  perform(GoToEvent{1}, run.scene.app);
  EXPECT_EQ(run.scene.asked<ScrubTo>(), nullptr);
  perform(GoToEvent{-1}, run.scene.app);
  EXPECT_EQ(run.scene.asked<ScrubTo>()->step, 12U);
}

TEST(GoToNewestStep, IsDisabledWithoutRecordedSteps) {
  Window window;
  window.run(GoToNewestStep{});
  window.run(GoToEvent{1});
  window.run(TogglePlayBackwards{});
  window.run(ToggleLoop{});
  EXPECT_TRUE(window.app.ui->commands.empty());
}

TEST(ToggleBreakOnJump, KeepsTheOtherBreakpoints) {
  Running run;
  const auto frame = std::make_shared<SimFrame>(*run.scene.app.shown->run.frame);
  frame->breakpoints.jump = 0.25;
  run.scene.app.shown->run.frame = frame;
  perform(ToggleBreakOnJump{}, run.scene.app);
  EXPECT_NE(run.scene.asked<SetBreakpoints>()->breakpoints.on_jump, frame->breakpoints.on_jump);
  EXPECT_EQ(run.scene.asked<SetBreakpoints>()->breakpoints.jump, 0.25);
}

TEST(ToggleRecording, EndsARunningRecording) {
  Running run;
  perform(ToggleRecording{}, run.scene.app);
  EXPECT_TRUE(run.scene.asked<SetRecording>()->on);
  const auto frame = std::make_shared<SimFrame>(*run.scene.app.shown->run.frame);
  frame->recording.on = true;
  run.scene.app.shown->run.frame = frame;
  perform(ToggleRecording{}, run.scene.app);
  EXPECT_FALSE(run.scene.asked<SetRecording>()->on);
}

TEST(ExportFile, IsEnabledByWhatThereIsToExport) {
  Window window;
  EXPECT_TRUE(window.enabled(ExportFile{FileTask::export_layout}));
  EXPECT_FALSE(window.enabled(ExportFile{FileTask::export_recording}));
  EXPECT_FALSE(window.enabled(ExportFile{FileTask::export_video}));
  Running run;
  EXPECT_TRUE(is_enabled(binding_of(ExportFile{FileTask::export_video}), run.scene.app));
  run.scene.app.simulate->video.progress.active = true;
  EXPECT_FALSE(is_enabled(binding_of(ExportFile{FileTask::export_video}), run.scene.app));
}

TEST(SaveAs, IsEnabledForAScene) {
  Window window;
  window.app.shown->document.editing.project = nullptr;
  EXPECT_FALSE(window.enabled(SaveAs{}));
  window.app.shown->document.is_scene = true;
  EXPECT_TRUE(window.enabled(SaveAs{}));
  EXPECT_FALSE(window.enabled(SaveProject{}));
}

}  // namespace
}  // namespace taxel::ui
