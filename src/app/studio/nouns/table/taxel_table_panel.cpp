// The table of all taxels of the displayed layout, with their readings.
#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>
#include <misc/cpp/imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/sensors_shown.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/history/edit_commands.h"
#include "app/studio/nouns/inspector/inspector_state.h"
#include "app/studio/nouns/table/table_rows.h"
#include "app/studio/nouns/table/table_state.h"
#include "core/base/text/message.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/fields.h"
#include "ui/widgets/format.h"
#include "ui/widgets/text_fit.h"

namespace taxel::ui {

namespace {

bool has_names(const Layout& layout) {
  return std::ranges::any_of(layout.taxels, [](const Taxel& taxel) { return !taxel.name.empty(); });
}

constexpr const char* kNoTaxels =
    "No taxels yet. Generate (Ctrl+G) adds a pattern; Place, or Ctrl+click on the surface, adds one.";

/// Returns the largest reading of a sensor in the displayed step.
double largest_now(const SensorShown& sensor) {
  const std::vector<double>& readings = sensor.step->readings;
  return readings.empty() ? 0.0 : *std::max_element(readings.begin(), readings.end());
}

/// Draws a triangle that points down, or to the right if the rows below it are folded.
void draw_fold_mark(ImDrawList& list, ImVec2 middle, float r, bool folded, ImU32 color) {
  if (folded)
    list.AddTriangleFilled({middle.x - 0.7f * r, middle.y - r}, {middle.x + 0.9f * r, middle.y},
                           {middle.x - 0.7f * r, middle.y + r}, color);
  else
    list.AddTriangleFilled({middle.x - r, middle.y - 0.7f * r}, {middle.x + r, middle.y - 0.7f * r},
                           {middle.x, middle.y + 0.9f * r}, color);
}

/// Draws the heading of a sensor: its name, the number of its rows and its largest reading. A click folds the rows.
void draw_sensor_heading(WindowUi& ui, const Selection& selection, TableState& state, const SensorShown& sensor,
                         std::size_t rows) {
  constexpr int kReading = 4;  // index of the column
  const Palette& colors = palette(ui.dark);
  const float line = ImGui::GetTextLineHeight();
  ImGui::TableNextRow();
  ImGui::TableSetBgColor(ImGuiTableBgTarget_RowBg0, ImGui::GetColorU32(ImGuiCol_TableHeaderBg));
  ImGui::TableSetColumnIndex(kReading);
  const float right = ImGui::GetCursorScreenPos().x;
  draw_text(number_in_unit(largest_now(sensor), sensor.unit), true, colors.dim);
  ImGui::TableSetColumnIndex(0);
  const auto folded = std::lower_bound(state.folded.begin(), state.folded.end(), sensor.index);
  const bool is_folded = state.filter.empty() && folded != state.folded.end() && *folded == sensor.index;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const bool clicked =
      ImGui::Selectable(fmt::format("##heading {}", sensor.index).c_str(), false, ImGuiSelectableFlags_SpanAllColumns);
  ui.widgets.note_item("Sensor " + sensor.name);
  tooltip(fmt::format("{}, {} taxel{}; the number is the largest reading. Click to fold or unfold.", sensor.name, rows,
                      rows == 1 ? "" : "s"));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const std::string count = fmt::format("  {}", rows);
  const float x = at.x + 1.1f * line, count_width = ImGui::CalcTextSize(count.c_str()).x;
  const std::string name = shortened(sensor.name, right - 0.4f * line - count_width - x, 1);
  // The name may be wider than its column, but a scrolled row ends with the table.
  const float top = std::max(at.y, list.GetClipRectMin().y), bottom = std::min(at.y + line, list.GetClipRectMax().y);
  list.PushClipRect({at.x, top}, {right, std::max(top, bottom)}, false);
  draw_fold_mark(list, {at.x + 0.45f * line, at.y + 0.5f * line}, 0.28f * line, is_folded, to_u32(colors.dim));
  list.AddText({x, at.y}, to_u32(sensor.index == selection.sensor ? colors.accent : colors.text), name.c_str());
  list.AddText({x + ImGui::CalcTextSize(name.c_str()).x, at.y}, to_u32(colors.dim), count.c_str());
  list.PopClipRect();
  if (!clicked || !state.filter.empty()) return;
  if (is_folded)
    state.folded.erase(folded);
  else
    state.folded.insert(folded, sensor.index);
}

void draw_sensor_row(WindowUi& ui, Selection& selection, TableState& state, const std::vector<SensorShown>& sensors,
                     const SensorRow& row, const ValueColumns& values) {
  const Palette& colors = palette(ui.dark);
  const SensorShown& sensor = sensors[row.sensor];
  const Taxel& taxel = sensor.taxels()[row.taxel];
  const TaxelKey key{sensor.index, taxel.id};
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const std::string name = shortened(sensor.name, ImGui::GetContentRegionAvail().x, 1);
  if (ImGui::Selectable(fmt::format("##row {} {}", key.sensor, key.id).c_str(), is_selected(selection, key),
                        ImGuiSelectableFlags_SpanAllColumns)) {
    click_taxel_of(selection, key, ImGui::GetIO().KeyShift);
    state.followed = key;
  }
  ui.widgets.note_item("Taxel " + taxel_label(sensors, sensor, taxel.id));
  ImGui::GetWindowDrawList()->AddText(at, to_u32(state.sorted ? colors.text : colors.dim), name.c_str());
  ImGui::TableNextColumn();
  draw_color_square(sensor.model->color(static_cast<int>(row.taxel)));
  ImGui::SameLine(0, 6);
  ImGui::Text("%d", taxel.id);
  if (ImGui::TableNextColumn()) {
    ImGui::TextUnformatted(taxel.name.c_str());
    if (!taxel.name.empty()) tooltip(taxel.name);
  }
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
  const bool are_named =
      std::ranges::any_of(sensors, [](const SensorShown& sensor) { return has_names(sensor.model->layout); });
  ImGui::TableSetupScrollFreeze(0, 1);
  for (const Column& each : columns) {
    if (!each.has_values) continue;
    const bool left_out =
        (narrow && each.column == TableColumn::samples) || (!are_named && each.column == TableColumn::name);
    const auto flags =
        ImGuiTableColumnFlags_WidthStretch | (left_out ? ImGuiTableColumnFlags_Disabled : ImGuiTableColumnFlags_None);
    ImGui::TableSetupColumn(each.title, flags, each.width, static_cast<ImGuiID>(each.column));
  }
}

/// Draws the heads, and notes the column by which the user sorts. tip_of(column) returns the tooltip of a head.
template <class TipOf>
void draw_headers(WindowUi& ui, TableState& state, const TipOf& tip_of) {
  ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
  ImGui::PushStyleColor(ImGuiCol_Text, palette(ui.dark).dim);
  for (int column = 0; column < ImGui::TableGetColumnCount(); ++column) {
    if (!ImGui::TableSetColumnIndex(column)) continue;
    ImGui::TableHeader(ImGui::TableGetColumnName(column));
    ui.widgets.note_item(fmt::format("Sort by {}", ImGui::TableGetColumnName(column)));
    tooltip(tip_of(column));
  }
  ImGui::PopStyleColor();
  const ImGuiTableSortSpecs* specs = ImGui::TableGetSortSpecs();
  state.sorted.reset();
  if (specs == nullptr || specs->SpecsCount == 0) return;
  state.sorted = static_cast<TableColumn>(specs->Specs[0].ColumnUserID);
  state.descending = specs->Specs[0].SortDirection == ImGuiSortDirection_Descending;
}

/// Returns the line of the selected taxel if the table has not scrolled to it yet.
std::optional<std::size_t> line_to_follow(TableState& state, const Selection& selection,
                                          const std::vector<SensorLine>& lines,
                                          const std::vector<SensorShown>& sensors) {
  if (selection.taxels.empty()) {
    state.followed.reset();
    return std::nullopt;
  }
  const TaxelKey key{selection.sensor, selection.taxels.back()};
  if (state.followed == key) return std::nullopt;
  state.followed = key;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const SensorShown& sensor = sensors[lines[i].row.sensor];
    if (!lines[i].is_heading && sensor.index == key.sensor && sensor.taxels()[lines[i].row.taxel].id == key.id)
      return i;
  }
  return std::nullopt;
}

/// Draws the table into the rest of the panel: sensor, id, name, samples and reading of each taxel, below the headings
/// of the sensors. Scrolls to a taxel that was selected elsewhere.
void draw_sensor_table(WindowUi& ui, Selection& selection, TableState& state, const std::vector<SensorShown>& sensors) {
  ValueColumns values;
  for (const SensorShown& sensor : sensors) values.include(*sensor.step);
  constexpr auto kFlags = ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg | ImGuiTableFlags_Sortable |
                          ImGuiTableFlags_SortTristate | ImGuiTableFlags_NoSavedSettings |
                          ImGuiTableFlags_SizingStretchProp;
  const bool narrow = ImGui::GetContentRegionAvail().x < kNarrowTable * ImGui::GetFontSize();
  if (!ImGui::BeginTable("sensors", 5 + values.count(), kFlags)) return;
  setup_sensor_columns(sensors, values, narrow);
  draw_headers(ui, state, [](int column) { return value_tip(ImGui::TableGetColumnName(column)); });
  state.sensor_rows = sensor_rows(state, sensors);
  const std::vector<SensorLine> lines = sensor_lines(state, state.sensor_rows, sensors);
  const std::optional<std::size_t> follow = line_to_follow(state, selection, lines, sensors);
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(lines.size()));
  if (follow) clipper.IncludeItemByIndex(static_cast<int>(*follow));
  while (clipper.Step()) {
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
      const SensorLine& line = lines[static_cast<std::size_t>(i)];
      if (line.is_heading)
        draw_sensor_heading(ui, selection, state, sensors[line.row.sensor], line.count);
      else
        draw_sensor_row(ui, selection, state, sensors, line.row, values);
      if (follow == static_cast<std::size_t>(i)) ImGui::SetScrollHereY();
    }
  }
  ImGui::EndTable();
}

