#include "app/studio/nouns/measure/measure.h"

#include <imgui.h>

#include "app/studio/frame/app.h"
#include "app/studio/frame/pointer_event.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/shown_scene.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/measure/measure_job.h"
#include "app/studio/nouns/measure/measure_overlay.h"
#include "app/studio/nouns/measure/measure_state.h"
#include "app/studio/nouns/measure/measure_tool.h"
#include "app/studio/nouns/probe/probe_state.h"
#include "app/studio/nouns/taxel/tool_state.h"

namespace taxel::ui {

namespace {

bool point_measure(App& app, const PointerEvent& event) {
  if (!app.get<MeasureState>().on) return false;
  const bool has_other_tool = app.get<ToolState>().tool != Tool::none || app.get<ProbeState>().held;
  return handle_measure_mouse(*app.ui, *app.viewer, *app.shown, has_other_tool, app.get<MeasureState>(),
                              scene_input(app), event);
}

void mark_measured(const App& app, SceneInput& scene) {
  const MeasureState& measure = app.get<MeasureState>();
  if (app.viewer->mode != Mode::layout || !measure.on) return;
  scene.measured = app.shown->document.measured;
  for (const MeasurePoint& point : measure.points) scene.measure_points.push_back(point.at);
  if (measure.hover) scene.measure_points.push_back(measure.hover->at);
}

}  // namespace

constinit const Feature kMeasure{
    .tool = {"measure", kLayout, point_measure, 7, [](const App& app) { return app.get<MeasureState>().on; },
             [](App& app) { leave_measure(app.get<MeasureState>()); }},
    .mark = mark_measured,
    .draw_on_view =
        [](const App& app) {
          draw_measure_label(*app.ui, *app.viewer, *app.shown, app.get<MeasureState>(), *ImGui::GetWindowDrawList());
        },
    .hint =
        [](const App& app, std::vector<ViewHint>& lines) {
          if (app.viewer->mode == Mode::layout) lines.push_back({measure_hint(app.get<MeasureState>())});
        },
    .make_job = studio::make_measure_job,
    .dump = dump_measure,
};

}  // namespace taxel::ui
