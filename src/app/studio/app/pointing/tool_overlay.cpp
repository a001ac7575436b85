#include "app/studio/app/pointing/tool_overlay.h"

#include <fmt/format.h>
#include <imgui.h>

#include <array>
#include <cmath>

#include "app/studio/app/app.h"
#include "app/studio/app/pointing/shown_scene.h"
#include "app/studio/app/pointing/view_drawing.h"
#include "app/studio/app/values/layout_features.h"
#include "app/studio/app/values/shown.h"
#include "app/studio/app/values/viewer.h"
#include "app/studio/app/values/window_ui.h"
#include "app/studio/features/brush/brush_card.h"
#include "app/studio/features/camera/frame_tool.h"
#include "app/studio/features/generate/generate_panel.h"
#include "app/studio/features/measure/measure_overlay.h"
#include "app/studio/features/probe/probe_overlay.h"
#include "app/studio/features/taxel/gesture.h"
#include "ui/theme.h"
#include "ui/widgets/format.h"

namespace taxel::ui {

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

/// Draws the directions of the finger's tip and pad while the directions are a guess or are being set.
void draw_frame_arrows(const WindowUi& ui, const Viewer& viewer, const Shown& shown, const MeshState& mesh,
                       ImDrawList& list) {
  for (const FrameArrow& arrow : frame_arrows(viewer, shown, mesh)) {
    const ImVec2 from = on_screen(viewer, arrow.from_W), to = on_screen(viewer, arrow.to_W);
    const float dx = to.x - from.x, dy = to.y - from.y, length = std::hypot(dx, dy), unit = ImGui::GetFontSize();
    const ImU32 color = to_u32(palette(ui.dark).accent);
    if (length > 1) {
      const ImVec2 ahead(dx / length, dy / length), base(to.x - 0.8f * unit * ahead.x, to.y - 0.8f * unit * ahead.y);
      list.AddLine(from, base, color, 0.2f * unit);
      list.AddTriangleFilled(to, {base.x - 0.35f * unit * ahead.y, base.y + 0.35f * unit * ahead.x},
                             {base.x + 0.35f * unit * ahead.y, base.y - 0.35f * unit * ahead.x}, color);
    }
    list.AddText({to.x + 0.4f * unit, to.y - 0.5f * unit}, color, arrow.name);
  }
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

/// Returns the text about the next click. Empty if no direction of the finger is being set.
std::string pick_hint(const MeshState& mesh) {
  if (mesh.pick == FramePick::none) return "";
  return fmt::format("Click a face of the {}   Esc ends", mesh.pick == FramePick::tip ? "tip" : "pad");
}

}  // namespace

int draw_tool_overlay(const App& app) {
  const WindowUi& ui = *app.ui;
  const Viewer& viewer = *app.viewer;
  const Shown& shown = *app.shown;
  const ToolState& tool = app.layout->tool;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Palette& colors = palette(ui.dark);
  int row = 0;
  const auto add_line = [&](const std::string& text, const ImVec4& color) {
    if (!text.empty()) draw_view_line(ui, viewer.view, list, row++, text, color);
  };
  if (viewer.mode != Mode::layout) {
    add_line(hint_of(tool), colors.text);
    return row;
  }
  draw_frame_arrows(ui, viewer, shown, app.layout->mesh, list);
  draw_ghost(ui, viewer, shown, tool, list);
  draw_area(ui, viewer, tool, list);
  draw_brush_ring(ui, viewer, shown, tool);
  draw_pattern_frame(viewer, shown, app.layout->generate);
  draw_probe_handle(ui, viewer, shown, app.layout->probe, list);
  draw_measure_label(ui, viewer, shown, app.layout->measure, list);
  add_line(pick_hint(app.layout->mesh), colors.text);
  add_line(measure_hint(app.layout->measure), colors.text);
  add_line(probe_hint(app.layout->probe), colors.text);
  add_line(hint_of(tool), colors.text);
  add_line(tool.problem.empty() ? shown.document.editing.problem : tool.problem, colors.error);
  return row;
}

}  // namespace taxel::ui
