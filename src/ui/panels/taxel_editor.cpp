#include "ui/panels/taxel_editor.h"

#include <fmt/format.h>
#include <imgui.h>

#include <array>
#include <cmath>

#include "ui/widgets/controls.h"
#include "ui/widgets/number_field.h"

namespace taxel::ui {

namespace {

constexpr FieldUnit kMillimetres{"mm", -3, 2}, kPlain{"", 0, 2}, kWhole{"", 0, 0};
constexpr std::array kAxes = {"X", "Y", "Z"};

void begin_row(const char* name) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled("%s", name);
  ImGui::TableNextColumn();
}

/// `change(TaxelChange&, const Taxel&)` for each, as one edit.
template <class Change>
void ask_for(UiState& ui, const std::vector<const Taxel*>& taxels, const Change& change) {
  SetTaxels set;
  for (const Taxel* taxel : taxels) {
    TaxelChange one;
    one.id = taxel->id;
    change(one, *taxel);
    set.changes.push_back(one);
  }
  ui.ask(EditProject{set, {}});
}

template <class Value>
auto values_of(const std::vector<const Taxel*>& taxels, const Value& value) {
  std::vector<std::decay_t<decltype(value(*taxels.front()))>> values;
  for (const Taxel* taxel : taxels) values.push_back(value(*taxel));
  return values;
}

void draw_id(UiState& ui, const Project& project, const Taxel& taxel) {
  begin_row("Id");
  const auto id = number_field(ui, "Id", {static_cast<double>(taxel.id)}, kWhole);
  if (!id) return;
  constexpr double kLargest = 1e9;
  const bool whole = *id == std::floor(*id) && *id >= 0 && *id <= kLargest;
  if (!whole || find_taxel(project.layout, static_cast<int>(*id)) != nullptr) {
    ui.tool.problem = whole ? fmt::format("Id: {} is that of another taxel", *id) : "Id: must be a whole number from 0";
    return;
  }
  ui.ask(EditProject{RenumberTaxels{{{taxel.id, static_cast<int>(*id)}}}, {}});
  // What is selected is the taxel, not its number.
  ui.selection.remove(taxel.id);
  ui.selection.add(static_cast<int>(*id));
}

/// Three fields in a row; `member`: centre or normal.
void draw_vector(UiState& ui, const std::vector<const Taxel*>& taxels, const char* name, dvec3 Taxel::*member,
                 std::optional<dvec3> TaxelChange::*changed, const FieldUnit& unit) {
  begin_row(name);
  const float gap = 3, width = (ImGui::GetContentRegionAvail().x - 2 * gap) / 3;
  for (int axis = 0; axis < 3; ++axis) {
    if (axis > 0) ImGui::SameLine(0, gap);
    const auto values = values_of(taxels, [&](const Taxel& taxel) { return (taxel.*member)[axis]; });
    const std::string label = fmt::format("{} {}", name, kAxes[static_cast<std::size_t>(axis)]);
    const auto value = number_field(ui, label, values, unit, width);
    if (!value) continue;
    ask_for(ui, taxels, [&](TaxelChange& change, const Taxel& taxel) {
      dvec3 vector = taxel.*member;
      vector[axis] = *value;
      change.*changed = vector;
    });
  }
}

}  // namespace

void draw_taxel_fields(UiState& ui, const Project& project) {
  std::vector<const Taxel*> taxels;
  for (const int id : ui.selection.taxels) {
    if (const Taxel* taxel = find_taxel(project.layout, id)) taxels.push_back(taxel);
  }
  if (taxels.empty()) return;
  if (taxels.size() == 1) {
    draw_id(ui, project, *taxels.front());
  } else {
    property("Taxels", std::to_string(taxels.size()));
  }
  begin_row("Name");
  const auto names = values_of(taxels, [](const Taxel& taxel) { return taxel.name; });
  if (const auto name = text_field(ui, "Name", names)) {
    ask_for(ui, taxels, [&](TaxelChange& change, const Taxel&) { change.name = *name; });
  }
  draw_vector(ui, taxels, "Centre (mm)", &Taxel::center, &TaxelChange::center, kMillimetres);
  draw_vector(ui, taxels, "Normal", &Taxel::normal, &TaxelChange::normal, kPlain);
  begin_row("Radius (mm)");
  const auto radii = values_of(taxels, [](const Taxel& taxel) { return taxel.radius; });
  if (const auto radius = number_field(ui, "Radius (mm)", radii, kMillimetres)) {
    ask_for(ui, taxels, [&](TaxelChange& change, const Taxel&) { change.radius = *radius; });
  }
}

}  // namespace taxel::ui
