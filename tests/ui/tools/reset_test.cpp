// The state that another document resets, and the state that it keeps.
#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/message_list.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/files/files_state.h"
#include "app/studio/nouns/generate/generate_state.h"
#include "app/studio/nouns/measure/measure_state.h"
#include "app/studio/nouns/menus/menus_state.h"
#include "app/studio/nouns/mesh/mesh_state.h"
#include "app/studio/nouns/perturb/perturb_state.h"
#include "app/studio/nouns/plot/plot_state.h"
#include "app/studio/nouns/probe/probe_state.h"
#include "app/studio/nouns/scenario/scenario_state.h"
#include "app/studio/nouns/scene/controls_state.h"
#include "app/studio/nouns/study/study_state.h"
#include "app/studio/nouns/taxel/tool_state.h"
#include "app/studio/shell/interface/interface.h"

#include <gtest/gtest.h>

#include <utility>

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
  app.get<ToolState>().tool = Tool::brush;
  app.get<GenerateState>().open = true;
  app.get<MeasureState>().on = true;
  app.get<MeshState>().pick = FramePick::tip;
  forget_document(app);
  EXPECT_EQ(app.get<ToolState>().tool, Tool::none);
  EXPECT_FALSE(app.get<GenerateState>().open || app.get<MeasureState>().on);
  EXPECT_EQ(app.get<MeshState>().pick, FramePick::none);
}

TEST(ForgetDocument, RemovesTheProbeAndKeepsItsSettings) {
  App app;
  app.get<ProbeState>().on = app.get<ProbeState>().held = app.get<ProbeState>().sized = true;
  app.get<ProbeState>().at = dvec3(1, 2, 3);
  app.get<ProbeState>().largest = 7;
  app.get<ProbeState>().settings.depth = 0.004;
  forget_document(app);
  EXPECT_FALSE(app.get<ProbeState>().on || app.get<ProbeState>().held || app.get<ProbeState>().sized ||
               app.get<ProbeState>().at);
  EXPECT_EQ(app.get<ProbeState>().largest, 0);
  EXPECT_EQ(app.get<ProbeState>().settings.depth, 0.004);
}

TEST(ForgetDocument, StopsThePathRecordingAndKeepsItsInterval) {
  App app;
  app.get<PathState>().recording = PathRecording{};
  app.get<PathState>().record_every = 0.2;
  forget_document(app);
  EXPECT_FALSE(app.get<PathState>().recording);
  EXPECT_EQ(app.get<PathState>().record_every, 0.2);
}

TEST(ForgetDocument, ResetsStudyControlsAndGrabbedBody) {
  App app;
  app.get<StudyState>().count = 9;
  app.get<ControlsState>().filter = "finger";
  app.get<PerturbState>().geom = 2;
  forget_document(app);
  EXPECT_EQ(app.get<StudyState>().count, StudyState{}.count);
  EXPECT_EQ(app.get<ControlsState>().filter, "");
  EXPECT_EQ(app.get<PerturbState>().geom, -1);
}

TEST(ForgetDocument, KeepsTheStudyOfABatchWhichNeedsNoDocument) {
  App app;
  app.get<StudyState>().request = StudyRequest{1, {}, "batch"};
  forget_document(app);
  ASSERT_TRUE(app.get<StudyState>().request);
  EXPECT_EQ(app.get<StudyState>().request->folder, "batch");
  app.get<StudyState>().request->folder.clear();  // a study of the document's layout
  forget_document(app);
  EXPECT_FALSE(app.get<StudyState>().request);
}

TEST(ForgetDocument, KeepsTheWindowsOwnState) {
  App app;
  app.get<PanelsShown>()[kHelp] = true;
  app.get<FilesState>().recent = {"a"};
  app.get<Messages>().push_back({});
  forget_document(app);
  EXPECT_TRUE(app.get<PanelsShown>()[kHelp]);
  EXPECT_EQ(app.get<FilesState>().recent.size(), 1U);
  EXPECT_EQ(app.get<Messages>().size(), 1U);
}

struct Counter {
  int count = 0;
};

TEST(States, KeepOneValueOfEachTypeAtItsAddress) {
  States states;
  Counter& counter = states.get<Counter>();
  counter.count = 3;
  states.get<PlotState>().options.relative = true;
  EXPECT_EQ(&states.get<Counter>(), &counter);
  EXPECT_EQ(std::as_const(states).get<Counter>().count, 3);
  EXPECT_TRUE(std::as_const(states).get<PlotState>().options.relative);
}

TEST(States, GiveTheDefaultOfATypeThatNobodyChanged) {
  const States states;
  EXPECT_EQ(states.get<Counter>().count, 0);
  EXPECT_EQ(states.get<PathState>().record_every, PathState{}.record_every);
}

TEST(States, AreCopiedAsValues) {
  States first;
  first.get<Counter>().count = 1;
  States second = first;
  second.get<Counter>().count = 2;
  EXPECT_EQ(first.get<Counter>().count, 1);
  second = first;
  EXPECT_EQ(second.get<Counter>().count, 1);
  second = States{};
  EXPECT_EQ(second.get<Counter>().count, 0);
}

}  // namespace
}  // namespace taxel::ui