/// Draws the button that folds all sensors, or unfolds them if all are folded.
void draw_fold_button(WindowUi& ui, TableState& state, const std::vector<SensorShown>& sensors) {
  const bool all_folded = state.folded.size() >= sensors.size();
  if (small_choice(ui, all_folded ? "Unfold" : "Fold", false)) {
    state.folded.clear();
    if (!all_folded)
      for (const SensorShown& sensor : sensors) state.folded.push_back(sensor.index);
  }
  tooltip(all_folded ? "Show the taxels of all sensors" : "Show each sensor as one line with its largest reading");
}

/// Draws a triangle at the right end of the cell if the taxel has problems. A tooltip lists the problems.
void draw_mark(WindowUi& ui, const LayoutProblems& problems_state, int id) {
  const std::vector<std::size_t> problems = problems_state.of(id);
  if (problems.empty()) return;
  const float size = 0.8f * ImGui::GetFontSize();
  const ImVec2 row = ImGui::GetItemRectMin();
  const ImVec2 cell = ImGui::GetCursorScreenPos();
  const float right = cell.x + ImGui::GetContentRegionAvail().x,
              top = row.y + 0.5f * (ImGui::GetTextLineHeight() - size);
  const Rect mark{right - size, top, right, top + size};
  const ImU32 color = to_u32(severity_color(palette(ui.dark), problems_state.worst(id)));
  ImGui::GetWindowDrawList()->AddTriangleFilled({mark.center_x(), mark.y0}, {mark.x1, mark.y1}, {mark.x0, mark.y1},
                                                color);
  ui.widgets.note(kTaxelTable.title, fmt::format("Problems of taxel {}", id), mark);
  if (!ImGui::IsMouseHoveringRect({mark.x0 - 2, mark.y0 - 2}, {mark.x1 + 2, mark.y1 + 2})) return;
  std::string words;
  for (const std::size_t i : problems) {
    const Problem& problem = problems_state.list[i];
    words += fmt::format("{}{}: {}", words.empty() ? "" : "\n", to_string(problem.severity),
                         taxel::shown_part(problem.message));
  }
  if (ImGui::BeginTooltip()) {
    ImGui::PushTextWrapPos(24 * ImGui::GetFontSize());
    ImGui::TextUnformatted(words.c_str());
    ImGui::PopTextWrapPos();
  }
  ImGui::EndTooltip();
}

