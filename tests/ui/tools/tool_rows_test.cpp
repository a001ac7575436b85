// The rows of the tools: the order in which they get the pointer, and the order in which Esc cancels them.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_state.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/camera/camera_state.h"
#include "app/studio/nouns/demo/demo_state.h"
#include "app/studio/nouns/generate/generate_state.h"
#include "app/studio/nouns/guide/guide_state.h"
#include "app/studio/nouns/measure/measure_state.h"
#include "app/studio/nouns/menus/menus_state.h"
#include "app/studio/nouns/mesh/mesh_state.h"
#include "app/studio/nouns/probe/probe_state.h"
#include "app/studio/nouns/scenario/scenario_state.h"
#include "app/studio/nouns/taxel/tool_state.h"
#include "app/studio/nouns/video/video_commands.h"
#include "app/studio/nouns/video/video_state.h"
#include "app/studio/shell/interface/interface.h"
#include "ui/tools/tool_scene.h"

namespace taxel::ui {
namespace {

using Names = std::vector<std::string>;

/// A window in which every tool is active.
App busy_window() {
  App app = test::ToolScene({dvec3(1, 0, 0)}).app;
  app.get<WindowParts>().is_presenting = true;
  app.get<VideoState>().progress.active = true;
  app.get<ToolState>().tool = Tool::box;
  app.get<TourState>().step = 2;
  app.get<GenerateState>().open = true;
  for (const Feature* window : {&kAbout, &kHelp, &kGuide}) app.get<PanelsShown>()[*window] = true;
  app.get<MeshState>().pick = FramePick::tip;
  app.get<MeasureState>().on = true;
  app.get<ProbeState>().on = true;
  app.get<PathState>().held = true;
  app.viewer->selection.set(1);
  return app;
}

/// The tools of all features, in the order of their rows.
std::vector<ToolSpec> tools() {
  std::vector<ToolSpec> tools;
  for (const Feature* row : features())
    if (row->tool.key != nullptr) tools.push_back(row->tool);
  return tools;
}

ToolSpec row(const std::string& key) {
  const std::vector<ToolSpec> all = tools();
  return *std::find_if(all.begin(), all.end(), [&](const ToolSpec& tool) { return key == tool.key; });
}

TEST(ToolRows, HaveUniqueKeys) {
  std::set<std::string> keys;
  for (const ToolSpec& tool : tools()) EXPECT_TRUE(keys.insert(tool.key).second) << tool.key;
}

TEST(ToolRows, HaveUniquePlacesInTheOrderOfEsc) {
  std::set<int> orders;
  for (const ToolSpec& tool : tools()) {
    if (tool.cancel == nullptr) continue;
    EXPECT_TRUE(orders.insert(tool.cancel_order).second) << tool.key;
  }
}

TEST(ToolRows, GetThePointerInThisOrder) {
  Names keys;
  for (const ToolSpec& tool : tools())
    if (tool.pointer != nullptr) keys.emplace_back(tool.key);
  EXPECT_EQ(keys, (Names{"clicks", "gizmo", "probe", "measure", "wheel", "taxel", "path", "perturb", "camera",
                         "mesh_frame", "place", "selection"}));
}

TEST(ToolRows, AreCancelledByEscInThisOrder) {
  App app = busy_window();
  Names cancelled;
  for (int presses = 0; presses < 12; ++presses) {
    std::set<std::string> before;
    for (const ToolSpec& tool : tools())
      if (tool.cancel != nullptr && tool.active(app)) before.insert(tool.key);
    cancel_innermost(app);
    app.get<VideoState>().progress.active = false;  // the program stops it
    for (const std::string& key : before)
      if (!row(key).active(app)) cancelled.push_back(key);
  }
  EXPECT_EQ(cancelled, (Names{"presentation", "video", "taxel", "tour", "generate", "about", "help", "guide",
                              "mesh_frame", "measure", "probe", "path", "selection"}));
}

TEST(ToolRows, CancelOnlyThemselves) {
  for (const ToolSpec& tool : tools()) {
    if (tool.cancel == nullptr || std::string(tool.key) == "camera") continue;
    App app = busy_window();
    tool.cancel(app);
    for (const ToolSpec& other : tools()) {
      if (other.cancel == nullptr || std::string(other.key) == tool.key) continue;
      EXPECT_TRUE(other.active(app)) << tool.key << ": " << other.key;
    }
  }
}

TEST(CancelInnermost, StopsAVideoByACommand) {
  App app;
  app.get<VideoState>().progress.active = true;
  cancel_innermost(app);
  ASSERT_EQ(app.ui->commands.size(), 1U);
  EXPECT_TRUE(app.ui->commands[0].is<CancelVideo>());
}

TEST(CancelInnermost, ClearsTaxelsBodyAndWaypointAtOnce) {
  App app;
  app.viewer->selection.taxels = {1, 2};
  app.viewer->selection.body = 3;
  app.get<PathState>().selected = 0;
  cancel_innermost(app);
  EXPECT_TRUE(app.viewer->selection.taxels.empty());
  EXPECT_EQ(app.viewer->selection.body, -1);
  EXPECT_EQ(app.get<PathState>().selected, -1);
}

TEST(CancelInnermost, FreesTheCameraLast) {
  App app;
  app.viewer->mode = Mode::simulate;
  app.get<FollowState>().body = 4;
  app.viewer->selection.set(1);
  cancel_innermost(app);
  EXPECT_EQ(app.get<FollowState>().body, 4) << "the selection comes first";
  cancel_innermost(app);
  EXPECT_EQ(app.get<FollowState>().body, -1);
}

}  // namespace
}  // namespace taxel::ui
