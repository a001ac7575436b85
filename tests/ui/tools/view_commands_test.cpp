// Commands about the window, the 3-D view and the recorded steps.
#include <gtest/gtest.h>

#include "app/studio/app/perform.h"
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
    perform(command, ui, input);
  }
  template <class C>
  [[nodiscard]] bool checked(const C& command) const {
    return is_checked(binding_of(command), ui, input);
  }
  template <class C>
  [[nodiscard]] bool enabled(const C& command) const {
    return is_enabled(binding_of(command), ui, input);
  }
};

TEST(Escape, CancelsTheVideoFirst) {
  Window window;
  window.ui.tool.tool = Tool::place;
  window.input.video.active = true;
  window.run(Escape{});
  EXPECT_NE(window.asked<CancelVideo>(), nullptr);
  EXPECT_EQ(window.ui.tool.tool, Tool::place);
}

TEST(Escape, CancelsTheToolBeforeTheTour) {
  Window window;
  window.ui.tool.tool = Tool::place;
  window.ui.tour_step = 2;
  window.run(Escape{});
  EXPECT_EQ(window.ui.tool.tool, Tool::none);
  EXPECT_EQ(window.ui.tour_step, 2);
  window.run(Escape{});
  EXPECT_EQ(window.ui.tour_step, -1);
}

TEST(Escape, ClosesGenerateBeforeTheHelp) {
  Window window;
  window.ui.generate.open = window.ui.saved.panels.help = true;
  window.run(Escape{});
  EXPECT_FALSE(window.ui.generate.open);
  EXPECT_TRUE(window.ui.saved.panels.help);
  window.run(Escape{});
  EXPECT_FALSE(window.ui.saved.panels.help);
}

TEST(Escape, LeavesThePickOfTheFrameBeforeTheMeasurement) {
  Window window;
  window.ui.mesh.pick = FramePick::tip;
  window.ui.measure.on = true;
  window.run(Escape{});
  EXPECT_EQ(window.ui.mesh.pick, FramePick::none);
  EXPECT_TRUE(window.ui.measure.on);
}

TEST(Escape, LeavesTheMeasurementBeforeTheProbe) {
  Window window;
  window.ui.measure.on = window.ui.probe.on = true;
  window.run(Escape{});
  EXPECT_FALSE(window.ui.measure.on);
  EXPECT_TRUE(window.ui.probe.on);
  window.run(Escape{});
  EXPECT_FALSE(window.ui.probe.on);
}

TEST(Escape, ReleasesADraggedWaypointBeforeItsSelection) {
  Window window;
  window.ui.path.held = window.ui.path.moved = true;
  window.ui.path.selected = 1;
  window.ui.path.gesture = 7;
  window.run(Escape{});
  EXPECT_EQ(window.asked<CancelGesture>()->number, 7U);
  EXPECT_EQ(window.ui.path.selected, 1);
  window.run(Escape{});
  EXPECT_EQ(window.ui.path.selected, -1);
}

TEST(Escape, ClearsTheSelectionOfTaxelsAndBody) {
  Window window;
  window.ui.selection.taxels = {1};
  window.ui.selection.body = 2;
  window.run(Escape{});
  EXPECT_TRUE(window.ui.selection.empty());
  EXPECT_EQ(window.ui.selection.body, -1);
}

TEST(Escape, FreesTheCameraLast) {
  Window window;
  window.ui.mode = Mode::simulate;
  window.ui.follow.body = 1;
  window.ui.selection.taxels = {1};
  window.run(Escape{});
  EXPECT_EQ(window.ui.follow.body, 1);
  window.run(Escape{});
  EXPECT_EQ(window.ui.follow.body, -1);
}

TEST(ToggleClipPlane, CutsThroughTheMiddleTowardsTheEye) {
  Window window;
  window.run(ToggleClipPlane{});
  ASSERT_TRUE(window.ui.clip.has_value());
  EXPECT_NEAR(window.ui.clip->normal.x, 1, 1e-12) << "the eye is at +x";
  EXPECT_NEAR(window.ui.clip->offset, 0, 1e-4) << "the ball is about the origin";
  EXPECT_TRUE(window.checked(ToggleClipPlane{}));
  window.run(ToggleClipPlane{});
  EXPECT_FALSE(window.ui.clip.has_value());
}