/// Handles the drag of a row, which moves all selected rows. Rows can be moved only in the layout's order.
void drag_row(WindowUi& ui, Selection& selection, const TableState& table_state, const Table& table, int id) {
  if (!table.edited || table_state.sorted || !table_state.filter.empty()) return;
  constexpr const char* kKind = "taxel row";
  if (ImGui::BeginDragDropSource(ImGuiDragDropFlags_SourceNoHoldToOpenOthers)) {
    if (!selection.contains(id)) selection.set(id);
    ImGui::SetDragDropPayload(kKind, &id, sizeof(id));
    ImGui::Text("Move %d taxel%s", static_cast<int>(selection.taxels.size()), selection.taxels.size() == 1 ? "" : "s");
    ImGui::EndDragDropSource();
  }
  if (!ImGui::BeginDragDropTarget()) return;
  if (ImGui::AcceptDragDropPayload(kKind) != nullptr)
    ui.post(EditProject{ReorderTaxels{moved_to(table.layout, selection.taxels, id)}, {}});
  ImGui::EndDragDropTarget();
}

void draw_id_cell(WindowUi& ui, Selection& selection, TableState& table_state, const LayoutProblems& problems,
                  const Table& table, int index) {
  const int id = table.layout.taxels[static_cast<std::size_t>(index)].id;
  const int model_index = table.in_model[static_cast<std::size_t>(index)];
  draw_color_square(model_index < 0 ? -1 : table.model.color(model_index));
  ImGui::SameLine(0, 6);
  int flags = ImGuiSelectableFlags_SpanAllColumns | ImGuiSelectableFlags_AllowDoubleClick;
  if (table_state.cell && table_state.cell->id == id) flags |= ImGuiSelectableFlags_AllowOverlap;  // for the text field
  if (ImGui::Selectable(fmt::format("{}##taxel{}", id, id).c_str(), selection.contains(id), flags)) {
    click_taxel(selection, id, ImGui::GetIO().KeyShift);
    const int column = ImGui::TableGetHoveredColumn();
    if (table.edited && column >= 0 && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left))
      edit_cell(table_state, id, layout_columns()[static_cast<std::size_t>(column)].column);
  }
  ui.widgets.note_item(fmt::format("Taxel {}", id));
  drag_row(ui, selection, table_state, table, id);
  ImGui::SameLine(0, 0);
  if (table.edited) draw_mark(ui, problems, id);
}

