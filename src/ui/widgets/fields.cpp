#include "ui/widgets/fields.h"

#include <fmt/format.h>
#include <imgui.h>
#include <misc/cpp/imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/text/expression.h"
#include "ui/theme.h"
#include "ui/widgets/format.h"

namespace taxel::ui {
namespace {

/// Draws a text field and returns its text when the user accepts it. While the user types, ImGui has the text;
/// otherwise the field displays the present value or the refused text.
std::optional<std::string> edited_text(Ui& ui, const std::string& name, const std::string& shown, bool mixed,
                                       float width) {
  std::optional<Refusal>& refused = ui.fields.refused;
  const bool kept = refused && refused->input.field == name && !refused->input.typed.empty();
  const std::string before = kept ? refused->input.typed : shown;
  std::string text = before;
  ImGui::SetNextItemWidth(width);
  ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, kept ? 1.5f : 0.0f);
  ImGui::PushStyleColor(ImGuiCol_Border, palette(ui.dark).error);
  const char* hint = !mixed ? "" : width < 0 ? "mixed" : "...";  // narrow fields have no room for "mixed"
  ImGui::InputTextWithHint(("##" + name).c_str(), hint, &text, ImGuiInputTextFlags_AutoSelectAll);
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
  ui.widgets.note_item(name, true);
  if (!ImGui::IsItemDeactivated()) return std::nullopt;
  const bool left = ImGui::IsKeyPressed(ImGuiKey_Escape, false) || text == shown;
  if (kept && left) refused.reset();
  if (left || text == before || !ImGui::IsItemDeactivatedAfterEdit()) return std::nullopt;
  ui.fields.last = {name, text};
  return text;
}

/// Returns the typed number in SI. A text that is not a number is refused.
std::optional<double> number_of(Ui& ui, const std::string& typed, const FieldUnit& unit) {
  try {
    return shifted_decimal(evaluate(typed, unit.name), unit.decimal);
  } catch (const Error& error) {
    refuse(ui, error.what());
    return std::nullopt;
  }
}

template <class T>
bool differ(const std::vector<T>& values) {
  return std::adjacent_find(values.begin(), values.end(), std::not_equal_to<>()) != values.end();
}

}  // namespace

std::string shown_number(double value, const FieldUnit& unit) {
  const double shown = shifted_decimal(value, -unit.decimal);
  return unit.digits < 0 ? fmt::format("{}", shown) : fmt::format("{:.{}f}", shown, unit.digits);
}

std::optional<double> number_field(Ui& ui, const std::string& name, const std::vector<double>& values,
                                   const FieldUnit& unit, float width) {
  const bool mixed = differ(values);
  const std::string shown = mixed || values.empty() ? "" : shown_number(values.front(), unit);
  const std::optional<std::string> typed = edited_text(ui, name, shown, mixed, width);
  return typed ? number_of(ui, *typed, unit) : std::nullopt;
}

std::optional<std::uint64_t> whole_field(Ui& ui, const std::string& name, std::uint64_t value, std::uint64_t most) {
  const std::optional<std::string> typed = edited_text(ui, name, std::to_string(value), false, -1);
  const std::optional<double> number = typed ? number_of(ui, *typed, {}) : std::nullopt;
  if (!number) return std::nullopt;
  if (*number == std::floor(*number) && *number >= 0 && *number <= static_cast<double>(most))
    return static_cast<std::uint64_t>(*number);
  refuse(ui, fmt::format("must be a whole number from 0 to {}, is {}", most, *typed));
  return std::nullopt;
}

std::optional<std::optional<double>> optional_field(Ui& ui, const std::string& name, const std::optional<double>& value,
                                                    const FieldUnit& unit) {
  const std::optional<std::string> typed = edited_text(ui, name, value ? shown_number(*value, unit) : "", false, -1);
  if (!typed) return std::nullopt;
  if (typed->empty()) return std::optional<double>();
  const std::optional<double> number = number_of(ui, *typed, unit);
  return number ? std::optional(number) : std::nullopt;
}

std::optional<AxisValue> vector_field(Ui& ui, const std::string& name, const std::vector<dvec3>& values,
                                      const FieldUnit& unit) {
  constexpr std::array kAxes = {"X", "Y", "Z"};
  constexpr float kLeastWidth = 2.8f;  // smallest width of a field in a row, in heights of text
  const float gap = 3, room = ImGui::GetContentRegionAvail().x, third = (room - 2 * gap) / 3;
  const bool in_row = third >= kLeastWidth * ImGui::GetFontSize();
  const float width = in_row ? third : room;
  std::optional<AxisValue> changed;
  for (int axis = 0; axis < 3; ++axis) {
    if (axis > 0 && in_row) ImGui::SameLine(0, gap);
    std::vector<double> along;
    for (const dvec3& value : values) along.push_back(value[axis]);
    const std::string label = fmt::format("{} {}", name, kAxes[static_cast<std::size_t>(axis)]);
    if (const auto value = number_field(ui, label, along, unit, width)) changed = {axis, *value};
  }
  show_refusal(ui, name);
  return changed;
}

std::optional<std::string> text_field(Ui& ui, const std::string& name, const std::vector<std::string>& values,
                                      float width) {
  const bool mixed = differ(values);
  const std::string shown = mixed || values.empty() ? "" : values.front();
  return edited_text(ui, name, shown, mixed, width);
}

void refuse(Ui& ui, const std::string& words) {
  ui.fields.refused = {ui.fields.last, ui.fields.last.field + ": " + words, ui.fields.selection};
}

void show_refusal(Ui& ui, const std::string& name) {
  const std::optional<Refusal>& refused = ui.fields.refused;
  if (!refused) return;
  const std::string& field = refused->input.field;
  const bool axis = field.size() == name.size() + 2 && field.starts_with(name + " ");
  if (field != name && !axis) return;
  ImGui::PushStyleColor(ImGuiCol_Text, palette(ui.dark).error);
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(refused->words.c_str());
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
  ui.widgets.note_item("Refused");
}

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
