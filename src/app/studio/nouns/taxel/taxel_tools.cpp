// The mouse of the tools that edit the layout, and their lines and hints over the view.
#include "app/studio/nouns/taxel/taxel_commands.h"

#include <imgui.h>

#include <array>
#include <cmath>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/pointer_event.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/shown_scene.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/brush/brush.h"
#include "app/studio/nouns/generate/generate_state.h"
#include "app/studio/nouns/scenario/scenario_state.h"
#include "app/studio/nouns/select/select.h"
#include "app/studio/nouns/taxel/tool_state.h"
#include "ui/theme.h"
#include "ui/widgets/format.h"

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

namespace {

constexpr int kRingPieces = 64;

/// Draws the preview of a taxel: the centre, the normal, and the receptive field as a circle in the tangent plane.
void draw_ghost(const WindowUi& ui, const Viewer& viewer, const Shown& shown, const ToolState& tool, ImDrawList& list) {
  const ImGuiIO& io = ImGui::GetIO();
  const bool placing = tool.tool == Tool::place || (tool.tool == Tool::none && io.KeyCtrl);
  const bool over = ImGui::IsItemHovered() && !ImGui::IsAnyMouseDown();
  if (!placing || !over) return;
  const double x = static_cast<double>(io.MousePos.x - viewer.view.rect.x0);
  const double y = static_cast<double>(io.MousePos.y - viewer.view.rect.y0);
  const auto ghost = placement_ghost(viewer, shown, tool, x, y);
  if (!ghost) return;
  const Pose X_WM = shown_pose(viewer, shown);
  const Taxel& taxel = ghost->taxel;
  const dvec3 n = taxel.normal, helper = std::abs(n.x) < 0.5 ? dvec3(1, 0, 0) : dvec3(0, 1, 0);
  const dvec3 u = glm::normalize(glm::cross(n, helper)), v = glm::cross(n, u);
  const ImU32 color = to_u32(palette(ui.dark).accent);
  std::array<ImVec2, kRingPieces> ring;
  for (int i = 0; i < kRingPieces; ++i) {
    const double angle = 2 * glm::pi<double>() * i / kRingPieces;
    const dvec3 p = taxel.center + taxel.radius * (std::cos(angle) * u + std::sin(angle) * v);
    ring[static_cast<std::size_t>(i)] = on_screen(viewer, X_WM * p);
  }
  list.AddPolyline(ring.data(), kRingPieces, color, 1.6f, ImDrawFlags_Closed);
  const ImVec2 center = on_screen(viewer, X_WM * taxel.center);
  list.AddLine(center, on_screen(viewer, X_WM * (taxel.center + 0.7 * taxel.radius * n)), color, 2.0f);
  list.AddCircleFilled(center, 4, color);
  ImGui::SetTooltip("%s\n%s samples", in_mm(taxel.radius).c_str(), grouped(ghost->samples).c_str());
}

void draw_area(const WindowUi& ui, const Viewer& viewer, const ToolState& tool, ImDrawList& list) {
  const std::vector<dvec2>& area = tool.area;
  if (area.empty()) return;
  const ImU32 color = to_u32(palette(ui.dark).accent), fill = to_u32(palette(ui.dark).accent, 0.12f);
  const auto on_view = [&](const dvec2& p) {
    return ImVec2(viewer.view.rect.x0 + static_cast<float>(p.x), viewer.view.rect.y0 + static_cast<float>(p.y));
  };
  const ImVec2 a = on_view(area.front()), b = ImGui::GetIO().MousePos;
  if (tool.tool == Tool::lasso) {
    std::vector<ImVec2> path;
    for (const dvec2& p : area) path.push_back(on_view(p));
    path.push_back(b);
    list.AddConcavePolyFilled(path.data(), static_cast<int>(path.size()), fill);
    list.AddPolyline(path.data(), static_cast<int>(path.size()), color, 1.4f, ImDrawFlags_Closed);
    return;
  }
  const ImVec2 lo(std::min(a.x, b.x), std::min(a.y, b.y)), hi(std::max(a.x, b.x), std::max(a.y, b.y));
  list.AddRectFilled(lo, hi, fill);
  list.AddRect(lo, hi, color, 0, 1.4f);
}

/// Returns a text about the action and the keys of the active tool. Empty without a tool.
std::string hint_of(const ToolState& tool) {
  const std::string typed = tool.input.typed.empty() ? "" : "   [" + tool.input.typed + "]";
  constexpr const char* kEnd = "   Enter accepts, Esc cancels";
  switch (tool.tool) {
    case Tool::none:
      return {};
    case Tool::place:
      return "Place: click on the surface   Esc ends";
    case Tool::slide:
      return "Slide: " + tool.value + "   Ctrl corners, Shift finer, Esc cancels";
    case Tool::move:
      return "Move: " + tool.value + typed + "   X Y Z, digits (mm), Ctrl snaps, Shift finer" + kEnd;
    case Tool::way_point:
      return "Way point: " + tool.value + typed + "   X Y Z, digits (mm), Ctrl snaps, Shift finer" + kEnd;
    case Tool::turn:
      return "Turn: " + tool.value + typed + "   X Y Z, digits (\u00b0), Ctrl snaps, Shift finer" + kEnd;
    case Tool::resize:
      return "Radius: " + tool.value + typed + "   digits (mm), Ctrl snaps, Shift finer" + kEnd;
    case Tool::box:
      return "Box: drag around taxels   Shift adds, Ctrl takes out, Esc cancels";
    case Tool::lasso:
      return "Lasso: draw around taxels   Shift adds, Ctrl takes out, Esc cancels";
    case Tool::brush:
      return "Brush: drag paints   Shift or Ctrl erases, wheel: radius, Esc ends";
  }
  return {};
}

bool point_tool(App& app, const PointerEvent& event) {
  // Only a press looks for a taxel in the scene.
  return handle_tool_mouse(*app.ui, *app.viewer, *app.shown, app.get<ToolState>(), app.get<GenerateState>(),
                           app.get<PathState>(), event.left().pressed ? scene_input(app) : SceneInput{}, event.at.x,
                           event.at.y, event.hovered);
}

void draw_tool(const App& app) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ToolState& tool = app.get<ToolState>();
  draw_ghost(*app.ui, *app.viewer, *app.shown, tool, list);
  draw_area(*app.ui, *app.viewer, tool, list);
}

/// Returns the line about several selected taxels, which every gesture changes together. Empty for fewer.
std::string hint_of_selection(const App& app) {
  const std::size_t count = app.viewer->selection.taxels.size();
  if (count < 2 || !can_edit(*app.viewer, *app.shown) || app.get<GenerateState>().open) return {};
  return fmt::format("{} taxels are selected: a drag moves them all   Click selects one, Esc none", count);
}

void add_hints(const App& app, std::vector<ViewHint>& lines) {
  const ToolState& tool = app.get<ToolState>();
  lines.push_back({tool.tool == Tool::none ? hint_of_selection(app) : hint_of(tool)});
  if (app.viewer->mode == Mode::layout)
    lines.push_back({tool.problem.empty() ? app.shown->document.editing.problem : tool.problem, true});
}

}  // namespace

constinit const Feature kTaxelTools{
    .tool = {"taxel", kEverywhere, point_tool, 2,
             [](const App& app) { return app.get<ToolState>().tool != Tool::none; },
             [](App& app) { cancel_tool(*app.ui, app.viewer->selection, app.get<ToolState>()); }},
    .draw_on_view = draw_tool,
    .hint = add_hints,
    .dump = dump_tool,
};

}  // namespace taxel::ui