bool is_hidden(const Table& table, int id) {
  const Project* project = table.project;
  return table.edited && std::binary_search(project->hidden.begin(), project->hidden.end(), id);
}

void draw_row(WindowUi& ui, Selection& selection, TableState& table_state, const LayoutProblems& problems,
              const Table& table, int index) {
  const Taxel& taxel = table.layout.taxels[static_cast<std::size_t>(index)];
  const int samples = table.samples[static_cast<std::size_t>(index)];
  const ImVec4& dim = palette(ui.dark).dim;
  ImGui::TableNextRow();
  if (is_hidden(table, taxel.id)) ImGui::PushStyleVar(ImGuiStyleVar_Alpha, 0.5f * ImGui::GetStyle().Alpha);
  ImGui::TableNextColumn();
  draw_id_cell(ui, selection, table_state, problems, table, index);
  if (table.edited) {
    for (const CellColumn& column : layout_columns().subspan(1)) {
      ImGui::TableNextColumn();
      column.column == TableColumn::samples ? draw_text(grouped(samples), true, dim)
                                            : draw_cell(ui, table_state, taxel, column.column);
      if (column.column == TableColumn::name && is_hidden(table, taxel.id)) tooltip("Hidden: Alt+H shows all");
    }
  } else {
    if (ImGui::TableNextColumn()) {
      ImGui::TextUnformatted(taxel.name.c_str());
      if (!taxel.name.empty()) tooltip(taxel.name);
    }
    if (ImGui::TableNextColumn()) draw_text(grouped(samples), true, dim);
    const auto i = static_cast<std::size_t>(std::max(0, table.in_model[static_cast<std::size_t>(index)]));
    draw_values(ui, table.sensor, i, shown_unit(table.model.layout.readout.aggregate), table.values);
  }
  if (is_hidden(table, taxel.id)) ImGui::PopStyleVar();
}

