// Commands about the window, the 3-D view and the recorded steps.
#include <gtest/gtest.h>

#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_state.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/camera/camera_state.h"
#include "app/studio/nouns/demo/demo_state.h"
#include "app/studio/nouns/files/document_commands.h"
#include "app/studio/nouns/files/export.h"
#include "app/studio/nouns/files/file_dialog.h"
#include "app/studio/nouns/files/file_dialog_state.h"
#include "app/studio/nouns/generate/generate_state.h"
#include "app/studio/nouns/history/edit_commands.h"
#include "app/studio/nouns/inspector/inspector_state.h"
#include "app/studio/nouns/measure/measure_state.h"
#include "app/studio/nouns/menus/menus_state.h"
#include "app/studio/nouns/menus/window_commands.h"
#include "app/studio/nouns/mesh/mesh_state.h"
#include "app/studio/nouns/probe/probe_state.h"
#include "app/studio/nouns/scenario/scenario_state.h"
#include "app/studio/nouns/study/study_state.h"
#include "app/studio/nouns/taxel/tool_state.h"
#include "app/studio/nouns/timeline/run_commands.h"
#include "app/studio/nouns/video/video_commands.h"
#include "app/studio/nouns/video/video_state.h"
#include "app/studio/nouns/view/view_commands.h"
#include "app/studio/shell/interface/carry_out.h"
#include "ui/tools/running.h"

