#include "app/studio/features/measure/measure_tool.h"

#include <imgui.h>

#include "app/studio/app/pointing/shown_scene.h"
#include "app/studio/app/pointing/surface_place.h"
#include "app/studio/features/taxel/gesture.h"
#include "ui/scene/scene_cast.h"

namespace taxel::ui {

namespace {

constexpr double kSnap = 12;  // to taxel centres, at scale 1 [pixels]

/// The taxel whose centre is near the pointer, or the place of the skin below it.
std::optional<MeasurePoint> point_at(const UiState& ui, const UiInput& input, double x, double y) {
  const SceneInput scene = scene_input(ui, input);
  const double reach = kSnap * ui.pixel_scale;
  const auto under = pick(scene, ui.camera(), x, y, ui.view.width, ui.view.height, reach);
  if (under && under->taxel >= 0 && under->taxel < input.model->taxel_count()) {
    const Taxel& taxel = input.model->layout.taxels[static_cast<std::size_t>(under->taxel)];
    return MeasurePoint{taxel.center, taxel.id};
  }
  const auto shown = shown_part(scene.clip, ui.camera().pixel_ray(x, y, ui.view.width, ui.view.height));
  if (!shown) return std::nullopt;
  const auto place = place_under(*input.model->skin, in_frame(shown_pose(ui, input), shown->ray));
  if (!place) return std::nullopt;
  return MeasurePoint{place->position, std::nullopt};
}

}  // namespace

void leave_measure(UiState& ui) {
  ui.measure = {};
}

void toggle_measure(UiState& ui, const UiInput& input) {
  const bool on = ui.measure.on;
  leave_measure(ui);
  if (on || !input.model || ui.mode != Mode::layout) return;
  if (ui.tool.tool != Tool::none) cancel_tool(ui);
  ui.measure.on = true;
}

std::optional<MeasureRequest> measure_request(const UiState& ui, const UiInput& input) {
  if (!ui.measure.on || ui.measure.points.size() != 2 || ui.mode != Mode::layout || !input.model) return std::nullopt;
  return MeasureRequest{input.model->skin, ui.measure.points[0].at, ui.measure.points[1].at};
}

bool handle_measure_mouse(UiState& ui, const UiInput& input, double x, double y, bool hovered) {
  MeasureState& measure = ui.measure;
  measure.hover.reset();
  if (!measure.on || ui.mode != Mode::layout || !input.model || ui.tool.tool != Tool::none || ui.probe.held)
    return false;
  const ImGuiIO& io = ImGui::GetIO();
  if (!hovered || io.KeyCtrl || io.KeyShift) return false;
  const bool clicked =
      ImGui::IsMouseReleased(ImGuiMouseButton_Left) &&
      io.MouseDragMaxDistanceSqr[ImGuiMouseButton_Left] < io.MouseDragThreshold * io.MouseDragThreshold;
  if (ImGui::IsAnyMouseDown() || (!clicked && ImGui::IsMouseReleased(ImGuiMouseButton_Left))) return false;
  measure.hover = point_at(ui, input, x, y);
  if (!clicked || !measure.hover) return clicked;
  if (measure.points.size() == 2) measure.points.clear();
  measure.points.push_back(*measure.hover);
  return true;
}

}  // namespace taxel::ui
