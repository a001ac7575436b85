// The rows of the tools: the order in which they get the pointer, and the order in which Esc cancels them.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "app/studio/app/pointing/tools.h"
#include "app/studio/app/values/app_parts.h"
#include "ui/tools/tool_scene.h"

namespace taxel::ui {
namespace {

using Names = std::vector<std::string>;

/// A window in which every tool is active.
App busy_window() {
  App app = test::ToolScene({dvec3(1, 0, 0)}).app;
  app.simulate->video.progress.active = true;
  app.layout->tool.tool = Tool::box;
  app.window->tour.step = 2;
  app.layout->generate.open = true;
  app.window->panels.help = true;
  app.layout->mesh.pick = FramePick::tip;
  app.layout->measure.on = true;
  app.layout->probe.on = true;
  app.simulate->path.held = true;
  app.viewer->selection.set(1);
  return app;
}

const ToolSpec& row(const std::string& key) {
  return *std::find_if(tools().begin(), tools().end(), [&](const ToolSpec& tool) { return key == tool.key; });
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
  EXPECT_EQ(keys, (Names{"probe", "measure", "wheel", "taxel", "path", "perturb", "camera", "gizmo", "mesh_frame",
                         "place", "selection"}));
}

TEST(ToolRows, AreCancelledByEscInThisOrder) {
  App app = busy_window();
  Names cancelled;
  for (int presses = 0; presses < 10; ++presses) {
    std::set<std::string> before;
    for (const ToolSpec& tool : tools())
      if (tool.cancel != nullptr && tool.active(app)) before.insert(tool.key);
    cancel_innermost(app);
    app.simulate->video.progress.active = false;  // the program stops it
    for (const std::string& key : before)
      if (!row(key).active(app)) cancelled.push_back(key);
  }
  EXPECT_EQ(cancelled, (Names{"video", "taxel", "tour", "generate", "help", "mesh_frame", "measure", "probe", "path",
                              "selection"}));
}

TEST(ToolRows, CancelOnlyThemselves) {
  for (const ToolSpec& tool : tools()) {
    if (tool.cancel == nullptr || std::string(tool.key) == "camera") continue;
    App app = busy_window();
    tool.cancel(app);
    for (const ToolSpec& other : tools()) {
      if (other.cancel == nullptr || &other == &tool) continue;
      EXPECT_TRUE(other.active(app)) << tool.key << ": " << other.key;
    }
  }
}

TEST(CancelInnermost, StopsAVideoByACommand) {
  App app;
  app.simulate->video.progress.active = true;
  cancel_innermost(app);
  ASSERT_EQ(app.ui->commands.size(), 1U);
  EXPECT_TRUE(std::holds_alternative<CancelVideo>(app.ui->commands[0]));
}

TEST(CancelInnermost, ClearsTaxelsBodyAndWaypointAtOnce) {
  App app;
  app.viewer->selection.taxels = {1, 2};
  app.viewer->selection.body = 3;
  app.simulate->path.selected = 0;
  cancel_innermost(app);
  EXPECT_TRUE(app.viewer->selection.taxels.empty());
  EXPECT_EQ(app.viewer->selection.body, -1);
  EXPECT_EQ(app.simulate->path.selected, -1);
}

TEST(CancelInnermost, FreesTheCameraLast) {
  App app;
  app.viewer->mode = Mode::simulate;
  app.simulate->follow.body = 4;
  app.viewer->selection.set(1);
  cancel_innermost(app);
  EXPECT_EQ(app.simulate->follow.body, 4) << "the selection comes first";
  cancel_innermost(app);
  EXPECT_EQ(app.simulate->follow.body, -1);
}

}  // namespace
}  // namespace taxel::ui
