#include "ui/panels/taxel_table_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "ui/panels/dock_layout.h"
#include "ui/theme.h"
#include "ui/tools/actions.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/format.h"
#include "ui/widgets/pressure_legend.h"

namespace taxel::ui {

namespace {

void text_right(const std::string& text, bool dim) {
  const float slack = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(text.c_str()).x;
  if (slack > 0) ImGui::SetCursorPosX(ImGui::GetCursorPosX() + slack);
  if (dim) {
    ImGui::TextDisabled("%s", text.c_str());
  } else {
    ImGui::TextUnformatted(text.c_str());
  }
}

void draw_swatch(int color) {
  const float size = ImGui::GetFontSize() * 0.72f;
  const ImVec2 p = ImGui::GetCursorScreenPos();
  const float y = p.y + 0.5f * (ImGui::GetTextLineHeight() - size);
  ImGui::GetWindowDrawList()->AddRectFilled({p.x, y}, {p.x + size, y + size}, taxel_color_u32(color), 3);
  ImGui::Dummy(ImVec2(size, ImGui::GetTextLineHeight()));
}

/// The row of a taxel; `shown`: its index in the model that is shown, which may be older than the layout, or -1.
void draw_row(UiState& ui, const UiInput& input, const Layout& layout, const SensorModel& model,
              const SensorFrameState* sensor, int index) {
  const Taxel& taxel = layout.taxels[static_cast<std::size_t>(index)];
  const bool same = index < model.taxel_count() && model.layout.taxels[static_cast<std::size_t>(index)].id == taxel.id;
  const int shown = same ? index : index_of(model.layout, taxel.id);
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  draw_swatch(model.color(index));
  ImGui::SameLine(0, 6);
  const std::string label = fmt::format("{}##taxel{}", taxel.id, index);
  if (ImGui::Selectable(label.c_str(), ui.selection.contains(taxel.id), ImGuiSelectableFlags_SpanAllColumns)) {
    click_taxel(ui, taxel.id, ImGui::GetIO().KeyShift);
  }
  ui.widgets.note_item(fmt::format("Taxel {}", taxel.id));
  ImGui::TableNextColumn();
  const Project* project = input.editing.project.get();
  const bool hidden = ui.mode == Mode::layout && project != nullptr &&
                      std::binary_search(project->hidden.begin(), project->hidden.end(), taxel.id);
  const std::string name = hidden ? taxel.name + " (hidden)" : taxel.name;
  hidden ? ImGui::TextDisabled("%s", name.c_str()) : ImGui::TextUnformatted(name.c_str());
  if (!taxel.name.empty()) tooltip(taxel.name);
  ImGui::TableNextColumn();
  const auto i = static_cast<std::size_t>(std::max(0, shown));
  if (shown >= 0) text_right(std::to_string(model.fields.first[i + 1] - model.fields.first[i]), true);
  ImGui::TableNextColumn();
  if (ui.mode == Mode::layout) {
    text_right(fmt::format("{:.2f}", 1e3 * taxel.radius), false);
  } else if (sensor != nullptr && i < sensor->readings.size()) {
    const double reading = sensor->readings[i];
    text_right(fmt::format("{:.2f}", shown_unit(model.layout.readout.aggregate).scale * reading), reading <= 0);
  }
}

void draw_table(UiState& ui, const UiInput& input, const Layout& layout, const SensorModel& model) {
  constexpr auto kFlags = ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingStretchProp;
  if (!ImGui::BeginTable("taxels", 4, kFlags)) return;
  ImGui::TableSetupScrollFreeze(0, 1);
  ImGui::TableSetupColumn("Id", ImGuiTableColumnFlags_WidthStretch, 0.20f);
  ImGui::TableSetupColumn("Name", ImGuiTableColumnFlags_WidthStretch, 0.42f);
  ImGui::TableSetupColumn("Samples", ImGuiTableColumnFlags_WidthStretch, 0.21f);
  const char* last = ui.mode == Mode::layout ? "r mm" : shown_unit(layout.readout.aggregate).text;
  ImGui::TableSetupColumn(last, ImGuiTableColumnFlags_WidthStretch, 0.17f);
  ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
  for (int column = 0; column < 4; ++column) {
    ImGui::TableSetColumnIndex(column);
    const char* name = ImGui::TableGetColumnName(column);
    if (column >= 2) {
      text_right(name, true);
    } else {
      ImGui::TextDisabled("%s", name);
    }
  }
  const SensorFrameState* sensor = ui.mode == Mode::simulate ? input.sensor(ui) : nullptr;
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(layout.taxels.size()));
  while (clipper.Step()) {
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) draw_row(ui, input, layout, model, sensor, i);
  }
  ImGui::EndTable();
}

}  // namespace

void draw_taxel_table(UiState& ui, const UiInput& input) {
  if (begin_panel(ui, kTaxelsTitle, &ui.saved.panels.taxels)) {
    const SensorModelPtr model = input.shown_model(ui);
    const Layout* layout = input.shown_layout(ui);
    if (model && layout != nullptr && !layout->taxels.empty()) {
      ImGui::PushFont(nullptr, kTextHeight * kSmallText);
      ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, ImVec2(3, 2));
      draw_table(ui, input, *layout, *model);
      ImGui::PopStyleVar();
      ImGui::PopFont();
    } else {
      ImGui::TextDisabled(model ? "This layout has no taxels." : "Nothing is open.");
    }
  }
  ImGui::End();
}

}  // namespace taxel::ui
