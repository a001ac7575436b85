#include "app/studio/nouns/probe/probe.h"

#include <imgui.h>

#include "app/studio/frame/app.h"
#include "app/studio/frame/pointer_event.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/shown_scene.h"
#include "app/studio/frame/view_drawing.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/probe/probe_job.h"
#include "app/studio/nouns/probe/probe_state.h"
#include "app/studio/nouns/probe/probe_tool.h"
#include "app/studio/nouns/taxel/tool_state.h"
#include "ui/theme.h"

namespace taxel::ui {

namespace {

/// Draws the handle at which a placed probe can be grabbed.
void draw_probe_handle(const WindowUi& ui, const Viewer& viewer, const Shown& shown, const ProbeState& probe,
                       ImDrawList& list) {
  if (!probe.on || probe.held || !probe.at) return;
  const ImVec2 at = on_screen(viewer, shown_pose(viewer, shown) * *probe.at);
  const float radius = 8 * static_cast<float>(ui.pixel_scale);
  const Palette& colors = palette(ui.dark);
  list.AddCircle(at, radius, to_u32(colors.panel, 0.8f), 0, 4.0f);
  list.AddCircle(at, radius, to_u32(colors.accent), 0, 2.0f);
}

/// Returns the text about the mouse while the probe is held. Empty otherwise.
const char* probe_hint(const ProbeState& probe) {
  return probe.held ? "Probe: wheel or drag sets the depth, a click puts it down   Esc ends" : "";
}

bool point_probe(App& app, const PointerEvent& event) {
  return handle_probe_mouse(*app.ui, *app.viewer, *app.shown, app.get<ToolState>().tool != Tool::none,
                            app.get<ProbeState>(), event);
}

}  // namespace

constinit const Feature kProbe{
    .gives_readings = [](const App& app) { return app.get<ProbeState>().on; },
    .tool = {"probe", kLayout, point_probe, 8, [](const App& app) { return app.get<ProbeState>().on; },
             [](App& app) { leave_probe(app.get<ProbeState>()); }},
    .draw_on_view =
        [](const App& app) {
          draw_probe_handle(*app.ui, *app.viewer, *app.shown, app.get<ProbeState>(), *ImGui::GetWindowDrawList());
        },
    .hint =
        [](const App& app, std::vector<ViewHint>& lines) {
          if (app.viewer->mode == Mode::layout) lines.push_back({probe_hint(app.get<ProbeState>())});
        },
    .make_job = studio::make_probe_job,
    .dump = dump_probe,
};

}  // namespace taxel::ui
