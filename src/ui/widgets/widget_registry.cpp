#include "ui/widgets/widget_registry.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>

namespace taxel::ui {

std::string panel_name(const ImGuiWindow* window) {
  while (window->ParentWindow != nullptr && (window->Flags & ImGuiWindowFlags_ChildWindow) != 0 &&
         window->DockNode == nullptr) {
    window = window->ParentWindow;
  }
  const std::string name = window->Name;
  return name.substr(0, name.find("##"));
}

void WidgetRegistry::note(std::string_view panel, std::string_view label, const Rect& rect, bool field) {
  entries_.push_back({std::string(panel), std::string(label), rect, field});
}

void WidgetRegistry::note_item(std::string_view label, bool field) {
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

}  // namespace taxel::ui