/// Sets up the editable columns, which scroll sideways. The names have the room that is left by the columns that fit
/// into the panel as a whole, so that the edge of the panel cuts no column before the user scrolls.
void setup_layout_columns(TableState& state, const Layout& layout) {
  constexpr std::size_t kName = 1;       // index of the column
  constexpr float kWithoutNames = 3.2f;  // width of the column if no taxel has a name, in heights of text
  const float em = ImGui::GetFontSize();
  ImGuiTable& made = *ImGui::GetCurrentTable();
  const float gap = made.CellSpacingX1 + made.CellSpacingX2 + 2 * made.CellPaddingX;
  const std::span<const CellColumn> columns = layout_columns();
  std::vector<float> widths;
  for (const CellColumn& column : columns) widths.push_back(column.width * em);
  if (!has_names(layout)) widths[kName] = kWithoutNames * em;
  float room = made.InnerWindow->InnerRect.GetWidth() - 2 * made.OuterPaddingX;
  for (std::size_t i = 0; i < widths.size() && widths[i] + gap <= room; ++i) room -= widths[i] + gap;
  const float whole = std::accumulate(widths.begin(), widths.end(), gap * static_cast<float>(widths.size()));
  if (whole > made.InnerWindow->InnerRect.GetWidth()) widths[kName] += std::max(0.0f, room);
  for (std::size_t i = 0; i < columns.size(); ++i)
    ImGui::TableSetupColumn(columns[i].title, ImGuiTableColumnFlags_WidthFixed, widths[i],
                            static_cast<ImGuiID>(columns[i].column));
  // A width that the user has dragged stays until the panel changes.
  const float before = std::exchange(state.name_width, widths[kName]);
  if (std::abs(before - widths[kName]) >= 1) made.Columns[static_cast<int>(kName)].WidthRequest = widths[kName];
}

void setup_columns(const Viewer& viewer, TableState& state, const Table& table, bool narrow) {
  ImGui::TableSetupScrollFreeze(table.edited ? 1 : 0, 1);
  const auto add = [](const CellColumn& column, ImGuiTableColumnFlags flags, float width) {
    ImGui::TableSetupColumn(column.title, flags, width, static_cast<ImGuiID>(column.column));
  };
  if (table.edited) return setup_layout_columns(state, table.layout);
  constexpr auto kStretch = ImGuiTableColumnFlags_WidthStretch;
  const char* unit = viewer.mode == Mode::layout ? "" : shown_unit(table.layout.readout.aggregate).text;
  add({TableColumn::id, "Id", "", 0}, kStretch, 0.19f);
  add({TableColumn::name, "Name", "", 0}, kStretch | (has_names(table.layout) ? 0 : ImGuiTableColumnFlags_Disabled),
      0.38f);
  const bool has_room = !narrow || table.values.count() == 0;
  add({TableColumn::samples, "Samples", "", 0}, kStretch | (has_room ? 0 : ImGuiTableColumnFlags_Disabled), 0.23f);
  add({TableColumn::reading, unit, "", 0}, kStretch, 0.20f);
  if (table.values.shear) add({TableColumn::shear, kShearTitle, "", 0}, kStretch, 0.26f);
  if (table.values.slip) add({TableColumn::slip, kSlipTitle, "", 0}, kStretch, 0.29f);
}

void draw_table(WindowUi& ui, Viewer& viewer, TableState& table_state, const LayoutProblems& problems,
                const Table& table) {
  auto flags = ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg | ImGuiTableFlags_Sortable |
               ImGuiTableFlags_SortTristate | ImGuiTableFlags_NoSavedSettings;
  flags |= table.edited ? ImGuiTableFlags_ScrollX | ImGuiTableFlags_Resizable | ImGuiTableFlags_SizingFixedFit
                        : ImGuiTableFlags_SizingStretchProp;
  const int columns = table.edited ? static_cast<int>(layout_columns().size()) : 4 + table.values.count();
  const bool narrow = ImGui::GetContentRegionAvail().x < kNarrowTable * ImGui::GetFontSize();
  if (!ImGui::BeginTable(table.edited ? "taxels" : "readings", columns, flags)) return;
  setup_columns(viewer, table_state, table, narrow);
  draw_headers(ui, table_state, [&](int column) {
    return table.edited ? layout_columns()[static_cast<std::size_t>(column)].tip
                        : value_tip(ImGui::TableGetColumnName(column));
  });
  TableNumbers numbers{nullptr, &table.samples};
  if (table.sensor != nullptr) {
    numbers.readings = &table.sensor->readings;
    numbers.shear = &table.sensor->shear;
    numbers.slip = &table.sensor->slip;
  }
  table_state.rows = table_rows(table_state, table.layout, problems, numbers);
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(table_state.rows.size()));
  for (std::size_t row = 0; table_state.cell && row < table_state.rows.size(); ++row)
    if (table.layout.taxels[static_cast<std::size_t>(table_state.rows[row])].id == table_state.cell->id)
      clipper.IncludeItemByIndex(static_cast<int>(row));
  while (clipper.Step())
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
      draw_row(ui, viewer.selection, table_state, problems, table, table_state.rows[static_cast<std::size_t>(i)]);
  ImGui::EndTable();
}

