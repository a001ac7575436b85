#include "app/studio/frame/pointer_event.h"

#include <imgui.h>

namespace taxel::ui {

static_assert(ImGuiMouseButton_Left == 0 && ImGuiMouseButton_Right == 1 && ImGuiMouseButton_Middle == 2);

PointerEvent read_pointer(const ViewPlace& place) {
  const ImGuiIO& io = ImGui::GetIO();
  PointerEvent event;
  event.at = {static_cast<double>(io.MousePos.x - place.rect.x0), static_cast<double>(io.MousePos.y - place.rect.y0)};
  event.delta = {static_cast<double>(io.MouseDelta.x), static_cast<double>(io.MouseDelta.y)};
  event.wheel = static_cast<double>(io.MouseWheel);
  event.hovered = ImGui::IsItemHovered();
  event.grabbed = ImGui::IsItemActive();
  event.any_down = ImGui::IsAnyMouseDown();
  event.ctrl = io.KeyCtrl;
  event.shift = io.KeyShift;
  event.alt = io.KeyAlt;
  for (int i = 0; i < 3; ++i) {
    ButtonState& button = event.buttons[static_cast<std::size_t>(i)];
    button.down = ImGui::IsMouseDown(i);
    button.pressed = ImGui::IsMouseClicked(i);
    button.double_pressed = ImGui::IsMouseDoubleClicked(i);
    button.released = ImGui::IsMouseReleased(i);
    button.moved = io.MouseDragMaxDistanceSqr[i] >= io.MouseDragThreshold * io.MouseDragThreshold;
  }
  return event;
}

bool is_pointer_resting() {
  return !ImGui::IsAnyMouseDown() && ImGui::IsItemHovered(ImGuiHoveredFlags_ForTooltip);
}

}  // namespace taxel::ui
