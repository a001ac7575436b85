// The probe tool: grabs a probe, moves the probe over the skin, sets its depth and places it.
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/studio/frame/app.h"
#include "app/studio/frame/pointer_event.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/shown_scene.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/probe/probe_job.h"
#include "app/studio/nouns/probe/probe_state.h"
#include "app/studio/nouns/taxel/taxel_commands.h"
#include "app/studio/nouns/taxel/tool_state.h"
#include "app/studio/nouns/timeline/run_commands.h"
#include "ui/scene/scene_parts.h"
#include "ui/theme.h"

namespace taxel::ui {
namespace {

constexpr double kProbeReach = 9;     // distance at which a placed probe is grabbed, at scale 1 [pixels]
constexpr double kNotchPart = 5e-3;   // largest depth per notch, as a fraction of the sensor's size
constexpr double kRadiusPart = 0.15;  // largest radius of a fitted probe, as a fraction of the sensor's size
constexpr double kPrecise = 0.1;      // factor on the speed while Shift is held
constexpr int kFirstNotches = 5;      // depth of a newly fitted probe, in notches

double size_of(const DocumentView& document) {
  return document.model->mesh->bounds().diagonal();
}

void set_depth(const DocumentView& document, ProbeState& probe, double depth) {
  probe.settings.depth = std::clamp(depth, 0.0, kDeepestProbe * size_of(document));
}

/// Reduces all shapes to a size at which the probe does not hide the sensor.
void fit_to_sensor(ProbeSettings& settings, double size) {
  const double radius = std::min(settings.sphere().radius, kRadiusPart * size);
  for (ProbeShape& shape : settings.shapes) std::visit([&](auto& one) { one.shrink_to(radius); }, shape);
  settings.depth = std::min(settings.depth, kFirstNotches * probe_notch(size));
}

std::optional<SurfacePlace> place_at(const Viewer& viewer, const Shown& displayed, const dvec2& at) {
  const auto shown =
      shown_part(viewer.clip, viewer.camera().pixel_ray(at.x, at.y, viewer.view.width, viewer.view.height));
  if (!shown) return std::nullopt;
  return place_under(*displayed.document.model->skin, in_frame(shown_pose(viewer, displayed), shown->ray));
}

/// Returns whether the pointer is on a placed probe.
bool reaches(const WindowUi& ui, const Viewer& viewer, const ProbeState& probe, const dvec2& at) {
  if (!probe.at) return false;
  const dvec3 pixel = viewer.project(*probe.at);
  return pixel.z > 0 && glm::length(dvec2(pixel) - at) <= kProbeReach * ui.pixel_scale;
}

double metres_per_pixel(const Viewer& viewer) {
  return viewer.camera().pixel_size(viewer.camera().distance, viewer.view.height);
}

void follow_pointer(const Viewer& viewer, const Shown& shown, ProbeState& probe, const dvec2& at) {
  if (const auto place = place_at(viewer, shown, at)) probe.at = place->position;
}

/// Handles a drag while the button is held. A grabbed probe goes deeper as the pointer moves down, and a placed probe
/// is moved over the skin.
void drag(const Viewer& viewer, const Shown& shown, ProbeState& probe, const PointerEvent& event) {
  probe.dragged = probe.dragged || event.left().dragged();
  if (!probe.dragged) return;
  if (!probe.held) return follow_pointer(viewer, shown, probe, event.at);
  const double pace = metres_per_pixel(viewer) * (event.shift ? kPrecise : 1.0);
  set_depth(shown.document, probe, probe.settings.depth + pace * event.delta.y);
}

}  // namespace

double probe_notch(double diagonal) {
  const double most = kNotchPart * diagonal, decade = std::pow(10.0, std::floor(std::log10(most)));
  return decade * (most >= 5 * decade ? 5 : most >= 2 * decade ? 2 : 1);
}

bool can_probe(const Viewer& viewer, const DocumentView& document) {
  return viewer.mode == Mode::layout && document.model != nullptr;
}

void leave_probe(ProbeState& probe) {
  probe.on = probe.held = probe.pressed = false;
  probe.at.reset();
  probe.largest = probe.largest_reading = 0;
}

bool toggle_probe(const Viewer& viewer, const DocumentView& document, ProbeState& probe) {
  if (probe.on) {
    leave_probe(probe);
    return false;
  }
  if (!can_probe(viewer, document)) return false;
  if (!probe.sized) fit_to_sensor(probe.settings, size_of(document));
  probe.sized = true;
  probe.on = probe.held = true;
  return true;
}

std::optional<Probe> probe_request(const Viewer& viewer, const ProbeState& state) {
  if (!state.on || !state.at || viewer.mode != Mode::layout) return std::nullopt;
  const ProbeSettings& settings = state.settings;
  Probe probe;
  probe.shape = settings.shape();
  probe.material = settings.material;
  probe.point = *state.at;
  probe.depth = settings.depth;
  probe.roll_deg = settings.roll_deg;
  return probe;
}

bool handle_probe_mouse(const WindowUi& ui, const Viewer& viewer, const Shown& shown, bool has_other_tool,
                        ProbeState& probe, const PointerEvent& event) {
  if (!probe.on || !can_probe(viewer, shown.document)) return false;
  if (has_other_tool) {  // another tool is active: the probe stays at its place
    probe.held = probe.pressed = false;
    return false;
  }
  if (probe.pressed) {
    drag(viewer, shown, probe, event);
    if (event.left().down) return true;
    // A grabbed probe is placed. A placed probe is left where a drag has moved it, or grabbed again by a click.
    probe.held = !probe.held && !probe.dragged;
    probe.pressed = false;
    return true;
  }
  if (!event.hovered || event.ctrl) return false;
  const bool over = probe.held ? place_at(viewer, shown, event.at).has_value() : reaches(ui, viewer, probe, event.at);
  if (probe.held && over && !event.any_down && !event.left().released) {
    follow_pointer(viewer, shown, probe, event.at);
  }
  if (!over) return false;
  if (event.wheel != 0 && !event.shift) {
    const double step = probe_notch(size_of(shown.document));
    set_depth(shown.document, probe, step * std::round(probe.settings.depth / step + event.wheel));
    return true;
  }
  if (event.left().pressed && !event.shift) {
    probe.pressed = true;
    probe.dragged = false;
    return true;
  }
  return probe.held && event.left().released;
}

void carry_out(const ToggleProbe&, App& app) {
  if (toggle_probe(*app.viewer, app.shown->document, app.get<ProbeState>())) leave_tool(app);
}

void carry_out(const ProbeInLayout&, App& app) {
  app.ui->post(SetMode{Mode::layout});
  if (!app.get<ProbeState>().on) app.ui->post(ToggleProbe{});
}

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
    .tool = {"probe", kLayout, point_probe, 10, [](const App& app) { return app.get<ProbeState>().on; },
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
