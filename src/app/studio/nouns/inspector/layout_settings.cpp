#include "app/studio/nouns/inspector/layout_settings.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/history/edit_commands.h"
#include "app/studio/nouns/inspector/material_state.h"
#include "core/base/error.h"
#include "core/base/text/shown_message.h"
#include "core/hydro/material/elastomers.h"
#include "core/layout/layout.h"
#include "core/layout/readout_choice.h"
#include "ui/theme.h"
#include "ui/widgets/choice_field.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/format.h"
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

/// Draws a switch, and below it the fields of the data sheet with the resulting modulus. The button Apply sets modulus,
/// thickness and field of the layout's material by one edit.
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

constexpr FieldUnit kDirection{"", 0, 3}, kPerSquareMillimetre{"1/mm^2", 6, -1}, kKilopascals{"kPa", 3, -1},
    kSecondsPerMetre{"s/m", 0, -1}, kKilopascalsPerMillimetre{"kPa/mm", 6, -1};
/// Largest seed. A double represents every whole number up to 2^53 exactly.
constexpr std::uint64_t kLargestSeed = std::uint64_t{1} << 53U;

/// Draws a row with a number and stores the typed number in `value`.
bool number_row(WindowUi& ui, const char* name, const char* tip, double& value, const FieldUnit& unit) {
  begin_property(name, tip);
  const auto typed = number_field(ui, name, {value}, unit);
  if (typed) value = *typed;
  show_refusal(ui, name);
  return typed.has_value();
}

/// Draws a row with a choice among the words of a layout file.
template <class E>
bool word_row(WindowUi& ui, const char* name, const char* tip, E& value) {
  begin_property(name, tip);
  const auto chosen = word_field(ui, name, value);
  if (chosen) value = *chosen;
  show_refusal(ui, name);
  return chosen.has_value();
}

bool direction_row(WindowUi& ui, const char* name, const char* tip, dvec3& value) {
  begin_property(name, tip);
  const auto typed = vector_field(ui, name, {value}, kDirection);
  if (typed) value[typed->axis] = typed->value;
  return typed.has_value();
}

void draw_layout(WindowUi& ui, const Layout& layout) {
  if (!header(ui, "Layout") || !begin_properties("layout")) return;
  begin_property("Layout name", "Of the layout, not of its file");
  if (const auto name = text_field(ui, "Layout name", {layout.name})) post_edit(ui, SetName{*name});
  property("Mesh", layout.mesh.file.substr(layout.mesh.file.find_last_of('/') + 1));
  tooltip(layout.mesh.file);
  SensorFrame frame = layout.frame;
  bool changed = direction_row(ui, "Distal", "Where the finger points, in the frame of the mesh file", frame.distal);
  changed = direction_row(ui, "Pad", "Where it touches, at right angles to distal", frame.pad) || changed;
  if (changed) post_edit(ui, SetFrame{frame});
  end_properties();
}

void draw_region(WindowUi& ui, const Project& project) {
  begin_property(
      "Painted region",
      "Faces of the mesh that the brush has painted: there the samples lie, and there Spread evenly puts taxels");
  if (project.layout.sampling.region->empty()) {
    ImGui::TextUnformatted("the whole mesh");
    return;
  }
  ImGui::Text("%s faces", grouped(static_cast<long long>(project.layout.sampling.region->size())).c_str());
  ImGui::SameLine();
  if (ImGui::SmallButton("Clear")) ui.post(EditProject{SetRegion{}, {}});
  ui.widgets.note_item("Clear the region");
}

/// Draws the numbers of samples that result from the settings.
void draw_sample_counts(const ModelSummary& summary, const SensorModel& model) {
  const auto total = static_cast<double>(std::max<std::size_t>(1, model.samples.size()));
  property("Samples", grouped(static_cast<long long>(model.samples.size())));
  property("Used", fmt::format("{} ({:.1f} %)", grouped(summary.used_samples), 100.0 * summary.used_samples / total));
  property("Shared",
           fmt::format("{} ({:.1f} %)", grouped(summary.shared_samples), 100.0 * summary.shared_samples / total));
  property("Uncovered skin", in_mm2(summary.skin_area - summary.used_area));
}

void draw_sampling(WindowUi& ui, const DocumentView& document, const ModelSummary& summary, const Project& project) {
  if (!header(ui, "Sampling") || !begin_properties("sampling")) return;
  Sampling sampling = project.layout.sampling;
  bool changed = number_row(ui, "Density (1/mm\u00b2)", "Samples per area of skin. The paper uses 1 to 10 per mm\u00b2",
                            sampling.density, kPerSquareMillimetre);
  begin_property("Seed", "The same seed gives the same samples on every machine");
  if (const auto seed = whole_field(ui, "Seed", sampling.seed, kLargestSeed)) {
    sampling.seed = *seed;
    changed = true;
  }
  show_refusal(ui, "Seed");
  changed = word_row(ui, "Weights", "Area of skin per sample: an equal part, or the area nearest to it (Voronoi)",
                     sampling.weights) ||
            changed;
  changed = word_row(ui, "Shells", "Closed surfaces that are sampled: outer ones, or those inside of them as well",
                     sampling.shells) ||
            changed;
  if (changed) post_edit(ui, SetSampling{sampling});
  draw_region(ui, project);
  draw_sample_counts(summary, *document.model);
  end_properties();
}

