#include "app/studio/nouns/table/sensor_table.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>

#include "app/studio/nouns/table/sensor_rows.h"
#include "app/studio/nouns/table/taxel_cells.h"
#include "app/studio/nouns/table/taxel_values.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"

namespace taxel::ui {

namespace {

void draw_sensor_row(WindowUi& ui, Selection& selection, const std::vector<SensorShown>& sensors, const SensorRow& row,
                     const ValueColumns& values) {
  const Palette& colors = palette(ui.dark);
  const SensorShown& sensor = sensors[row.sensor];
  const Taxel& taxel = sensor.taxels()[row.taxel];
  const TaxelKey key{sensor.index, taxel.id};
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  if (ImGui::Selectable(fmt::format("{}##row {} {}", sensor.name, key.sensor, key.id).c_str(),
                        is_selected(selection, key), ImGuiSelectableFlags_SpanAllColumns))
    click_taxel_of(selection, key, ImGui::GetIO().KeyShift);
  ui.widgets.note_item("Taxel " + taxel_label(sensors, sensor, taxel.id));
  ImGui::TableNextColumn();
  draw_color_square(sensor.model->color(static_cast<int>(row.taxel)));
  ImGui::SameLine(0, 6);
  ImGui::Text("%d", taxel.id);
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(taxel.name.c_str());
  if (!taxel.name.empty()) tooltip(taxel.name);
  const auto& first = sensor.model->fields.first;
  if (ImGui::TableNextColumn())
    draw_text(grouped(static_cast<long long>(first[row.taxel + 1] - first[row.taxel])), true, colors.dim);
  draw_values(ui, sensor.step, row.taxel, sensor.unit, values);
}

/// Returns the title of the column of readings: their unit, or a word if the sensors have several.
const char* reading_title(const std::vector<SensorShown>& sensors) {
  const bool same = std::all_of(sensors.begin(), sensors.end(), [&](const SensorShown& sensor) {
    return same_unit(sensor.unit, sensors.front().unit);
  });
  return same ? sensors.front().unit.text : "Reading";
}

void setup_sensor_columns(const std::vector<SensorShown>& sensors, const ValueColumns& values, bool narrow) {
  struct Column {
    TableColumn column;
    const char* title;
    float width;
    bool has_values = true;
  };
  const std::array columns = {Column{TableColumn::sensor, "Sensor", 0.26f},
                              Column{TableColumn::id, "Id", 0.16f},
                              Column{TableColumn::name, "Name", 0.30f},
                              Column{TableColumn::samples, "Samples", 0.18f},
                              Column{TableColumn::reading, reading_title(sensors), 0.20f},
                              Column{TableColumn::shear, kShearTitle, 0.26f, values.shear},
                              Column{TableColumn::slip, kSlipTitle, 0.29f, values.slip}};
  ImGui::TableSetupScrollFreeze(0, 1);
  for (const Column& each : columns) {
    if (!each.has_values) continue;
    const bool left_out = narrow && each.column == TableColumn::samples;
    const auto flags =
        ImGuiTableColumnFlags_WidthStretch | (left_out ? ImGuiTableColumnFlags_Disabled : ImGuiTableColumnFlags_None);
    ImGui::TableSetupColumn(each.title, flags, each.width, static_cast<ImGuiID>(each.column));
  }
}

void draw_sensor_headers(WindowUi& ui, TableState& state) {
  ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
  ImGui::PushStyleColor(ImGuiCol_Text, palette(ui.dark).dim);
  for (int column = 0; column < ImGui::TableGetColumnCount(); ++column) {
    if (!ImGui::TableSetColumnIndex(column)) continue;
    ImGui::TableHeader(ImGui::TableGetColumnName(column));
    ui.widgets.note_item(fmt::format("Sort by {}", ImGui::TableGetColumnName(column)));
    tooltip(value_tip(ImGui::TableGetColumnName(column)));
  }
  ImGui::PopStyleColor();
  const ImGuiTableSortSpecs* specs = ImGui::TableGetSortSpecs();
  state.sorted.reset();
  if (specs == nullptr || specs->SpecsCount == 0) return;
  state.sorted = static_cast<TableColumn>(specs->Specs[0].ColumnUserID);
  state.descending = specs->Specs[0].SortDirection == ImGuiSortDirection_Descending;
}

}  // namespace

void draw_sensor_table(WindowUi& ui, Selection& selection, TableState& state, const std::vector<SensorShown>& sensors) {
  ValueColumns values;
  for (const SensorShown& sensor : sensors) values.include(*sensor.step);
  constexpr auto kFlags = ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg | ImGuiTableFlags_Sortable |
                          ImGuiTableFlags_SortTristate | ImGuiTableFlags_NoSavedSettings |
                          ImGuiTableFlags_SizingStretchProp;
  const bool narrow = ImGui::GetContentRegionAvail().x < kNarrowTable * ImGui::GetFontSize();
  if (!ImGui::BeginTable("sensors", 5 + values.count(), kFlags)) return;
  setup_sensor_columns(sensors, values, narrow);
  draw_sensor_headers(ui, state);
  state.sensor_rows = sensor_rows(state, sensors);
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(state.sensor_rows.size()));
  while (clipper.Step())
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
      draw_sensor_row(ui, selection, sensors, state.sensor_rows[static_cast<std::size_t>(i)], values);
  ImGui::EndTable();
}

}  // namespace taxel::ui
