#include "ui/widgets/plot_click.h"

#include <imgui.h>
#include <implot.h>

namespace taxel::ui {

bool plot_clicked() {
  const ImVec2 lo = ImPlot::GetPlotPos(), size = ImPlot::GetPlotSize(), at = ImGui::GetIO().MousePos;
  const bool inside = at.x >= lo.x && at.y >= lo.y && at.x < lo.x + size.x && at.y < lo.y + size.y;
  constexpr auto kHovered = ImGuiHoveredFlags_AllowWhenBlockedByActiveItem | ImGuiHoveredFlags_ChildWindows;
  return inside && ImGui::IsMouseClicked(ImGuiMouseButton_Left) && ImGui::IsWindowHovered(kHovered);
}

}  // namespace taxel::ui
