#include "app/studio/app/dock_layout.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <utility>

namespace taxel::ui {

namespace {

/// Parts of the width and height at 1280 x 800 and at larger sizes alike.
constexpr float kTimeline = 0.25f, kBottom = 0.34f, kLeft = 0.213f, kRight = 0.245f, kOutliner = 0.40f, kBars = 0.36f,
                kPlot = 0.56f;

/// Where text is large for the window, panels that stand side by side become tabs: its size, in heights of text.
constexpr float kCompactWidth = 60, kCompactHeight = 42;
constexpr float kCompactBottom = 0.42f, kCompactLeft = 0.24f, kCompactRight = 0.34f;

void arrange_compactly(ImGuiID space) {
  ImGuiID rest = 0, bottom = 0, left = 0, right = 0, center = 0;
  ImGui::DockBuilderSplitNode(space, ImGuiDir_Down, kCompactBottom, &bottom, &rest);
  ImGui::DockBuilderSplitNode(rest, ImGuiDir_Left, kCompactLeft, &left, &center);
  ImGui::DockBuilderSplitNode(center, ImGuiDir_Right, kCompactRight / (1 - kCompactLeft), &right, &center);
  ImGui::DockBuilderDockWindow(kViewTitle, center);
  for (const char* title : {kTaxelsTitle, kOutlinerTitle}) ImGui::DockBuilderDockWindow(title, left);
  for (const char* title : {kInspectorTitle, kControlsTitle, kGenerateTitle, kExplainTitle, kRealTitle})
    ImGui::DockBuilderDockWindow(title, right);
  for (const char* title :
       {kBarsTitle, kMapTitle, kPlotTitle, kModelsTitle, kProfilerTitle, kSectionTitle, kTimelineTitle, kMessagesTitle})
    ImGui::DockBuilderDockWindow(title, bottom);
  ImGui::DockBuilderGetNode(center)->SetLocalFlags(static_cast<ImGuiDockNodeFlags>(ImGuiDockNodeFlags_NoTabBar));
}

void arrange_side_by_side(ImGuiID space) {
  ImGuiID rest = 0, bottom = 0, left = 0, right = 0, center = 0, outliner = 0, taxels = 0, bars = 0, plot = 0,
          section = 0, timeline = 0;
  ImGui::DockBuilderSplitNode(space, ImGuiDir_Down, kTimeline, &timeline, &rest);
  ImGui::DockBuilderSplitNode(rest, ImGuiDir_Down, kBottom, &bottom, &rest);
  ImGui::DockBuilderSplitNode(rest, ImGuiDir_Left, kLeft, &left, &center);
  ImGui::DockBuilderSplitNode(center, ImGuiDir_Right, kRight / (1 - kLeft), &right, &center);
  ImGui::DockBuilderSplitNode(left, ImGuiDir_Up, kOutliner, &outliner, &taxels);
  ImGui::DockBuilderSplitNode(bottom, ImGuiDir_Left, kBars, &bars, &plot);
  ImGui::DockBuilderSplitNode(plot, ImGuiDir_Left, kPlot, &plot, &section);
  ImGui::DockBuilderDockWindow(kViewTitle, center);
  ImGui::DockBuilderDockWindow(kOutlinerTitle, outliner);
  ImGui::DockBuilderDockWindow(kTaxelsTitle, taxels);
  ImGui::DockBuilderDockWindow(kInspectorTitle, right);
  ImGui::DockBuilderDockWindow(kControlsTitle, right);
  ImGui::DockBuilderDockWindow(kGenerateTitle, right);
  ImGui::DockBuilderDockWindow(kExplainTitle, right);
  ImGui::DockBuilderDockWindow(kRealTitle, right);
  ImGui::DockBuilderDockWindow(kBarsTitle, bars);
  ImGui::DockBuilderDockWindow(kMapTitle, bars);
  ImGui::DockBuilderDockWindow(kMessagesTitle, bars);
  ImGui::DockBuilderDockWindow(kPlotTitle, plot);
  ImGui::DockBuilderDockWindow(kSectionTitle, section);
  ImGui::DockBuilderDockWindow(kTimelineTitle, timeline);
  ImGui::DockBuilderDockWindow(kModelsTitle, timeline);
  ImGui::DockBuilderDockWindow(kProfilerTitle, timeline);
  ImGui::DockBuilderGetNode(center)->SetLocalFlags(static_cast<ImGuiDockNodeFlags>(ImGuiDockNodeFlags_NoTabBar));
}

bool is_compact(ImVec2 size, float line) {
  return size.x < kCompactWidth * line || size.y < kCompactHeight * line;
}

void arrange(ImGuiID space, ImVec2 size, bool compactly) {
  ImGui::DockBuilderRemoveNode(space);
  ImGui::DockBuilderAddNode(space, static_cast<ImGuiDockNodeFlags>(ImGuiDockNodeFlags_DockSpace));
  ImGui::DockBuilderSetNodeSize(space, size);
  compactly ? arrange_compactly(space) : arrange_side_by_side(space);
  ImGui::DockBuilderFinish(space);
}

/// Text has become too large for the arrangement, or small enough for the other one. A window that becomes small keeps
/// its own, for it may become large again.
bool scale_wants_another(UiState& ui, ImVec2 size) {
  const double before = std::exchange(ui.arranged_scale, ui.pixel_scale);
  const float line = ImGui::GetFontSize(), line_before = line * static_cast<float>(before / ui.pixel_scale);
  return before > 0 && is_compact(size, line) != is_compact(size, line_before);
}

}  // namespace

void draw_dock_space(UiState& ui) {
  const ImGuiViewport* viewport = ImGui::GetMainViewport();
  const ImGuiID space = ImGui::GetID("Taxel Studio");
  const bool another = scale_wants_another(ui, viewport->Size);  // whatever rows the bars need
  if (another || ui.reset_arrangement || ImGui::DockBuilderGetNode(space) == nullptr)
    arrange(space, viewport->WorkSize, is_compact(viewport->Size, ImGui::GetFontSize()));
  ui.reset_arrangement = false;
  ImGui::SetNextWindowBgAlpha(0);  // the window is cleared to this colour already
  ImGui::DockSpaceOverViewport(space, viewport);
}

}  // namespace taxel::ui
