// A running simulation with recorded steps, as keys and commands see it, without a window.
#pragma once

#include <memory>

#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/shell/interface/carry_out.h"
#include "ui/tools/interface_frames.h"
#include "ui/tools/tool_scene.h"

namespace taxel::ui::test {

/// A running simulation: steps 10 to 20 are recorded, with events in 12 and 17; step 15 is displayed.
struct Running {
  InterfaceFrames interface;
  ToolScene scene{{dvec3(1, 0, 0), dvec3(1, 0.5, 0)}};
  Running() {
    scene.app.viewer->mode = Mode::simulate;
    const auto frame = std::make_shared<SimFrame>();
    const auto lanes = std::make_shared<HistoryLanes>();
    for (std::uint64_t step = 10; step <= 20; ++step)
      lanes->steps.push_back({step, 0, 0, static_cast<std::uint8_t>(step == 12 || step == 17 ? 4 : 0)});
    frame->scene = std::make_shared<SimScene>();
    frame->step = 15;
    frame->history.first = 10, frame->history.last = 20, frame->history.steps = 11;
    frame->history.lanes = lanes;
    scene.app.shown->run.frame = frame;
    scene.app.shown->run.speed = 1;
  }
  /// Returns the newest command of a kind that a key has posted, or null.
  template <class Kind>
  const Kind* pressed(ImGuiKey key, ImGuiKey modifier = ImGuiKey_None) {
    scene.app.ui->commands.clear();
    if (modifier != ImGuiKey_None) interface.key(modifier, true);
    interface.key(key, true);
    interface.frame([&] { handle_keys(scene.app); });
    interface.key(key, false);
    if (modifier != ImGuiKey_None) interface.key(modifier, false);
    interface.frame([&] { handle_keys(scene.app); });
    return scene.asked<Kind>();
  }
};

}  // namespace taxel::ui::test
