#include "app/studio/nouns/table/table_rows.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>

#include "app/studio/frame/scene_filter.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/nouns/history/edit_commands.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/fields.h"
#include "ui/widgets/format.h"
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

const char* value_tip(std::string_view title) {
  if (title == kShearTitle) return "Magnitude of the friction on the taxel, in the unit of its reading";
  return title == kSlipTitle ? "Share of the taxel's touched field that slips" : "";
}

void draw_values(const WindowUi& ui, const SensorStep* step, std::size_t taxel, const ReadingUnit& unit,
                 const ValueColumns& columns) {
  const Palette& colors = palette(ui.dark);
  const auto draw = [&](double value, const char* format) {
    draw_text(fmt::format(fmt::runtime(format), value), true, value > 0 ? colors.text : colors.dim);
  };
  ImGui::TableNextColumn();
  if (step != nullptr && taxel < step->readings.size()) draw(unit.scale * step->readings[taxel], "{:.2f}");
  if (columns.shear) {
    ImGui::TableNextColumn();
    if (step != nullptr && taxel < step->shear.size()) draw(unit.scale * glm::length(step->shear[taxel]), "{:.2f}");
  }
  if (columns.slip) {
    ImGui::TableNextColumn();
    if (step != nullptr && taxel < step->slip.size()) draw(kSlipUnit.scale * step->slip[taxel], "{:.0f} %");
  }
}

Table table_of(const Viewer& viewer, const Shown& shown, const Layout& layout, const SensorModel& model) {
  Table table{shown.document.editing.project.get(),
              layout,
              model,
              shows_run(viewer.mode) ? shown.sensor(viewer) : nullptr,
              {},
              {},
              false};
  table.edited = viewer.mode == Mode::layout && shown.document.editing.project;
  if (table.sensor != nullptr) table.values.include(*table.sensor);
  const auto& model_taxels = model.layout.taxels;
  std::unordered_map<int, std::size_t> indices;
  for (std::size_t i = 0; i < layout.taxels.size(); ++i) {
    const int id = layout.taxels[i].id;
    int found = static_cast<int>(i);
    if (i >= model_taxels.size() || model_taxels[i].id != id) {
      if (indices.empty()) indices = taxel_indices(model.layout);
      const auto at = indices.find(id);
      found = at == indices.end() ? -1 : static_cast<int>(at->second);
    }
    table.in_model.push_back(found);
    const auto k = static_cast<std::size_t>(std::max(0, found));
    table.samples.push_back(found < 0 ? 0 : model.fields.first[k + 1] - model.fields.first[k]);
  }
  return table;
}

namespace {

std::vector<int> ids_of(const Layout& layout) {
  std::vector<int> ids;
  for (const Taxel& taxel : layout.taxels) ids.push_back(taxel.id);
  return ids;
}

bool passes(const std::string& filter, const Taxel& taxel, const LayoutProblems& problems) {
  if (filter.empty() || std::to_string(taxel.id).find(filter) != std::string::npos) return true;
  if (contains_word(taxel.name, filter)) return true;
  const std::vector<std::size_t> own = problems.of(taxel.id);
  return std::any_of(own.begin(), own.end(),
                     [&](std::size_t i) { return contains_word(problems.list[i].message, filter); });
}

template <class T>
double number_at(const std::vector<T>* numbers, int index) {
  const auto i = static_cast<std::size_t>(index);
  return numbers != nullptr && i < numbers->size() ? static_cast<double>((*numbers)[i]) : 0.0;
}

double number_in(TableColumn column, const Layout& layout, const TableNumbers& numbers, int index) {
  const Taxel& taxel = layout.taxels[static_cast<std::size_t>(index)];
  switch (column) {
    case TableColumn::id:
    case TableColumn::name:
    case TableColumn::sensor:
      return taxel.id;
    case TableColumn::x:
    case TableColumn::y:
    case TableColumn::z:
      return taxel.center[static_cast<int>(column) - static_cast<int>(TableColumn::x)];
    case TableColumn::nx:
    case TableColumn::ny:
    case TableColumn::nz:
      return taxel.normal[static_cast<int>(column) - static_cast<int>(TableColumn::nx)];
    case TableColumn::radius:
      return taxel.radius;
    case TableColumn::samples:
      return number_at(numbers.samples, index);
    case TableColumn::reading:
      return number_at(numbers.readings, index);
    case TableColumn::shear: {
      const auto i = static_cast<std::size_t>(index);
      return numbers.shear != nullptr && i < numbers.shear->size() ? glm::length((*numbers.shear)[i]) : 0.0;
    }
    case TableColumn::slip:
      return number_at(numbers.slip, index);
  }
  return 0;
}

}  // namespace

std::vector<int> moved_by_one(const Layout& layout, const std::vector<int>& selected, bool up) {
  std::vector<int> ids = ids_of(layout);
  const std::set<int> moved(selected.begin(), selected.end());
  if (!up) std::reverse(ids.begin(), ids.end());
  for (std::size_t i = 1; i < ids.size(); ++i)
    if (moved.contains(ids[i]) && !moved.contains(ids[i - 1])) std::swap(ids[i], ids[i - 1]);
  if (!up) std::reverse(ids.begin(), ids.end());
  return ids;
}

