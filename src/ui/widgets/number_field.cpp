#include "ui/widgets/number_field.h"

#include <fmt/format.h>
#include <imgui.h>
#include <misc/cpp/imgui_stdlib.h>

#include <algorithm>
#include <functional>

#include "core/base/expression.h"
#include "ui/widgets/format.h"

namespace taxel::ui {

namespace {

/// The text of the field that is typed in now belongs to ImGui; others show what there is.
std::optional<std::string> edited_text(UiState& ui, const std::string& name, const std::string& shown, bool mixed,
                                       float width) {
  const std::string id = "##" + name;
  ImGui::SetNextItemWidth(width);
  std::string text = shown;
  const char* hint = !mixed ? "" : width < 0 ? "mixed" : "...";  // where there is no room for more
  ImGui::InputTextWithHint(id.c_str(), hint, &text, ImGuiInputTextFlags_AutoSelectAll);
  const bool typed = ImGui::IsItemDeactivatedAfterEdit();
  ui.widgets.note_item(name);
  return typed ? std::optional(text) : std::nullopt;
}

template <class T>
bool differ(const std::vector<T>& values) {
  return std::adjacent_find(values.begin(), values.end(), std::not_equal_to<>()) != values.end();
}

}  // namespace

std::optional<double> number_field(UiState& ui, const std::string& name, const std::vector<double>& values,
                                   const FieldUnit& unit, float width) {
  const bool mixed = differ(values);
  const std::string shown = mixed || values.empty()
                                ? ""
                                : fmt::format("{:.{}f}", shifted_decimal(values.front(), -unit.decimal), unit.digits);
  const std::optional<std::string> typed = edited_text(ui, name, shown, mixed, width);
  if (!typed || *typed == shown) return std::nullopt;
  try {
    return shifted_decimal(evaluate(*typed, unit.name), unit.decimal);
  } catch (const Error& error) {
    ui.tool.problem = fmt::format("{}: {}", name, error.what());
    return std::nullopt;
  }
}

std::optional<std::string> text_field(UiState& ui, const std::string& name, const std::vector<std::string>& values,
                                      float width) {
  const bool mixed = differ(values);
  const std::string shown = mixed || values.empty() ? "" : values.front();
  std::optional<std::string> typed = edited_text(ui, name, shown, mixed, width);
  return typed && *typed != shown ? typed : std::nullopt;
}

}  // namespace taxel::ui
