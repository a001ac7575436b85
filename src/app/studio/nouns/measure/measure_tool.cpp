// The measure tool: two clicks on the surface, and their distance, straight and along the surface.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "app/studio/frame/app.h"
#include "app/studio/frame/pointer_event.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/shown_scene.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/measure/measure_state.h"
#include "app/studio/nouns/probe/probe_state.h"
#include "app/studio/nouns/taxel/taxel_commands.h"
#include "app/studio/nouns/taxel/tool_state.h"
#include "ui/scene/scene_parts.h"
#include "ui/theme.h"
#include "ui/widgets/format.h"

namespace taxel::ui {
namespace {

constexpr double kSnap = 12;  // largest distance at which a point snaps to a taxel's centre, at scale 1 [pixels]

/// Returns the centre of the taxel near the pointer, or the place of the skin under the pointer.
std::optional<MeasurePoint> point_at(const WindowUi& ui, const Viewer& viewer, const Shown& displayed,
                                     const SceneInput& scene, const dvec2& at) {
  const double reach = kSnap * ui.pixel_scale;
  const auto under = pick(scene, viewer.camera(), at.x, at.y, viewer.view.width, viewer.view.height, reach);
  if (under && under->taxel >= 0 && under->taxel < displayed.document.model->taxel_count()) {
    const Taxel& taxel = displayed.document.model->layout.taxels[static_cast<std::size_t>(under->taxel)];
    return MeasurePoint{taxel.center, taxel.id};
  }
  const auto shown =
      shown_part(scene.clip, viewer.camera().pixel_ray(at.x, at.y, viewer.view.width, viewer.view.height));
  if (!shown) return std::nullopt;
  const auto place = place_under(*displayed.document.model->skin, in_frame(shown_pose(viewer, displayed), shown->ray));
  if (!place) return std::nullopt;
  return MeasurePoint{place->position, std::nullopt};
}

}  // namespace

void leave_measure(MeasureState& measure) {
  measure = {};
}

bool can_measure(const Viewer& viewer, const DocumentView& document) {
  return viewer.mode == Mode::layout && document.model != nullptr;
}

bool toggle_measure(const Viewer& viewer, const DocumentView& document, MeasureState& measure) {
  const bool on = measure.on;
  leave_measure(measure);
  measure.on = !on && can_measure(viewer, document);
  return measure.on;
}

std::optional<MeasureRequest> measure_request(const Viewer& viewer, const DocumentView& document,
                                              const MeasureState& measure) {
  if (!measure.on || measure.points.size() != 2 || viewer.mode != Mode::layout || !document.model) return std::nullopt;
  return MeasureRequest{document.model->skin, measure.points[0].at, measure.points[1].at};
}

bool handle_measure_mouse(const WindowUi& ui, const Viewer& viewer, const Shown& shown, bool has_other_tool,
                          MeasureState& measure, const SceneInput& scene, const PointerEvent& event) {
  measure.hover.reset();
  if (!measure.on || viewer.mode != Mode::layout || !shown.document.model || has_other_tool) return false;
  if (!event.hovered || event.ctrl || event.shift) return false;
  const bool clicked = event.left().clicked();
  if (event.any_down || (!clicked && event.left().released)) return false;
  measure.hover = point_at(ui, viewer, shown, scene, event.at);
  if (!clicked || !measure.hover) return clicked;
  if (measure.points.size() == 2) measure.points.clear();
  measure.points.push_back(*measure.hover);
  return true;
}

void carry_out(const ToggleMeasure&, App& app) {
  if (toggle_measure(*app.viewer, app.shown->document, app.get<MeasureState>())) leave_tool(app);
}

namespace {

/// Draws the two distances next to the middle of the line.
void draw_measure_label(const WindowUi& ui, const Viewer& viewer, const Shown& shown, const MeasureState& measure,
                        ImDrawList& list) {
  const Measured* measured = shown.document.measured.get();
  if (!measure.on || measured == nullptr) return;
  const dvec3 middle = measured->path.empty() ? 0.5 * (measured->request.a + measured->request.b)
                                              : measured->path[measured->path.size() / 2];
  const ImVec2 at = on_screen(viewer, shown_pose(viewer, shown) * middle);
  const std::string along =
      std::isfinite(measured->along) ? in_mm(measured->along) + " along the surface" : "no way along the surface";
  const std::string text = in_mm(measured->straight) + " straight\n" + along;
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  const Palette& colors = palette(ui.dark);
  const float gap = ImGui::GetFontSize();
  const ImVec2 corner(std::round(std::clamp(at.x + gap, viewer.view.rect.x0 + 8, viewer.view.rect.x1 - size.x - 8)),
                      std::round(std::clamp(at.y + gap, viewer.view.rect.y0 + 8, viewer.view.rect.y1 - size.y - 8)));
  list.AddRectFilled({corner.x - 6, corner.y - 4}, {corner.x + size.x + 6, corner.y + size.y + 4},
                     to_u32(colors.panel, 0.9f), 3);
  list.AddText(corner, to_u32(colors.text), text.c_str());
}

/// Returns the text about the next click. Empty if the tool is off.
std::string measure_hint(const MeasureState& measure) {
  if (!measure.on) return "";
  return fmt::format("Measure: click on the {} point   Esc ends", measure.points.size() == 1 ? "second" : "first");
}

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
    .tool = {"measure", kLayout, point_measure, 9, [](const App& app) { return app.get<MeasureState>().on; },
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