std::vector<int> moved_to(const Layout& layout, const std::vector<int>& selected, int target) {
  std::vector<int> ids = ids_of(layout);
  const std::set<int> moved(selected.begin(), selected.end());
  const auto is_moved = [&](int id) { return moved.contains(id); };
  const auto at = std::find(ids.begin(), ids.end(), target);
  if (at == ids.end() || is_moved(target)) return ids;
  const bool from_above = std::any_of(ids.begin(), at, is_moved);
  const auto place = from_above ? at + 1 : at;
  std::stable_partition(ids.begin(), place, [&](int id) { return !is_moved(id); });
  std::stable_partition(place, ids.end(), is_moved);
  return ids;
}

std::vector<int> table_rows(const TableState& table, const Layout& layout, const LayoutProblems& problems,
                            const TableNumbers& numbers) {
  std::vector<int> rows;
  for (std::size_t i = 0; i < layout.taxels.size(); ++i)
    if (passes(table.filter, layout.taxels[i], problems)) rows.push_back(static_cast<int>(i));
  if (!table.sorted) return rows;
  const auto before = [&](int a, int b) {
    if (*table.sorted == TableColumn::name)
      return layout.taxels[static_cast<std::size_t>(a)].name < layout.taxels[static_cast<std::size_t>(b)].name;
    return number_in(*table.sorted, layout, numbers, a) < number_in(*table.sorted, layout, numbers, b);
  };
  std::stable_sort(rows.begin(), rows.end(),
                   [&](int a, int b) { return table.descending ? before(b, a) : before(a, b); });
  return rows;
}

namespace {

int samples_of(const SensorShown& sensor, std::size_t taxel) {
  const auto& first = sensor.model->fields.first;
  return static_cast<int>(first[taxel + 1] - first[taxel]);
}

double reading_of(const SensorShown& sensor, std::size_t taxel) {
  return taxel < sensor.step->readings.size() ? sensor.unit.scale * sensor.step->readings[taxel] : 0.0;
}

double shear_of(const SensorShown& sensor, std::size_t taxel) {
  return taxel < sensor.step->shear.size() ? sensor.unit.scale * glm::length(sensor.step->shear[taxel]) : 0.0;
}

double slip_of(const SensorShown& sensor, std::size_t taxel) {
  return taxel < sensor.step->slip.size() ? sensor.step->slip[taxel] : 0.0;
}

/// Returns whether a row comes before another one in ascending order of a column.
bool comes_before(TableColumn column, const std::vector<SensorShown>& sensors, const SensorRow& a, const SensorRow& b) {
  const SensorShown &first = sensors[a.sensor], &second = sensors[b.sensor];
  switch (column) {
    case TableColumn::sensor:
      return first.name < second.name;
    case TableColumn::name:
      return first.taxels()[a.taxel].name < second.taxels()[b.taxel].name;
    case TableColumn::samples:
      return samples_of(first, a.taxel) < samples_of(second, b.taxel);
    case TableColumn::reading:
      return reading_of(first, a.taxel) < reading_of(second, b.taxel);
    case TableColumn::shear:
      return shear_of(first, a.taxel) < shear_of(second, b.taxel);
    case TableColumn::slip:
      return slip_of(first, a.taxel) < slip_of(second, b.taxel);
    default:
      return first.taxels()[a.taxel].id < second.taxels()[b.taxel].id;
  }
}

}  // namespace

std::vector<SensorRow> sensor_rows(const TableState& table, const std::vector<SensorShown>& sensors) {
  std::vector<SensorRow> rows;
  for (std::size_t s = 0; s < sensors.size(); ++s) {
    const SensorShown& sensor = sensors[s];
    const bool all = finds_sensor(table.filter, *sensor.scene, static_cast<std::size_t>(sensor.index));
    for (std::size_t k = 0; k < sensor.taxels().size(); ++k) {
      const Taxel& taxel = sensor.taxels()[k];
      if (all || finds(table.filter, {sensor.name, taxel.name, std::to_string(taxel.id)})) rows.push_back({s, k});
    }
  }
  if (!table.sorted) return rows;
  std::stable_sort(rows.begin(), rows.end(), [&](const SensorRow& a, const SensorRow& b) {
    return table.descending ? comes_before(*table.sorted, sensors, b, a) : comes_before(*table.sorted, sensors, a, b);
  });
  return rows;
}

std::vector<SensorLine> sensor_lines(const TableState& table, const std::vector<SensorRow>& rows,
                                     const std::vector<SensorShown>& sensors) {
  std::vector<SensorLine> lines;
  if (table.sorted) {
    for (const SensorRow& row : rows) lines.push_back({false, row, 0});
    return lines;
  }
  for (std::size_t r = 0; r < rows.size();) {
    std::size_t end = r;
    while (end < rows.size() && rows[end].sensor == rows[r].sensor) ++end;
    lines.push_back({true, rows[r], end - r});
    const bool folded = table.filter.empty() &&
                        std::binary_search(table.folded.begin(), table.folded.end(), sensors[rows[r].sensor].index);
    for (; r < end; ++r)
      if (!folded) lines.push_back({false, rows[r], 0});
  }
  return lines;
}

}  // namespace taxel::ui
