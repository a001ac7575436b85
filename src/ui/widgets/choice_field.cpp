#include "ui/widgets/choice_field.h"

#include <imgui.h>

namespace taxel::ui {

std::optional<std::size_t> choice_of(Ui& ui, const std::string& name, std::span<const std::string_view> choices,
                                     std::size_t chosen, float width) {
  ImGui::SetNextItemWidth(width);
  const std::string shown(choices[chosen]);
  const bool open = ImGui::BeginCombo(("##" + name).c_str(), shown.c_str());
  if (!open) {
    ui.widgets.note_item(name);
    return std::nullopt;
  }
  std::optional<std::size_t> made;
  for (std::size_t i = 0; i < choices.size(); ++i) {
    const std::string text(choices[i]);
    if (ImGui::Selectable(text.c_str(), i == chosen) && i != chosen) made = i;
    if (i == chosen) ImGui::SetItemDefaultFocus();
    ui.widgets.note_item(text);
  }
  ImGui::EndCombo();
  if (made) ui.fields.last = {name, ""};
  return made;
}

std::optional<bool> switch_field(Ui& ui, const std::string& name, bool on) {
  const bool switched = ImGui::Checkbox(("##" + name).c_str(), &on);
  ui.widgets.note_item(name);
  if (!switched) return std::nullopt;
  ui.fields.last = {name, ""};
  return on;
}

}  // namespace taxel::ui