void draw_taxel_table(WindowUi& ui, Viewer& viewer, const Shown& shown, TableState& table_state,
                      const LayoutProblems& problems, PanelsShown& panels) {
  table_state.sensor_rows.clear();
  if (begin_panel(ui, kTaxelTable.title, &panels[kTaxelTable])) {
    const std::vector<SensorShown> sensors = sensors_shown(shown.run);
    const SensorModelPtr model = shown.model(viewer);
    const Layout* layout = shown.layout(viewer);
    if (shows_run(viewer.mode) && sensors.size() > 1) {
      ImGui::PushFont(nullptr, kTextHeight * kSmallText);
      const ImGuiStyle& style = ImGui::GetStyle();
      ImGui::SetNextItemWidth(-(ImGui::CalcTextSize("Unfold").x + 2 * style.FramePadding.x + style.ItemSpacing.x));
      ImGui::InputTextWithHint("##filter", "Filter: sensor, id, name", &table_state.filter);
      ui.widgets.note_item("Filter taxels", true);
      ImGui::SameLine();
      draw_fold_button(ui, table_state, sensors);
      ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, ImVec2(3, 2));
      table_state.rows.clear();
      table_state.cell.reset();
      draw_sensor_table(ui, viewer.selection, table_state, sensors);
      ImGui::PopStyleVar();
      ImGui::PopFont();
    } else if (model && layout != nullptr && !layout->taxels.empty()) {
      const Table table = table_of(viewer, shown, *layout, *model);
      ImGui::PushFont(nullptr, kTextHeight * kSmallText);
      ImGui::SetNextItemWidth(-1);
      ImGui::InputTextWithHint("##filter", "Filter: id, name, problem", &table_state.filter);
      ui.widgets.note_item("Filter taxels", true);
      if (const auto& refused = ui.fields.refused; refused && refused->input.field.starts_with("Taxel "))
        show_refusal(ui, refused->input.field);
      ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, ImVec2(3, 2));
      draw_table(ui, viewer, table_state, problems, table);
      ImGui::PopStyleVar();
      ImGui::PopFont();
      if (!table.edited) table_state.cell.reset();
      leave_cell(table_state, *layout);
    } else {
      ImGui::PushTextWrapPos(0);
      ImGui::TextDisabled("%s", model                     ? kNoTaxels
                                : shown.document.is_scene ? "No geom of the scene has taxels."
                                                          : shown.empty_text());
      ImGui::PopTextWrapPos();
    }
  }
  ImGui::End();
}

std::vector<PanelPart> table_parts() {
  return {{"Filter taxels", "", "List the taxels whose ids, names or problems match", kEverywhere, nullptr}};
}

}  // namespace

constinit const Feature kTaxelTable{
    .title = "Taxels",
    .dock = Dock::taxels,
    .in_front = true,
    .opens = Opens::by_user,
    .open = true,
    .key = "panel_taxels",
    .label = "Taxels",
    .draw =
        [](App& app) {
          draw_taxel_table(*app.ui, *app.viewer, *app.shown, app.get<TableState>(), app.get<LayoutProblems>(),
                           app.get<PanelsShown>());
        },
    .parts = table_parts,
    .guide = "Author a layout",
    .analyse = {.tab = 1, .in_front = true, .question = "What does each taxel read?"},
    .dump = dump_table,
};

}  // namespace taxel::ui