TEST(FlipClipPlane, KeepsThePlaneAndTurnsItsNormal) {
  Window window;
  EXPECT_FALSE(window.enabled(FlipClipPlane{}));
  window.ui.clip = ClipPlane{dvec3(0, 0, 1), 0.002};
  window.run(FlipClipPlane{});
  EXPECT_EQ(window.ui.clip->normal, dvec3(0, 0, -1));
  EXPECT_EQ(window.ui.clip->offset, -0.002);
}

TEST(FrameCamera, TargetsTheMiddleOfTheBall) {
  Window window;
  window.ui.camera().target = dvec3(1, 2, 3);
  window.run(FrameCamera{false});
  EXPECT_LT(glm::length(window.ui.camera().target), 1e-4);
}

TEST(FrameCamera, TargetsTheSelectedTaxel) {
  Window window;
  EXPECT_FALSE(window.enabled(FrameCamera{true})) << "no taxel is selected";
  window.ui.selection.set(1);
  window.run(FrameCamera{true});
  EXPECT_LT(glm::distance(window.ui.camera().target, window.project.layout.taxels[0].center), 1e-9);
}

TEST(FrameCamera, IsDisabledWithoutADocument) {
  Window window;
  window.input = {};
  EXPECT_FALSE(window.enabled(FrameCamera{false}));
  EXPECT_FALSE(window.enabled(AlignCamera{}));
}

TEST(AlignCamera, LooksFromTheFirstDirection) {
  Window window;
  window.run(AlignCamera{});
  EXPECT_EQ(window.ui.camera().azimuth_deg, first_camera(Mode::layout).azimuth_deg);
  EXPECT_EQ(window.ui.camera().elevation_deg, first_camera(Mode::layout).elevation_deg);
}

TEST(ToggleRangeLock, KeepsTheRangeAsItIs) {
  Window window;
  window.run(ToggleRangeLock{});
  EXPECT_FALSE(window.ui.range.automatic);
  EXPECT_TRUE(window.checked(ToggleRangeLock{}));
}

TEST(ToggleTheme, TicksTheLightTheme) {
  Window window;
  EXPECT_FALSE(window.checked(ToggleTheme{}));
  window.run(ToggleTheme{});
  EXPECT_FALSE(window.ui.saved.dark);
  EXPECT_TRUE(window.checked(ToggleTheme{}));
}

TEST(ToggleFullScreen, TicksItsEntry) {
  Window window;
  window.run(ToggleFullScreen{});
  EXPECT_TRUE(window.ui.full_screen);
  EXPECT_TRUE(window.checked(ToggleFullScreen{}));
}

TEST(ResetArrangement, OpensThePanelsThatAreOpenAtFirst) {
  Window window;
  window.ui.saved.panels.inspector = false;
  window.ui.saved.panels.study = true;
  window.run(ResetArrangement{});
  EXPECT_TRUE(window.ui.saved.panels.inspector);
  EXPECT_FALSE(window.ui.saved.panels.study);
  EXPECT_TRUE(window.ui.reset_arrangement);
}

TEST(OpenPalette, ForgetsTheLastText) {
  Window window;
  window.ui.palette.typed = "export";
  window.ui.palette.chosen = 3;
  window.run(OpenPalette{});
  EXPECT_TRUE(window.ui.palette.open && window.ui.palette.wants_focus);
  EXPECT_EQ(window.ui.palette.typed, "");
  EXPECT_EQ(window.ui.palette.chosen, 0);
}

TEST(StartTour, ShowsTheFirstStep) {
  Window window;
  window.run(StartTour{});
  EXPECT_EQ(window.ui.tour_step, 0);
}

TEST(ShowOpenDialog, ListsTheFolderOfTheDialog) {
  Window window;
  window.ui.dialog.folder = "/somewhere";
  window.ui.dialog.path = "old";
  window.run(ShowOpenDialog{});
  EXPECT_TRUE(window.ui.dialog.open);
  EXPECT_EQ(window.ui.dialog.path, "");
  EXPECT_EQ(window.asked<ListFolder>()->path, "/somewhere");
}

