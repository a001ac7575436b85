#include "app/studio/features/probe/probe_tool.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/studio/app/pointing/shown_scene.h"
#include "app/studio/app/pointing/surface_place.h"
#include "app/studio/features/taxel/gesture.h"
#include "ui/scene/scene_cast.h"

namespace taxel::ui {

namespace {

constexpr double kReach = 9;          // of a probe that was put down, at scale 1 [pixels]
constexpr double kNotchPart = 5e-3;   // of the sensor's size: the most that a notch may be
constexpr double kRadiusPart = 0.15;  // likewise of a probe
constexpr double kPrecise = 0.1;      // of the pace, while Shift is held
constexpr int kFirstNotches = 5;      // depth of a probe that was just fitted

double size_of(const UiInput& input) {
  return input.model->mesh->bounds().diagonal();
}

void set_depth(UiState& ui, const UiInput& input, double depth) {
  ui.probe.settings.depth = std::clamp(depth, 0.0, kDeepestProbe * size_of(input));
}

/// Reduces all shapes to a size at which the probe does not hide the sensor.
void fit_to_sensor(ProbeSettings& settings, double size) {
  const double radius = std::min(settings.sphere().radius, kRadiusPart * size);
  for (ProbeShape& shape : settings.shapes) std::visit([&](auto& one) { one.shrink_to(radius); }, shape);
  settings.depth = std::min(settings.depth, kFirstNotches * probe_notch(size));
}

std::optional<SurfacePlace> place_at(const UiState& ui, const UiInput& input, double x, double y) {
  const auto shown = shown_part(ui.clip, ui.camera().pixel_ray(x, y, ui.view.width, ui.view.height));
  if (!shown) return std::nullopt;
  return place_under(*input.model->skin, in_frame(shown_pose(ui, input), shown->ray));
}

/// Whether the pointer is on a probe that was put down.
bool reaches(const UiState& ui, double x, double y) {
  if (!ui.probe.at) return false;
  const dvec3 pixel = ui.camera().project(*ui.probe.at, ui.view.width, ui.view.height);
  return pixel.z > 0 && glm::length(dvec2(pixel) - dvec2(x, y)) <= kReach * ui.pixel_scale;
}

double metres_per_pixel(const UiState& ui) {
  const Camera& camera = ui.camera();
  return 2 * camera.distance * std::tan(0.5 * glm::radians(camera.fov_deg)) / std::max(1, ui.view.height);
}

void follow_pointer(UiState& ui, const UiInput& input, double x, double y) {
  if (const auto place = place_at(ui, input, x, y)) ui.probe.at = place->position;
}

/// While the button is down: a held probe goes deeper as the pointer goes down, one that lies is led over the skin.
void drag(UiState& ui, const UiInput& input, double x, double y) {
  const ImGuiIO& io = ImGui::GetIO();
  ProbeState& probe = ui.probe;
  probe.dragged = probe.dragged || ImGui::IsMouseDragging(ImGuiMouseButton_Left);
  if (!probe.dragged) return;
  if (!probe.held) return follow_pointer(ui, input, x, y);
  const double pace = metres_per_pixel(ui) * (io.KeyShift ? kPrecise : 1.0);
  set_depth(ui, input, probe.settings.depth + pace * static_cast<double>(io.MouseDelta.y));
}

}  // namespace

double probe_notch(double diagonal) {
  const double most = kNotchPart * diagonal, decade = std::pow(10.0, std::floor(std::log10(most)));
  return decade * (most >= 5 * decade ? 5 : most >= 2 * decade ? 2 : 1);
}

bool can_probe(const UiState& ui, const UiInput& input) {
  return ui.mode == Mode::layout && input.model != nullptr;
}

void leave_probe(UiState& ui) {
  ui.probe.on = ui.probe.held = ui.probe.pressed = false;
  ui.probe.at.reset();
  ui.probe.largest = 0;
}

void toggle_probe(UiState& ui, const UiInput& input) {
  if (ui.probe.on) return leave_probe(ui);
  if (!can_probe(ui, input)) return;
  if (ui.tool.tool != Tool::none) cancel_tool(ui);
  if (!ui.probe.sized) fit_to_sensor(ui.probe.settings, size_of(input));
  ui.probe.sized = true;
  ui.probe.on = ui.probe.held = true;
}

std::optional<Probe> probe_request(const UiState& ui) {
  const ProbeState& state = ui.probe;
  if (!state.on || !state.at || ui.mode != Mode::layout) return std::nullopt;
  const ProbeSettings& settings = state.settings;
  Probe probe;
  probe.shape = settings.shape();
  probe.material = settings.material;
  probe.point = *state.at;
  probe.depth = settings.depth;
  probe.roll_deg = settings.roll_deg;
  return probe;
}

bool handle_probe_mouse(UiState& ui, const UiInput& input, double x, double y, bool hovered) {
  ProbeState& probe = ui.probe;
  if (!probe.on || !can_probe(ui, input)) return false;
  const ImGuiIO& io = ImGui::GetIO();
  if (ui.tool.tool != Tool::none) {  // another tool was taken up: the probe stays where it is
    probe.held = probe.pressed = false;
    return false;
  }
  if (probe.pressed) {
    drag(ui, input, x, y);
    if (ImGui::IsMouseDown(ImGuiMouseButton_Left)) return true;
    // Held, it is put down; put down, it is dropped where it was led, or taken up again by a click.
    probe.held = !probe.held && !probe.dragged;
    probe.pressed = false;
    return true;
  }
  if (!hovered || io.KeyCtrl) return false;
  const bool over = probe.held ? place_at(ui, input, x, y).has_value() : reaches(ui, x, y);
  if (probe.held && over && !ImGui::IsAnyMouseDown() && !ImGui::IsMouseReleased(ImGuiMouseButton_Left)) {
    follow_pointer(ui, input, x, y);
  }
  if (!over) return false;
  if (io.MouseWheel != 0 && !io.KeyShift) {
    const double step = probe_notch(size_of(input));
    set_depth(ui, input, step * std::round(ui.probe.settings.depth / step + static_cast<double>(io.MouseWheel)));
    return true;
  }
  if (ImGui::IsMouseClicked(ImGuiMouseButton_Left) && !io.KeyShift) {
    probe.pressed = true;
    probe.dragged = false;
    return true;
  }
  return probe.held && ImGui::IsMouseReleased(ImGuiMouseButton_Left);
}

}  // namespace taxel::ui
