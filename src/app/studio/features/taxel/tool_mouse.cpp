#include "app/studio/features/taxel/tool_mouse.h"

#include <imgui.h>

#include "app/studio/app/pointing/shown_scene.h"
#include "app/studio/features/brush/brush.h"
#include "app/studio/features/generate/generate.h"
#include "app/studio/features/scenario/path_tool.h"
#include "app/studio/features/select/area_select.h"
#include "app/studio/features/taxel/gesture.h"

namespace taxel::ui {

namespace {

void move_pointer(ToolState& tool) {
  const ImGuiIO& io = ImGui::GetIO();
  constexpr double kPrecise = 0.1;
  tool.input.snap = io.KeyCtrl;
  tool.input.precise = io.KeyShift;
  tool.input.pointer += (io.KeyShift ? kPrecise : 1.0) *
                        dvec2(static_cast<double>(io.MouseDelta.x), static_cast<double>(io.MouseDelta.y));
}

/// A press on a selected taxel may become a slide.
void watch_press(UiState& ui, const UiInput& input, double x, double y) {
  constexpr double kReach = 12;
  const ImGuiIO& io = ImGui::GetIO();
  if (!ImGui::IsMouseClicked(ImGuiMouseButton_Left) || io.KeyCtrl || io.KeyShift || ui.selection.empty()) return;
  const double reach = kReach * ui.pixel_scale;
  const auto under = pick(scene_input(ui, input), ui.camera(), x, y, ui.view.width, ui.view.height, reach);
  if (!under || under->taxel < 0 || under->taxel >= input.model->taxel_count()) return;
  const int id = input.model->layout.taxels[static_cast<std::size_t>(under->taxel)].id;
  if (ui.selection.contains(id)) ui.tool.pressed_taxel = id;
}

void begin_slide(UiState& ui, const UiInput& input) {
  const int id = ui.tool.pressed_taxel;
  const Selection before = ui.selection;
  ui.selection.add(id);  // the taxel under the pointer leads the others
  begin_gesture(ui, input, Tool::slide);
  ui.tool.selection = before;
  ui.tool.pressed_taxel = -1;
  const ImVec2 at = ImGui::GetIO().MouseClickedPos[ImGuiMouseButton_Left];
  ui.tool.pointer_start = {static_cast<double>(at.x - ui.view.rect.x0), static_cast<double>(at.y - ui.view.rect.y0)};
  const ImVec2 now = ImGui::GetIO().MousePos;
  ui.tool.input.pointer = {static_cast<double>(now.x - ui.view.rect.x0), static_cast<double>(now.y - ui.view.rect.y0)};
}

}  // namespace

bool handle_tool_mouse(UiState& ui, const UiInput& input, double x, double y, bool hovered) {
  ToolState& tool = ui.tool;
  if (!tool.released) {  // the press that ended a gesture, or the drag that Esc has cancelled, does nothing more
    tool.released = !ImGui::IsAnyMouseDown() && !ImGui::IsMouseReleased(ImGuiMouseButton_Left);
    if (!tool.released && tool.tool == Tool::none) return true;
  }
  const bool usable = tool.tool == Tool::way_point ? has_way_point(ui, input) : can_edit(ui, input);
  if (!usable) {
    if (tool.tool != Tool::none) cancel_tool(ui);
    return false;
  }
  if (tool.tool == Tool::box || tool.tool == Tool::lasso) {
    if (draw_area(ui, input, {x, y}, hovered)) end_tool(ui);
    return true;
  }
  if (tool.tool == Tool::brush) return brush_mouse(ui, input, x, y, hovered);
  if (tool.follows()) {
    if (tool.done) move_pointer(tool);
    follow_gesture(ui, input);
    const bool dragged = tool.tool == Tool::slide;
    const bool done =
        dragged ? !ImGui::IsMouseDown(ImGuiMouseButton_Left) : hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Left);
    if (done) {
      accept_gesture(ui, input);
    } else if (ImGui::IsMouseClicked(ImGuiMouseButton_Right)) {
      cancel_tool(ui);
    }
    return true;
  }
  if (tool.tool == Tool::place && hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Right)) {
    end_tool(ui);
    return true;
  }
  if (tool.tool == Tool::none && frame_mouse(ui, input, x, y, hovered)) return true;
  if (tool.tool == Tool::none && hovered && !ui.generate.open) watch_press(ui, input, x, y);
  if (tool.pressed_taxel < 0) return false;
  if (!ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
    tool.pressed_taxel = -1;
    return false;  // it was a click
  }
  if (ImGui::IsMouseDragging(ImGuiMouseButton_Left)) {
    begin_slide(ui, input);
    follow_gesture(ui, input);
  }
  return true;
}

}  // namespace taxel::ui