void draw_fields(WindowUi& ui, const Layout& layout) {
  if (!header(ui, "Receptive fields") || !begin_properties("fields")) return;
  ReceptiveFieldRule rule = layout.receptive_field;
  bool changed = word_row(ui, "Metric", "Distances from a taxel's centre: straight (the paper), or along the surface",
                          rule.metric);
  changed = number_row(ui, "Largest angle (\u00b0)",
                       "Between a taxel's normal and those of its samples. The paper uses 45\u00b0", rule.max_angle_deg,
                       kExactDegrees) ||
            changed;
  changed = number_row(ui, "Roll-off (\u00b0)",
                       "Weights fade to 0 over this angle below the largest one. 0: a hard cut, as in the paper",
                       rule.angle_falloff_deg, kExactDegrees) ||
            changed;
  changed = word_row(ui, "Normals",
                     "Of the skin, for the angle: of each face (the paper), or interpolated between the vertices",
                     rule.normals) ||
            changed;
  if (changed) post_edit(ui, SetReceptiveField{rule});
  end_properties();
}

void draw_readout(WindowUi& ui, const Layout& layout) {
  if (!header(ui, "Readout") || !begin_properties("readout")) return;
  Readout readout = layout.readout;
  const std::string formulas = "How a taxel's samples make its reading: " + aggregate_help();
  bool changed = word_row(ui, "Aggregate", formulas.c_str(), readout.aggregate);
  if (changed) readout = ReadoutChoice{.aggregate = readout.aggregate}.applied_to(readout);
  changed = word_row(ui, "Method",
                     "Rays from the samples (the paper), or exact integrals over the contact polygons: for "
                     "weighted_mean, mean and force",
                     readout.method) ||
            changed;
  changed =
      word_row(ui, "Misses", "A ray that meets nothing counts as zero, or is left out", readout.misses) || changed;
  changed =
      word_row(ui, "Ray direction", "Against the normal of the skin at each sample, or of the taxel", readout.ray) ||
      changed;
  changed = number_row(ui, "Largest depth (mm)",
                       "How far rays go. 0: twice the thickness of a pad, the largest radius for a star",
                       readout.max_depth, kExactMillimetres) ||
            changed;
  begin_property("Shear", "Also record the friction on each taxel");
  if (const auto shear = switch_field(ui, "Shear", readout.shear)) {
    readout.shear = *shear;
    changed = true;
  }
  if (changed) post_edit(ui, SetReadout{readout});
  end_properties();
}

void draw_material_settings(WindowUi& ui, const Layout& layout, MaterialState& material) {
  if (!header(ui, "Material") || !begin_properties("material")) return;
  Material m = layout.material;
  bool changed = word_row(ui, "Field",
                          "How pressure grows inside: a pad over a rigid core, or tetrahedra from the centroid (the "
                          "paper's released code)",
                          m.field);
  changed = number_row(ui, "Modulus (kPa)", "Hydroelastic modulus: the pressure at full depth. 0: rigid", m.modulus,
                       kKilopascals) ||
            changed;
  changed = number_row(ui, "Thickness (mm)", "Of the pad. 0: chosen from the size", m.thickness, kExactMillimetres) ||
            changed;
  changed =
      number_row(ui, "Dissipation (s/m)", "Damping of Hunt and Crossley", m.dissipation, kSecondsPerMetre) || changed;
  changed = number_row(ui, "Friction", "Coefficient of Coulomb", m.friction, kExactNumber) || changed;
  changed = word_row(ui, "Faces",
                     "Which faces of a touching body count: those along the pressure's gradient, so that a thin plate "
                     "feels its near face, or all",
                     m.faces) ||
            changed;
  changed =
      number_row(ui, "Tangential stiffness (kPa/mm)",
                 "Of friction that sticks and slips: shear modulus over thickness. 0: friction has no memory, and "
                 "held objects creep",
                 m.tangential_stiffness, kKilopascalsPerMillimetre) ||
      changed;
  if (m.tangential_stiffness > 0) {
    begin_property("Bristles", "Points of the skin that remember friction that sticks");
    if (const auto count = whole_field(ui, "Bristles", static_cast<std::uint64_t>(std::max(m.bristles, 0)),
                                       static_cast<std::uint64_t>(kMostBristles))) {
      m.bristles = static_cast<int>(*count);
      changed = true;
    }
    show_refusal(ui, "Bristles");
  }
  if (changed) post_edit(ui, SetMaterial{m});
  end_properties();
  draw_material_sheet(ui, layout, material);
}

}  // namespace

void draw_layout_settings(WindowUi& ui, const DocumentView& document, const ModelSummary& summary,
                          MaterialState& material) {
  const Project& project = *document.editing.project;
  draw_sampling(ui, document, summary, project);
  draw_fields(ui, project.layout);
  draw_readout(ui, project.layout);
  draw_material_settings(ui, project.layout, material);
  draw_layout(ui, project.layout);
  draw_calibration_settings(ui, project.layout);
}

}  // namespace taxel::ui
