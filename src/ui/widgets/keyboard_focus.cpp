#include "ui/widgets/keyboard_focus.h"

#include <imgui_internal.h>

#include <algorithm>
#include <array>

namespace taxel::ui {

namespace {

/// Number of frames until ImGui has executed a request for the focus, which takes two more frames.
constexpr int kEnteringPictures = 3;

bool is_typing(const ImGuiContext& g) {
  return g.ActiveId != 0 && g.ActiveId == g.InputTextState.ID;
}

bool walks(int key) {
  constexpr std::array kKeys = {ImGuiKey_Tab,       ImGuiKey_Space,     ImGuiKey_Enter,    ImGuiKey_KeypadEnter,
                                ImGuiKey_Escape,    ImGuiKey_LeftArrow, ImGuiKey_UpArrow,  ImGuiKey_RightArrow,
                                ImGuiKey_DownArrow, ImGuiKey_PageUp,    ImGuiKey_PageDown, ImGuiKey_Home,
                                ImGuiKey_End};
  return std::find(kKeys.begin(), kKeys.end(), key) != kKeys.end();
}

}  // namespace

void record_keyboard(Ui& ui, const std::vector<int>& selection) {
  const ImGuiContext& g = *ImGui::GetCurrentContext();
  const bool typing = is_typing(g);
  const bool popup = ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
  FieldState& fields = ui.fields;
  fields.had_keys = typing || popup || fields.in_menus;
  fields.entering = std::max(0, fields.entering - 1);
  const ImGuiWindow* window = typing ? g.ActiveIdWindow : g.NavCursorVisible && g.NavId != 0 ? g.NavWindow : nullptr;
  if (window != nullptr) {
    fields.keyboard_panel = panel_name(window);
  } else if (fields.entering == 0) {
    fields.keyboard_panel.clear();
  }
  if (fields.refused && fields.refused->selection != selection) fields.refused.reset();
  fields.selection = selection;
}

bool widgets_take(const Ui& ui, int chord) {
  const bool plain = (chord & ImGuiMod_Mask_ & ~ImGuiMod_Shift) == 0;
  return plain && !ui.fields.keyboard_panel.empty() && walks(chord & ~ImGuiMod_Mask_);
}

void enter_panel(Ui& ui, const char* title) {
  ui.fields.keyboard_panel = ui.fields.entered_panel = title;
  ui.fields.entering = kEnteringPictures;
}

void focus_if_entered(Ui& ui, const char* title) {
  if (ui.fields.entered_panel != title) return;
  ui.fields.entered_panel.clear();
  ImGui::SetKeyboardFocusHere();
  ImGui::SetNavCursorVisible(true);
}

}  // namespace taxel::ui
