#include "app/studio/nouns/taxel/tool_mouse.h"

#include <imgui.h>

#include "app/studio/frame/shown_scene.h"
#include "app/studio/nouns/brush/brush.h"
#include "app/studio/nouns/generate/generate.h"
#include "app/studio/nouns/scenario/path_tool.h"
#include "app/studio/nouns/select/area_select.h"
#include "app/studio/nouns/taxel/gesture.h"

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
void watch_press(WindowUi& ui, const Viewer& viewer, const DocumentView& document, ToolState& tool,
                 const SceneInput& scene, double x, double y) {
  constexpr double kReach = 12;
  const ImGuiIO& io = ImGui::GetIO();
  if (!ImGui::IsMouseClicked(ImGuiMouseButton_Left) || io.KeyCtrl || io.KeyShift || viewer.selection.empty()) return;
  const double reach = kReach * ui.pixel_scale;
  const auto under = pick(scene, viewer.camera(), x, y, viewer.view.width, viewer.view.height, reach);
  if (!under || under->taxel < 0 || under->taxel >= document.model->taxel_count()) return;
  const int id = document.model->layout.taxels[static_cast<std::size_t>(under->taxel)].id;
  if (viewer.selection.contains(id)) tool.pressed_taxel = id;
}

void begin_slide(WindowUi& ui, Viewer& viewer, const Shown& shown, ToolState& tool, PathState& path) {
  const int id = tool.pressed_taxel;
  const Selection before = viewer.selection;
  viewer.selection.add(id);  // makes the taxel under the pointer the active one
  begin_gesture(ui, viewer, shown, tool, path, Tool::slide);
  tool.selection = before;
  tool.pressed_taxel = -1;
  const ImVec2 at = ImGui::GetIO().MouseClickedPos[ImGuiMouseButton_Left];
  tool.pointer_start = {static_cast<double>(at.x - viewer.view.rect.x0),
                        static_cast<double>(at.y - viewer.view.rect.y0)};
  const ImVec2 now = ImGui::GetIO().MousePos;
  tool.input.pointer = {static_cast<double>(now.x - viewer.view.rect.x0),
                        static_cast<double>(now.y - viewer.view.rect.y0)};
}

}  // namespace

bool handle_tool_mouse(WindowUi& ui, Viewer& viewer, const Shown& shown, ToolState& tool, GenerateState& generate,
                       PathState& path, const SceneInput& scene, double x, double y, bool hovered) {
  if (!tool.released) {  // ignores the press that ended a gesture and the drag that Esc has cancelled
    tool.released = !ImGui::IsAnyMouseDown() && !ImGui::IsMouseReleased(ImGuiMouseButton_Left);
    if (!tool.released && tool.tool == Tool::none) return true;
  }
  const bool usable = tool.tool == Tool::way_point ? has_way_point(viewer, shown, path) : can_edit(viewer, shown);
  if (!usable) {
    if (tool.tool != Tool::none) cancel_tool(ui, viewer.selection, tool);
    return false;
  }
  if (tool.tool == Tool::box || tool.tool == Tool::lasso) {
    if (draw_area(viewer, shown, tool, {x, y}, hovered)) end_tool(tool);
    return true;
  }
  if (tool.tool == Tool::brush) return brush_mouse(ui, viewer, shown, tool, x, y, hovered);
  if (tool.follows()) {
    if (tool.done) move_pointer(tool);
    follow_gesture(ui, viewer, shown, tool, path);
    const bool dragged = tool.tool == Tool::slide;
    const bool done =
        dragged ? !ImGui::IsMouseDown(ImGuiMouseButton_Left) : hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Left);
    if (done) {
      accept_gesture(ui, viewer, shown, tool, path);
    } else if (ImGui::IsMouseClicked(ImGuiMouseButton_Right)) {
      cancel_tool(ui, viewer.selection, tool);
    }
    return true;
  }
  if (tool.tool == Tool::place && hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Right)) {
    end_tool(tool);
    return true;
  }
  if (tool.tool == Tool::none && frame_mouse(ui, viewer, shown, generate, x, y, hovered)) return true;
  if (tool.tool == Tool::none && hovered && !generate.open) watch_press(ui, viewer, shown.document, tool, scene, x, y);
  if (tool.pressed_taxel < 0) return false;
  if (!ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
    tool.pressed_taxel = -1;
    return false;  // it was a click
  }
  if (ImGui::IsMouseDragging(ImGuiMouseButton_Left)) {
    begin_slide(ui, viewer, shown, tool, path);
    follow_gesture(ui, viewer, shown, tool, path);
  }
  return true;
}

}  // namespace taxel::ui