namespace taxel::ui {
namespace {

using test::Running;

/// A ball with one taxel, open in LAYOUT.
struct Window : test::ToolScene {
  Window() : ToolScene({dvec3(1, 0, 0)}) {}
  template <class C>
  void run(const C& command) {
    carry_out_if_enabled(command, app);
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
  window.app.get<ToolState>().tool = Tool::place;
  window.app.get<VideoState>().progress.active = true;
  window.run(Escape{});
  EXPECT_NE(window.asked<CancelVideo>(), nullptr);
  EXPECT_EQ(window.app.get<ToolState>().tool, Tool::place);
}

TEST(Escape, CancelsTheToolBeforeTheTour) {
  Window window;
  window.app.get<ToolState>().tool = Tool::place;
  window.app.get<TourState>().step = 2;
  window.run(Escape{});
  EXPECT_EQ(window.app.get<ToolState>().tool, Tool::none);
  EXPECT_EQ(window.app.get<TourState>().step, 2);
  window.run(Escape{});
  EXPECT_EQ(window.app.get<TourState>().step, -1);
}

TEST(Escape, ClosesGenerateBeforeTheHelp) {
  Window window;
  window.app.get<GenerateState>().open = window.app.get<PanelsShown>()[kHelp] = true;
  window.run(Escape{});
  EXPECT_FALSE(window.app.get<GenerateState>().open);
  EXPECT_TRUE(window.app.get<PanelsShown>()[kHelp]);
  window.run(Escape{});
  EXPECT_FALSE(window.app.get<PanelsShown>()[kHelp]);
}

TEST(Escape, LeavesThePickOfTheFrameBeforeTheMeasurement) {
  Window window;
  window.app.get<MeshState>().pick = FramePick::tip;
  window.app.get<MeasureState>().on = true;
  window.run(Escape{});
  EXPECT_EQ(window.app.get<MeshState>().pick, FramePick::none);
  EXPECT_TRUE(window.app.get<MeasureState>().on);
}

TEST(Escape, LeavesTheMeasurementBeforeTheProbe) {
  Window window;
  window.app.get<MeasureState>().on = window.app.get<ProbeState>().on = true;
  window.run(Escape{});
  EXPECT_FALSE(window.app.get<MeasureState>().on);
  EXPECT_TRUE(window.app.get<ProbeState>().on);
  window.run(Escape{});
  EXPECT_FALSE(window.app.get<ProbeState>().on);
}

TEST(Escape, ReleasesADraggedWaypointBeforeItsSelection) {
  Window window;
  window.app.get<PathState>().held = window.app.get<PathState>().moved = true;
  window.app.get<PathState>().selected = 1;
  window.app.get<PathState>().gesture = 7;
  window.run(Escape{});
  EXPECT_EQ(window.asked<CancelGesture>()->number, 7U);
  EXPECT_EQ(window.app.get<PathState>().selected, 1);
  window.run(Escape{});
  EXPECT_EQ(window.app.get<PathState>().selected, -1);
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
  window.app.get<FollowState>().body = 1;
  window.app.viewer->selection.taxels = {1};
  window.run(Escape{});
  EXPECT_EQ(window.app.get<FollowState>().body, 1);
  window.run(Escape{});
  EXPECT_EQ(window.app.get<FollowState>().body, -1);
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
  const Camera aligned = window.app.viewer->camera();
  look_at_touching_side(*window.app.viewer, *window.app.shown);
  EXPECT_EQ(window.app.viewer->camera().azimuth_deg, aligned.azimuth_deg);
  EXPECT_EQ(window.app.viewer->camera().elevation_deg, aligned.elevation_deg);
  EXPECT_NEAR(aligned.elevation_deg, 20, 1e-9);
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
  EXPECT_FALSE(window.app.get<Appearance>().dark);
  EXPECT_TRUE(window.checked(ToggleTheme{}));
}

TEST(ToggleFullScreen, TicksItsEntry) {
  Window window;
  window.run(ToggleFullScreen{});
  EXPECT_TRUE(window.app.get<WindowState>().full_screen);
  EXPECT_TRUE(window.checked(ToggleFullScreen{}));
}

TEST(ResetArrangement, OpensThePanelsThatAreOpenAtFirst) {
  Window window;
  window.app.get<PanelsShown>()[kInspector] = false;
  window.app.get<PanelsShown>()[kStudy] = true;
  window.run(ResetArrangement{});
  EXPECT_TRUE(window.app.get<PanelsShown>()[kInspector]);
  EXPECT_FALSE(window.app.get<PanelsShown>()[kStudy]);
  EXPECT_TRUE(window.app.get<Arrangement>().reset);
}

TEST(OpenPalette, ForgetsTheLastText) {
  Window window;
  window.app.get<PaletteState>().typed = "export";
  window.app.get<PaletteState>().chosen = 3;
  window.run(OpenPalette{});
  EXPECT_TRUE(window.app.get<PaletteState>().open && window.app.get<PaletteState>().wants_focus);
  EXPECT_EQ(window.app.get<PaletteState>().typed, "");
  EXPECT_EQ(window.app.get<PaletteState>().chosen, 0);
}

TEST(StartTour, ShowsTheFirstStep) {
  Window window;
  window.run(ShowTour{});
  EXPECT_EQ(window.app.get<TourState>().step, 0);
}

TEST(ShowOpenDialog, ListsTheFolderOfTheDialog) {
  Window window;
  window.app.get<FileDialog>().folder = "/somewhere";
  window.app.get<FileDialog>().path = "old";
  window.run(ShowOpenDialog{});
  EXPECT_TRUE(window.app.get<FileDialog>().open);
  EXPECT_EQ(window.app.get<FileDialog>().path, "");
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
  carry_out_if_enabled(CycleFrames{}, run.scene.app);
  EXPECT_NE(run.scene.app.viewer->overlays().frames, FramesShown::none);
  carry_out_if_enabled(CycleLabels{}, run.scene.app);
  EXPECT_NE(run.scene.app.viewer->overlays().labels, LabelsShown::none);
}

TEST(GoToEvent, PostsNothingBeyondTheLastEvent) {
  Running run;
  const auto frame = std::make_shared<SimFrame>(*run.scene.app.shown->run.frame);
  frame->step = 17;
  run.scene.app.shown->run.frame = frame;
  carry_out_if_enabled(GoToEvent{1}, run.scene.app);
  EXPECT_EQ(run.scene.asked<ScrubTo>(), nullptr);
  carry_out_if_enabled(GoToEvent{-1}, run.scene.app);
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
  carry_out_if_enabled(ToggleBreakOnJump{}, run.scene.app);
  EXPECT_NE(run.scene.asked<BreakpointsCommand>()->breakpoints.on_jump, frame->breakpoints.on_jump);
  EXPECT_EQ(run.scene.asked<BreakpointsCommand>()->breakpoints.jump, 0.25);
}

TEST(ToggleRecording, EndsARunningRecording) {
  Running run;
  carry_out_if_enabled(ToggleRecording{}, run.scene.app);
  EXPECT_TRUE(run.scene.asked<SetRecording>()->on);
  const auto frame = std::make_shared<SimFrame>(*run.scene.app.shown->run.frame);
  frame->recording.on = true;
  run.scene.app.shown->run.frame = frame;
  carry_out_if_enabled(ToggleRecording{}, run.scene.app);
  EXPECT_FALSE(run.scene.asked<SetRecording>()->on);
}

TEST(ExportFile, IsEnabledByWhatThereIsToExport) {
  Window window;
  EXPECT_TRUE(window.enabled(ExportFile{FileTask::export_layout}));
  EXPECT_FALSE(window.enabled(ExportFile{FileTask::export_recording}));
  EXPECT_FALSE(window.enabled(ExportFile{FileTask::export_video}));
  Running run;
  EXPECT_TRUE(is_enabled(binding_of(ExportFile{FileTask::export_video}), run.scene.app));
  run.scene.app.get<VideoState>().progress.active = true;
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
