#include "app/studio/nouns/table/taxel_cells.h"

#include <fmt/format.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <utility>

#include "app/studio/frame/selection.h"
#include "app/studio/nouns/history/edit_commands.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/number_field.h"
#include "ui/widgets/pressure_legend.h"

namespace taxel::ui {

namespace {

constexpr std::array kColumns = {
    CellColumn{TableColumn::id, "Id", "Names the taxel in files and readings", 3.3f},
    CellColumn{TableColumn::name, "Name", "", 6.2f},
    CellColumn{TableColumn::radius, "r", "Radius of the receptive field [mm]", 2.8f},
    CellColumn{TableColumn::samples, "Samples", "In the receptive field", 4.0f},
    CellColumn{TableColumn::x, "x", "Centre, frame of the mesh file [mm]", 3.8f},
    CellColumn{TableColumn::y, "y", "Centre, frame of the mesh file [mm]", 3.8f},
    CellColumn{TableColumn::z, "z", "Centre, frame of the mesh file [mm]", 3.8f},
    CellColumn{TableColumn::nx, "nx", "Outward normal, frame of the mesh file", 3.4f},
    CellColumn{TableColumn::ny, "ny", "Outward normal, frame of the mesh file", 3.4f},
    CellColumn{TableColumn::nz, "nz", "Outward normal, frame of the mesh file", 3.4f},
};

/// Returns the next editable cell to the right or the left, across rows. Returns `cell` itself at the ends of the
/// table.
TableCell next_cell(const TableState& table, const Layout& layout, TableCell cell, bool back) {
  std::vector<TableColumn> columns;
  for (const CellColumn& each : kColumns)
    if (is_editable(each.column)) columns.push_back(each.column);
  const auto count = static_cast<std::ptrdiff_t>(columns.size());
  std::ptrdiff_t column = std::find(columns.begin(), columns.end(), cell.column) - columns.begin();
  const std::vector<int>& rows = table.rows;
  auto row = std::find_if(rows.begin(), rows.end(),
                          [&](int i) { return layout.taxels[static_cast<std::size_t>(i)].id == cell.id; });
  cell.begins = true;
  cell.leaves_back.reset();
  column += back ? -1 : 1;
  if (column < 0 && row != rows.begin() && row != rows.end()) {
    --row;
    column = count - 1;
  } else if (column >= count && row != rows.end() && row + 1 != rows.end()) {
    ++row;
    column = 0;
  }
  if (row != rows.end()) cell.id = layout.taxels[static_cast<std::size_t>(*row)].id;
  cell.column = columns[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(column, 0, count - 1))];
  return cell;
}

struct CellValue {
  double number = 0;
  FieldUnit unit;
};
CellValue value_of(const Taxel& taxel, TableColumn column) {
  const auto axis_from = [&](TableColumn first) { return static_cast<int>(column) - static_cast<int>(first); };
  if (column == TableColumn::radius) return {taxel.radius, kMillimetres};
  if (column <= TableColumn::z) return {taxel.center[axis_from(TableColumn::x)], kMillimetres};
  return {taxel.normal[axis_from(TableColumn::nx)], kPlain};
}

TaxelChange change_of(const Taxel& taxel, TableColumn column, double value) {
  TaxelChange change;
  change.id = taxel.id;
  if (column == TableColumn::radius) {
    change.radius = value;
  } else if (column <= TableColumn::z) {
    change.center = taxel.center;
    (*change.center)[static_cast<int>(column) - static_cast<int>(TableColumn::x)] = value;
  } else {
    change.normal = taxel.normal;
    (*change.normal)[static_cast<int>(column) - static_cast<int>(TableColumn::nx)] = value;
  }
  return change;
}

/// Draws the field of the cell. Requests the edit if the typed text differs.
void draw_field(WindowUi& ui, const Taxel& taxel, TableColumn column, const std::string& name) {
  TaxelChange change;
  change.id = taxel.id;
  if (column == TableColumn::name) {
    change.name = text_field(ui, name, {taxel.name});
    if (change.name) post_edit(ui, SetTaxels{{change}});
    return;
  }
  const CellValue value = value_of(taxel, column);
  if (const auto typed = number_field(ui, name, {value.number}, value.unit))
    post_edit(ui, SetTaxels{{change_of(taxel, column, *typed)}});
}

}  // namespace

