#include "ui/widgets/ui.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <utility>

namespace taxel::ui {

std::string panel_name(const ImGuiWindow* window) {
  while (window->ParentWindow != nullptr && (window->Flags & ImGuiWindowFlags_ChildWindow) != 0 &&
         window->DockNode == nullptr) {
    window = window->ParentWindow;
  }
  const std::string name = window->Name;
  return name.substr(0, name.find("##"));
}

bool WidgetRegistry::shows_panel(std::string_view panel) const {
  return std::ranges::count(panels_, panel) + std::ranges::count(panels_before_, panel) > 0;
}

void Ui::open_in_front(bool& open) {
  open = true;
  if (std::ranges::count(opened, &open) == 0) opened.push_back(&open);
}

void WidgetRegistry::note(std::string_view panel, std::string_view label, const Rect& rect, bool field) {
  entries_.push_back({std::string(panel), std::string(label), rect, field});
}

void WidgetRegistry::begin_frame() {
  panels_before_ = std::exchange(panels_, {});
  entries_.clear();
  if (sought_.label.empty() || --sought_.frames > 0) return;
  SoughtWidget other = std::move(sought_);
  other.label = std::exchange(other.instead, {});
  seek(std::move(other));
}

void WidgetRegistry::seek(SoughtWidget widget) {
  // A mode may have to change, a panel to appear and a section to open, each of which takes a few frames.
  constexpr int kFrames = 12;
  sought_ = std::move(widget);
  sought_.frames = kFrames;
}

void WidgetRegistry::focus_if_sought(std::string_view label) {
  const std::string_view shown = label.substr(0, label.find("##"));
  // The first of three fields of a vector has the name of the vector and its axis.
  if (shown != sought_.label && shown != sought_.label + " X") return;
  if (panel_name(ImGui::GetCurrentWindowRead()) != sought_.panel) return;
  ImGui::SetKeyboardFocusHere(-1);
  ImGui::SetNavCursorVisible(true);
  ImGui::ScrollToItem(ImGuiScrollFlags_AlwaysCenterY);
  sought_ = {};
}

void WidgetRegistry::note_item(std::string_view label, bool field) {
  if (!sought_.label.empty()) focus_if_sought(label);
  if (!ImGui::IsItemVisible()) return;
  ImRect rect(ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
  const ImGuiWindow* window = ImGui::GetCurrentWindowRead();
  rect.ClipWithFull(window->ClipRect);
  if (rect.GetWidth() < 1 || rect.GetHeight() < 1) return;
  note(panel_name(window), label.substr(0, label.find("##")), {rect.Min.x, rect.Min.y, rect.Max.x, rect.Max.y}, field);
}

const WidgetRegistry::Entry* WidgetRegistry::find(std::string_view name) const {
  const auto matches = [&](const Entry& entry) {
    return entry.label == name ||
           (name.size() == entry.panel.size() + 1 + entry.label.size() && name.starts_with(entry.panel) &&
            name[entry.panel.size()] == '/' && name.ends_with(entry.label));
  };
  const auto found = std::find_if(entries_.rbegin(), entries_.rend(), matches);
  return found == entries_.rend() ? nullptr : &*found;
}

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
  fields.popups = g.OpenPopupStack.Size;
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

void keep_keyboard(Ui& ui, std::string_view panel) {
  ui.fields.keyboard_panel = panel;
  ui.fields.entering = kEnteringPictures;
}

bool is_modal_open() {
  return ImGui::GetTopMostPopupModal() != nullptr;
}

bool escapes_dialog(const Ui& ui) {
  if (!ImGui::IsKeyPressed(ImGuiKey_Escape, false)) return false;
  const ImGuiContext& g = *ImGui::GetCurrentContext();
  const int dialog = g.BeginPopupStack.Size;  // number of popups up to the dialog
  // ImGui may have used Esc to show the mark of an entry, and may have closed the list before this frame.
  if (g.OpenPopupStack.Size > dialog) ImGui::ClosePopupToLevel(dialog, true);
  return ui.fields.popups <= dialog;
}

void enter_panel(Ui& ui, const char* title) {
  ui.fields.entered_panel = title;
  keep_keyboard(ui, title);
}

void focus_if_entered(Ui& ui, const char* title) {
  if (ui.fields.entered_panel != title) return;
  ui.fields.entered_panel.clear();
  ImGui::SetKeyboardFocusHere();
  ImGui::SetNavCursorVisible(true);
}

}  // namespace taxel::ui
