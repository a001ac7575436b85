#include "app/studio/features/view/tool_overlay.h"

#include <fmt/format.h>
#include <imgui.h>

#include <array>
#include <cmath>

#include "app/studio/app/pointing/shown_scene.h"
#include "app/studio/features/brush/brush_card.h"
#include "app/studio/features/camera/frame_tool.h"
#include "app/studio/features/generate/generate_panel.h"
#include "app/studio/features/taxel/gesture.h"
#include "ui/theme.h"
#include "ui/widgets/format.h"

namespace taxel::ui {

namespace {

constexpr int kRingPieces = 64;

ImVec2 on_screen(const Viewer& viewer, const dvec3& p_W) {
  const dvec3 pixel = viewer.project(p_W);
  return {viewer.view.rect.x0 + static_cast<float>(pixel.x), viewer.view.rect.y0 + static_cast<float>(pixel.y)};
}

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

}  // namespace

float view_line_top(const ViewPlace& place, int row) {
  const float line = ImGui::GetFontSize();
  return std::round(place.rect.y0 + 2.9f * line + 1.7f * line * static_cast<float>(row));
}

void draw_view_line(const WindowUi& ui, const ViewPlace& place, ImDrawList& list, int row, const std::string& text,
                    const ImVec4& color) {
  const float line = ImGui::GetFontSize();
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  const ImVec2 at(place.rect.x0 + 0.8f * line, view_line_top(place, row));
  list.AddRectFilled({at.x - 6, at.y - 3}, {at.x + size.x + 6, at.y + size.y + 3},
                     to_u32(palette(ui.dark).panel, 0.85f), 3);
  list.AddText(at, to_u32(color), text.c_str());
}

int draw_tool_overlay(const WindowUi& ui, const Viewer& viewer, const Shown& shown, const ToolState& tool,
                      const GenerateState& generate, const ProbeState& probe, const MeasureState& measure,
                      const MeshState& mesh) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Palette& colors = palette(ui.dark);
  if (viewer.mode != Mode::layout) {
    const std::string hint = hint_of(tool);
    if (!hint.empty()) draw_view_line(ui, viewer.view, list, 0, hint, colors.text);
    return hint.empty() ? 0 : 1;
  }
  draw_frame_arrows(ui, viewer, shown, mesh, list);
  draw_ghost(ui, viewer, shown, tool, list);
  draw_area(ui, viewer, tool, list);
  draw_brush_ring(ui, viewer, shown, tool);
  draw_pattern_frame(viewer, shown, generate);
  draw_probe_handle(ui, viewer, shown, probe, list);
  draw_measure_label(ui, viewer, shown, measure, list);
  int row = 0;
  if (mesh.pick != FramePick::none) {
    const char* which = mesh.pick == FramePick::tip ? "tip" : "pad";
    draw_view_line(ui, viewer.view, list, row++, fmt::format("Click a face of the {}   Esc ends", which), colors.text);
  }
  if (measure.on) {
    const char* which = measure.points.size() == 1 ? "second" : "first";
    draw_view_line(ui, viewer.view, list, row++, fmt::format("Measure: click on the {} point   Esc ends", which),
                   colors.text);
  }
  if (probe.held) {
    draw_view_line(ui, viewer.view, list, row++, "Probe: wheel or drag sets the depth, a click puts it down   Esc ends",
                   colors.text);
  }
  if (const std::string hint = hint_of(tool); !hint.empty())
    draw_view_line(ui, viewer.view, list, row++, hint, colors.text);
  const std::string& problem = tool.problem.empty() ? shown.document.editing.problem : tool.problem;
  if (!problem.empty()) draw_view_line(ui, viewer.view, list, row++, problem, colors.error);
  return row;
}

}  // namespace taxel::ui
