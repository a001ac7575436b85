#include "app/studio/app/dock_layout.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <array>
#include <utility>

#include "app/studio/app/app.h"

namespace taxel::ui {

namespace {

/// Fractions of the width and height, at every size.
constexpr float kTimeline = 0.25f, kBottom = 0.34f, kLeft = 0.213f, kRight = 0.245f, kOutliner = 0.40f, kBars = 0.36f,
                kPlot = 0.56f;

/// Where text is large for the window, panels that stand side by side become tabs: its size, in heights of text.
constexpr float kCompactWidth = 60, kCompactHeight = 42;
constexpr float kCompactBottom = 0.42f, kCompactLeft = 0.24f, kCompactRight = 0.34f;

using Docks = std::array<ImGuiID, 8>;  ///< ImGui's dock node of each Dock; 0 for floating

ImGuiID& node(Docks& docks, Dock dock) {
  return docks.at(static_cast<std::size_t>(dock));
}

/// Returns the nodes. The one that is left over, in the centre, is for the view.
Docks split_compactly(ImGuiID space, ImGuiID* center) {
  ImGuiID rest = 0, bottom = 0, left = 0, right = 0;
  ImGui::DockBuilderSplitNode(space, ImGuiDir_Down, kCompactBottom, &bottom, &rest);
  ImGui::DockBuilderSplitNode(rest, ImGuiDir_Left, kCompactLeft, &left, center);
  ImGui::DockBuilderSplitNode(*center, ImGuiDir_Right, kCompactRight / (1 - kCompactLeft), &right, center);
  return {0, left, left, right, bottom, bottom, bottom, bottom};
}

Docks split_side_by_side(ImGuiID space, ImGuiID* center) {
  Docks docks{};
  ImGuiID rest = 0, below = 0, left = 0, plots = 0;
  ImGui::DockBuilderSplitNode(space, ImGuiDir_Down, kTimeline, &node(docks, Dock::lowest), &rest);
  ImGui::DockBuilderSplitNode(rest, ImGuiDir_Down, kBottom, &below, &rest);
  ImGui::DockBuilderSplitNode(rest, ImGuiDir_Left, kLeft, &left, center);
  ImGui::DockBuilderSplitNode(*center, ImGuiDir_Right, kRight / (1 - kLeft), &node(docks, Dock::right), center);
  ImGui::DockBuilderSplitNode(left, ImGuiDir_Up, kOutliner, &node(docks, Dock::upper_left), &node(docks, Dock::left));
  ImGui::DockBuilderSplitNode(below, ImGuiDir_Left, kBars, &node(docks, Dock::bottom_left), &plots);
  ImGui::DockBuilderSplitNode(plots, ImGuiDir_Left, kPlot, &node(docks, Dock::bottom),
                              &node(docks, Dock::bottom_right));
  return docks;
}

bool is_compact(ImVec2 size, float line) {
  return size.x < kCompactWidth * line || size.y < kCompactHeight * line;
}

void arrange(ImGuiID space, ImVec2 size, bool compactly, std::span<const PanelSpec> panels) {
  ImGui::DockBuilderRemoveNode(space);
  ImGui::DockBuilderAddNode(space, static_cast<ImGuiDockNodeFlags>(ImGuiDockNodeFlags_DockSpace));
  ImGui::DockBuilderSetNodeSize(space, size);
  ImGuiID center = 0;
  Docks docks = compactly ? split_compactly(space, &center) : split_side_by_side(space, &center);
  ImGui::DockBuilderDockWindow(kViewTitle, center);
  for (const PanelSpec& panel : panels)
    if (panel.dock != Dock::floating) ImGui::DockBuilderDockWindow(panel.title, node(docks, panel.dock));
  ImGui::DockBuilderGetNode(center)->SetLocalFlags(static_cast<ImGuiDockNodeFlags>(ImGuiDockNodeFlags_NoTabBar));
  ImGui::DockBuilderFinish(space);
}

/// Text has become too large for the arrangement, or small enough for the other one. A window that becomes small keeps
/// its own, for it may become large again.
bool scale_wants_another(App& app, ImVec2 size) {
  const double before = std::exchange(app.window.arrangement.scale, app.ui.pixel_scale);
  const float line = ImGui::GetFontSize(), line_before = line * static_cast<float>(before / app.ui.pixel_scale);
  return before > 0 && is_compact(size, line) != is_compact(size, line_before);
}

}  // namespace

void draw_dock_space(App& app, std::span<const PanelSpec> panels) {
  const ImGuiViewport* viewport = ImGui::GetMainViewport();
  const ImGuiID space = ImGui::GetID("Taxel Studio");
  const bool another = scale_wants_another(app, viewport->Size);  // whatever rows the bars need
  if (another || app.window.arrangement.reset || ImGui::DockBuilderGetNode(space) == nullptr)
    arrange(space, viewport->WorkSize, is_compact(viewport->Size, ImGui::GetFontSize()), panels);
  app.window.arrangement.reset = false;
  ImGui::SetNextWindowBgAlpha(0);  // the window is cleared to this colour already
  ImGui::DockSpaceOverViewport(space, viewport);
}

}  // namespace taxel::ui
