#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>

#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/real/real_commands.h"
#include "app/studio/nouns/real/real_panel.h"
#include "app/studio/nouns/real/real_state.h"
#include "ui/theme.h"
#include "ui/widgets/choice_field.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/number_field.h"

namespace taxel::ui {

namespace {

constexpr std::array<std::string_view, 4> kSeparators{"comma", "semicolon", "tab", "blanks"};
constexpr std::array<const char*, 4> kSeparatorTexts{",", ";", "\t", " "};
constexpr std::array<std::string_view, 2> kDecimals{"point", "comma"};
constexpr std::uint64_t kMostHeaderLines = 1000;

std::size_t separator_of(const ColumnMapping& mapping) {
  const auto found = std::find(kSeparatorTexts.begin(), kSeparatorTexts.end(), mapping.separator);
  return found == kSeparatorTexts.end() ? 0 : static_cast<std::size_t>(found - kSeparatorTexts.begin());
}

void draw_format(WindowUi& ui, RealState& real) {
  ColumnMapping& m = real.mapping;
  const auto look = [&] { ui.post(ActOnReal{RealTask::look}); };
  begin_property("Separator", "Between the columns");
  if (const auto made = choice_of(ui, "Separator", kSeparators, separator_of(m))) {
    m.separator = kSeparatorTexts[*made];
    look();
  }
  begin_property("Decimal mark");
  if (const auto made = choice_of(ui, "Decimal mark", kDecimals, m.decimal == "," ? 1 : 0)) {
    m.decimal = *made == 1 ? "," : ".";
    look();
  }
  begin_property("Header lines", "Before the numbers; the last one names the columns");
  const auto lines = static_cast<std::uint64_t>(std::max(0, m.header_lines));
  if (const auto typed = whole_field(ui, "Header lines", lines, kMostHeaderLines)) {
    m.header_lines = static_cast<int>(*typed);
    look();
  }
}

void draw_values(WindowUi& ui, RealState& real) {
  ColumnMapping& m = real.mapping;
  if (m.time.empty()) {
    begin_property("Rows per second", "Where no column is the time");
    if (const auto typed = number_field(ui, "Rows per second", {m.rate}, {"", 0, -1})) m.rate = *typed;
  } else {
    begin_property("Unit of time");
    if (const auto made = choice_of(ui, "Unit of time", kTimeUnitWords, static_cast<std::size_t>(m.time_unit)))
      m.time_unit = static_cast<TimeUnit>(*made);
  }
  begin_property("Unit", "Of the values, as it is to be shown");
  if (const auto typed = text_field(ui, "Unit of values", {m.unit})) m.unit = *typed;
  begin_property("Gain", "value = gain * field + offset");
  if (const auto typed = number_field(ui, "Gain of values", {m.gain}, {"", 0, -1})) m.gain = *typed;
  begin_property("Offset", "value = gain * field + offset");
  if (const auto typed = number_field(ui, "Offset of values", {m.offset}, {"", 0, -1})) m.offset = *typed;
}

/// Returns the name of a column in a mapping: its number if another column has the same name.
std::string name_in_mapping(const TableLook& look, std::size_t column) {
  const bool single = std::count(look.columns.begin(), look.columns.end(), look.columns[column]) == 1;
  return single ? look.columns[column] : fmt::format("#{}", column + 1);
}

bool is_column(const std::string& named, const TableLook& look, std::size_t column) {
  return named == name_in_mapping(look, column) || named == fmt::format("#{}", column + 1);
}

/// Returns the meaning of a column: "-", "time", or the taxel.
std::string meaning_of(const ColumnMapping& m, const TableLook& look, std::size_t column) {
  if (!m.time.empty() && is_column(m.time, look, column)) return "time";
  for (const TaxelColumn& taxel : m.taxels)
    if (is_column(taxel.column, look, column)) return fmt::format("taxel {}", taxel.taxel);
  return "-";
}

/// Assigns the column to `taxel`, or to nothing if `taxel` is empty.
void give(ColumnMapping& m, const TableLook& look, std::size_t column, std::optional<int> taxel) {
  if (!m.time.empty() && is_column(m.time, look, column)) m.time.clear();
  std::erase_if(m.taxels, [&](const TaxelColumn& one) {
    return is_column(one.column, look, column) || (taxel && one.taxel == *taxel);
  });
  if (taxel) m.taxels.push_back({*taxel, name_in_mapping(look, column), {}, {}});
}

void draw_meaning(WindowUi& ui, RealState& real, std::size_t column, const std::vector<Taxel>& taxels) {
  ColumnMapping& m = real.mapping;
  const TableLook& look = real.look;
  const std::string label = fmt::format("##meaning{}", column), noted = "Meaning of " + name_in_mapping(look, column);
  ImGui::SetNextItemWidth(-1);
  const bool open = ImGui::BeginCombo(label.c_str(), meaning_of(m, look, column).c_str());
  if (!open) return ui.widgets.note_item(noted);
  if (selectable(ui, "-", false)) give(m, look, column, std::nullopt);
  if (selectable(ui, "time", false)) {
    give(m, look, column, std::nullopt);
    m.time = name_in_mapping(look, column);
  }
  for (const Taxel& taxel : taxels) {
    const std::string name = fmt::format("taxel {}{}{}", taxel.id, taxel.name.empty() ? "" : " ", taxel.name);
    if (selectable(ui, name.c_str(), false)) give(m, look, column, taxel.id);
  }
  ImGui::EndCombo();
}

void draw_columns(WindowUi& ui, RealState& real, const std::vector<Taxel>& taxels, float height) {
  const TableLook& look = real.look;
  constexpr auto kFlags = ImGuiTableFlags_RowBg | ImGuiTableFlags_ScrollY | ImGuiTableFlags_SizingStretchProp;
  if (!ImGui::BeginTable("columns", 3, kFlags, ImVec2(0, height))) return;
  ImGui::TableSetupScrollFreeze(0, 1);
  ImGui::TableSetupColumn("Column", ImGuiTableColumnFlags_WidthStretch, 0.25f);
  ImGui::TableSetupColumn("Means", ImGuiTableColumnFlags_WidthStretch, 0.3f);
  ImGui::TableSetupColumn("First values", ImGuiTableColumnFlags_WidthStretch, 0.45f);
  ImGui::TableHeadersRow();
  for (std::size_t c = 0; c < look.columns.size(); ++c) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(look.columns[c].c_str());
    ImGui::TableNextColumn();
    draw_meaning(ui, real, c, taxels);
    ImGui::TableNextColumn();
    std::string first;
    for (const std::vector<std::string>& row : look.rows)
      if (c < row.size()) first += (first.empty() ? "" : "   ") + row[c];
    ImGui::TextDisabled("%s", first.c_str());
  }
  ImGui::EndTable();
}

}  // namespace

