#include "app/studio/nouns/probe/probe.h"

#include <imgui.h>

#include "app/studio/frame/app.h"
#include "app/studio/frame/pointer_event.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/probe/probe_job.h"
#include "app/studio/nouns/probe/probe_overlay.h"
#include "app/studio/nouns/probe/probe_state.h"
#include "app/studio/nouns/probe/probe_tool.h"
#include "app/studio/nouns/taxel/tool_state.h"

namespace taxel::ui {

namespace {

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