TEST(SetMode, IsPostedAndNotYetInEffect) {
  Window window;
  window.run(SetMode{Mode::simulate});
  EXPECT_EQ(window.asked<SetMode>()->mode, Mode::simulate);
  EXPECT_EQ(window.ui.mode, Mode::layout) << "the program may refuse it";
  EXPECT_TRUE(window.checked(SetMode{Mode::layout}));
  EXPECT_FALSE(window.checked(SetMode{Mode::simulate}));
}

TEST(StepOnce, NeedsTaxelsOrARun) {
  Window window;
  window.run(StepOnce{});
  EXPECT_NE(window.asked<StepOnce>(), nullptr);
  Window empty;
  empty.input = {};
  empty.run(StepOnce{});
  EXPECT_EQ(empty.asked<StepOnce>(), nullptr);
}

TEST(CycleFrames, NeedsASceneInSimulate) {
  Window layout;
  layout.run(CycleFrames{});
  EXPECT_EQ(layout.ui.saved.overlays.frames, FramesShown::none);
  Running run;
  perform(CycleFrames{}, run.scene.ui, run.scene.input);
  EXPECT_NE(run.scene.ui.saved.overlays.frames, FramesShown::none);
  perform(CycleLabels{}, run.scene.ui, run.scene.input);
  EXPECT_NE(run.scene.ui.saved.overlays.labels, LabelsShown::none);
}

TEST(GoToEvent, PostsNothingBeyondTheLastEvent) {
  Running run;
  const auto frame = std::make_shared<SimFrame>(*run.scene.input.frame);
  frame->step = 17;
  run.scene.input.frame = frame;
  perform(GoToEvent{1}, run.scene.ui, run.scene.input);
  EXPECT_EQ(run.scene.asked<ScrubTo>(), nullptr);
  perform(GoToEvent{-1}, run.scene.ui, run.scene.input);
  EXPECT_EQ(run.scene.asked<ScrubTo>()->step, 12U);
}

TEST(GoToNewestStep, IsDisabledWithoutRecordedSteps) {
  Window window;
  window.run(GoToNewestStep{});
  window.run(GoToEvent{1});
  window.run(TogglePlayBackwards{});
  window.run(ToggleLoop{});
  EXPECT_TRUE(window.ui.commands.empty());
}

TEST(ToggleBreakOnJump, KeepsTheOtherBreakpoints) {
  Running run;
  const auto frame = std::make_shared<SimFrame>(*run.scene.input.frame);
  frame->breakpoints.jump = 0.25;
  run.scene.input.frame = frame;
  perform(ToggleBreakOnJump{}, run.scene.ui, run.scene.input);
  EXPECT_NE(run.scene.asked<SetBreakpoints>()->breakpoints.on_jump, frame->breakpoints.on_jump);
  EXPECT_EQ(run.scene.asked<SetBreakpoints>()->breakpoints.jump, 0.25);
}

TEST(ToggleRecording, EndsARunningRecording) {
  Running run;
  perform(ToggleRecording{}, run.scene.ui, run.scene.input);
  EXPECT_TRUE(run.scene.asked<SetRecording>()->on);
  const auto frame = std::make_shared<SimFrame>(*run.scene.input.frame);
  frame->recording.on = true;
  run.scene.input.frame = frame;
  perform(ToggleRecording{}, run.scene.ui, run.scene.input);
  EXPECT_FALSE(run.scene.asked<SetRecording>()->on);
}

TEST(ExportFile, IsEnabledByWhatThereIsToExport) {
  Window window;
  EXPECT_TRUE(window.enabled(ExportFile{FileTask::export_layout}));
  EXPECT_FALSE(window.enabled(ExportFile{FileTask::export_recording}));
  EXPECT_FALSE(window.enabled(ExportFile{FileTask::export_video}));
  Running run;
  EXPECT_TRUE(is_enabled(binding_of(ExportFile{FileTask::export_video}), run.scene.ui, run.scene.input));
  run.scene.input.video.active = true;
  EXPECT_FALSE(is_enabled(binding_of(ExportFile{FileTask::export_video}), run.scene.ui, run.scene.input));
}

TEST(SaveAs, IsEnabledForAScene) {
  Window window;
  window.input.editing.project = nullptr;
  EXPECT_FALSE(window.enabled(SaveAs{}));
  window.input.is_scene = true;
  EXPECT_TRUE(window.enabled(SaveAs{}));
  EXPECT_FALSE(window.enabled(SaveProject{}));
}

}  // namespace
}  // namespace taxel::ui