std::span<const CellColumn> layout_columns() {
  return kColumns;
}

void draw_color_square(int color) {
  const float size = ImGui::GetFontSize() * 0.72f;
  const ImVec2 p = ImGui::GetCursorScreenPos();
  const float y = p.y + 0.5f * (ImGui::GetTextLineHeight() - size);
  if (color >= 0)
    ImGui::GetWindowDrawList()->AddRectFilled({p.x, y}, {p.x + size, y + size}, taxel_color_u32(color), 3);
  ImGui::Dummy(ImVec2(size, ImGui::GetTextLineHeight()));
}

void draw_text(const std::string& text, bool right, const ImVec4& color) {
  const float slack = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(text.c_str()).x;
  if (right && slack > 0) ImGui::SetCursorPosX(ImGui::GetCursorPosX() + slack);
  ImGui::PushStyleColor(ImGuiCol_Text, color);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopStyleColor();
}

bool is_editable(TableColumn column) {
  return column != TableColumn::id && column != TableColumn::samples && column != TableColumn::reading &&
         column != TableColumn::sensor;
}

void edit_cell(TableState& table, int id, TableColumn column) {
  table.cell = {id, is_editable(column) ? column : TableColumn::name, true, {}};
}

void draw_cell(WindowUi& ui, TableState& table, const Taxel& taxel, TableColumn column) {
  const auto title = std::find_if(kColumns.begin(), kColumns.end(), [&](const auto& c) { return c.column == column; });
  const std::string name = fmt::format("Taxel {} {}", taxel.id, title->title);
  const auto is_this = [&](const TableCell& cell) { return cell.id == taxel.id && cell.column == column; };
  if (!table.cell || !is_this(*table.cell)) {
    const Palette& colors = palette(ui.dark);
    const bool refused = ui.fields.refused && ui.fields.refused->input.field == name;
    const bool text = column == TableColumn::name;
    const CellValue value = text ? CellValue{} : value_of(taxel, column);
    const std::string shown = refused ? ui.fields.refused->input.typed
                              : text  ? taxel.name
                                      : shown_number(value.number, value.unit);
    draw_text(shown.empty() ? " " : shown, !text, refused ? colors.error : colors.text);
    ui.widgets.note_item(name, true);
    return;
  }
  TableCell& cell = *table.cell;
  if (cell.begins) ImGui::SetKeyboardFocusHere();
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(2, 0));
  draw_field(ui, taxel, column, name);
  ImGui::PopStyleVar();
  if (ImGui::IsItemActive()) cell.begins = false;
  if (ImGui::IsItemActive()) ImGui::SetKeyOwner(ImGuiKey_Tab, ImGui::GetItemID());  // hides Tab from ImGui
  if (ImGui::IsItemActive() && ImGui::IsKeyPressed(ImGuiKey_Tab, true)) {
    cell.leaves_back = ImGui::GetIO().KeyShift;
  } else if (ImGui::IsItemDeactivated()) {
    table.left = cell;
    table.cell.reset();
  }
}

void leave_cell(TableState& table, const Layout& layout) {
  const std::optional<TableCell> left = std::exchange(table.left, std::nullopt);
  // The field is left only after another item was drawn. The field then accepts the typed text in the next frame.
  if (table.cell && table.cell->leaves_back) ImGui::ClearActiveID();
  if (left && left->leaves_back) table.cell = next_cell(table, layout, *left, *left->leaves_back);
  if (table.cell && index_of(layout, table.cell->id) < 0) table.cell.reset();
}

}  // namespace taxel::ui
