#include "ui/widgets/flow.h"

#include <imgui.h>

#include <algorithm>

namespace taxel::ui {

Flow::Flow(float gap) : gap_(gap), right_(ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x) {}

void Flow::place(float width, float gap) {
  if (rows_ == 0) {
    rows_ = 1;
    return;
  }
  ImGui::SameLine(0, gap);
  if (ImGui::GetCursorScreenPos().x + width <= right_ + 0.5f) return;
  ImGui::NewLine();
  ++rows_;
}

void Flow::last(float width, float most) {
  place(std::max(width, most), gap_);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::SetCursorScreenPos({std::max(at.x, right_ - width), at.y});
}

}  // namespace taxel::ui