void draw_real_dialog(WindowUi& ui, const Viewer& viewer, const Shown& shown, RealState& real) {
  constexpr const char* kTitle = "Map columns";
  if (real.asks && !ImGui::IsPopupOpen(kTitle)) ImGui::OpenPopup(kTitle);
  const float line = ImGui::GetFontSize();
  place_dialog(44, 40);
  if (!ImGui::BeginPopupModal(kTitle, nullptr, ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoDocking)) return;
  ImGui::TextDisabled("%s", real.file.c_str());
  if (begin_properties("format")) {
    draw_format(ui, real);
    draw_values(ui, real);
    end_properties();
  }
  const SensorModelPtr model = shown.model(viewer);
  const float below = (real.problem.empty() ? 1.0f : 3.0f) * ImGui::GetFrameHeightWithSpacing();
  draw_columns(ui, real, model ? model->layout.taxels : std::vector<Taxel>{},
               std::max(6 * line, ImGui::GetContentRegionAvail().y - below));
  if (!real.problem.empty()) {
    ImGui::PushTextWrapPos(0);
    ImGui::TextColored(palette(ui.dark).error, "%s", real.problem.c_str());
    ImGui::PopTextWrapPos();
  }
  const ImVec2 size(8 * line, 0);
  if (button(ui, "Save mapping", ImVec2(9 * line, 0))) ui.post(ActOnReal{RealTask::save_mapping});
  tooltip("Save it next to the table as NAME.recmap.json, for the next time");
  ImGui::SameLine(ImGui::GetWindowWidth() - ImGui::GetStyle().WindowPadding.x - 2 * size.x -
                  ImGui::GetStyle().ItemSpacing.x);
  if (button(ui, "Cancel", size) || ImGui::IsKeyPressed(ImGuiKey_Escape, false)) real.asks = false;
  ImGui::SameLine();
  if (button(ui, "Overlay", size)) ui.post(ActOnReal{RealTask::overlay});
  if (!real.asks) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
}

}  // namespace taxel::ui
