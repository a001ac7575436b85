#include "app/studio/nouns/inspector/material_section.h"

#include <fmt/format.h>
#include <imgui.h>

#include <string_view>
#include <vector>

#include "app/studio/nouns/history/edit_commands.h"
#include "core/base/error.h"
#include "core/base/text/shown_message.h"
#include "core/hydro/material/elastomers.h"
#include "ui/theme.h"
#include "ui/widgets/choice_field.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/number_field.h"

namespace taxel::ui {

namespace {

constexpr FieldUnit kSheetKilopascals{"kPa", 3, 1};
constexpr std::string_view kOwnValues = "own values";

/// Draws a field for a number of the data sheet. Returns whether the user changed the number.
bool sheet_number(WindowUi& ui, const char* name, const char* tip, double& value, const FieldUnit& unit) {
  begin_property(name, tip);
  const auto typed = number_field(ui, name, {value}, unit);
  if (typed) value = *typed;
  show_refusal(ui, name);
  return typed.has_value();
}

bool draw_presets(WindowUi& ui, MaterialState& state) {
  std::vector<std::string_view> words{kOwnValues};
  std::size_t chosen = 0;
  for (const Elastomer& one : elastomers()) {
    if (one.word == state.preset) chosen = words.size();
    words.push_back(one.word);
  }
  begin_property("Elastomer", chosen == 0
                                  ? std::string("Young's modulus and Poisson's ratio of a known elastomer")
                                  : fmt::format("{}\nSource: {}\nUnverified: {}", elastomers()[chosen - 1].title,
                                                elastomers()[chosen - 1].source, elastomers()[chosen - 1].unverified));
  const auto made = choice_of(ui, "Elastomer", words, chosen);
  if (!made) return false;
  state.preset = *made == 0 ? "" : elastomers()[*made - 1].word;
  if (*made == 0) return false;
  state.layer.youngs = elastomers()[*made - 1].youngs;
  state.layer.poisson = elastomers()[*made - 1].poisson;
  return true;
}

/// Draws all fields. Returns whether the user changed a value.
bool draw_fields_of_sheet(WindowUi& ui, MaterialState& state) {
  bool changed = draw_presets(ui, state);
  const bool typed = sheet_number(ui, "Young's modulus (kPa)", "Of the elastomer at small strain", state.layer.youngs,
                                  kSheetKilopascals);
  const bool other = sheet_number(ui, "Poisson's ratio", "At least 0, less than 0.5. Rubber: 0.49 to 0.4999",
                                  state.layer.poisson, kExactNumber);
  if (typed || other) state.preset.clear();
  changed = sheet_number(ui, "Layer (mm)", "Thickness of the elastomer over the rigid core", state.layer.thickness,
                         kExactMillimetres) ||
            changed || typed || other;
  begin_property("Glued", "The elastomer is glued to the core. Otherwise it slides on the core");
  if (const auto on = switch_field(ui, "Glued", state.layer.base == LayerBase::bonded)) {
    state.layer.base = *on ? LayerBase::bonded : LayerBase::sliding;
    changed = true;
  }
  begin_property(
      "Contact radius (mm)",
      "Radius of the contact for which the force is right: sqrt(2 R depth) for a ball of radius R\nEmpty: much "
      "wider than the layer is thick");
  if (const auto radius = optional_field(ui, "Contact radius (mm)", state.contact_radius, kExactMillimetres)) {
    state.contact_radius = *radius;
    changed = true;
  }
  show_refusal(ui, "Contact radius (mm)");
  return changed;
}

void compute(MaterialState& state) {
  state.result.reset();
  state.problem.clear();
  try {
    state.result = pad_modulus(state.layer, state.contact_radius, PressedBody::ball);
  } catch (const Error& e) {
    state.problem = shown_message(e);
  }
}

/// Returns a sentence on the contacts for which the modulus is right.
std::string validity(const PadModulus& result) {
  const double percent = 100.0 * kModulusTolerance;
  if (result.holds)
    return fmt::format("Force within {:.0f} % for contact radii from {:.3g} to {:.3g} mm", percent,
                       1e3 * result.holds->low, 1e3 * result.holds->high);
  const ModulusError& at = result.errors[2];
  return fmt::format("Force off by {:+.0f} % at a contact radius of {:.3g} mm: enter the contact radius",
                     100.0 * at.force_error, 1e3 * at.contact_radius);
}

/// Draws a wrapped line and records it as a widget with this label.
void line(WindowUi& ui, const std::string& text, const ImVec4& color) {
  ImGui::TextColored(color, "%s", text.c_str());
  ui.widgets.note_item(text);
}

void draw_result(WindowUi& ui, const Layout& layout, const MaterialState& state) {
  const Palette& colors = palette(ui.dark);
  ImGui::PushTextWrapPos();
  if (!state.result) line(ui, state.problem, colors.error);
  if (state.result) {
    const bool is_right = state.result->holds.has_value();
    line(ui, fmt::format("Modulus of the pad: {:.4g} kPa", 1e-3 * state.result->modulus), colors.text);
    line(ui, validity(*state.result), is_right ? colors.text : colors.warning);
    if (!is_right && state.result->poisson_limit)
      line(ui,
           fmt::format("At {:.3g} mm a thin layer's modulus is too large from nu = {:.3f} on",
                       1e3 * state.result->poisson_limit_radius, *state.result->poisson_limit),
           colors.warning);
  }
  ImGui::PopTextWrapPos();
  ImGui::BeginDisabled(!state.result);
  if (button(ui, "Apply data sheet")) {
    Material material = layout.material;
    material.field = FieldKind::pad;
    material.modulus = state.result->modulus;
    material.thickness = state.layer.thickness;
    ui.post(EditProject{SetMaterial{material}, {}});
  }
  ImGui::EndDisabled();
  tooltip("Sets modulus, thickness and field of the material. Undo takes all of it back.");
}

}  // namespace

void draw_material_sheet(WindowUi& ui, const Layout& layout, MaterialState& state) {
  if (toggle(ui, "From a data sheet", state.is_open, "Modulus from Young's modulus, Poisson's ratio and thickness")) {
    state.is_open = !state.is_open;
    constexpr double kUsualThickness = 2e-3;
    if (state.layer.thickness <= 0)
      state.layer.thickness = layout.material.thickness > 0 ? layout.material.thickness : kUsualThickness;
  }
  if (!state.is_open || !begin_properties("sheet")) return;
  const bool changed = draw_fields_of_sheet(ui, state);
  end_properties();
  if (changed || (!state.result && state.problem.empty())) compute(state);
  draw_result(ui, layout, state);
}

}  // namespace taxel::ui
