// The settings of the edited layout, as fields of the inspector.
#include "app/studio/nouns/inspector/inspector_state.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <concepts>
#include <string_view>
#include <vector>

#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/history/edit_commands.h"
#include "core/base/error.h"
#include "core/base/text/message.h"
#include "core/hydro/material/elastomers.h"
#include "core/layout/layout_fields.h"
#include "core/layout/user_choices.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/fields.h"
#include "ui/widgets/format.h"

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
  state.preset.clear();
  if (*made == 0) return false;
  choose_elastomer(state, elastomers()[*made - 1].word);
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

constexpr FieldUnit kDirection{"", 0, 3};

/// Draws the rows of settings, a field for each, and stores entered values.
class SettingRows {
 public:
  explicit SettingRows(WindowUi& ui) : ui_(ui) {}

  /// Draws all settings of S except those for which `is_hidden(key)` is true. Returns whether one was changed.
  template <class S, class IsHidden>
  bool draw(S& settings, const IsHidden& is_hidden) {
    changed_ = false;
    for_each_field<S>([&](const LayoutField& field, auto member) {
      if (is_hidden(std::string_view(field.spec.key))) return;
      const std::string name = label_with_unit(field.spec);
      begin_property(name.c_str(),
                     has_formulas(field.spec) ? field.spec.help + (": " + aggregate_help()) : field.spec.help);
      draw_value(name, field, settings.*member);
    });
    return changed_;
  }
  template <class S>
  bool draw(S& settings) {
    return draw(settings, [](std::string_view) { return false; });
  }

 private:
  static bool has_formulas(const FieldSpec& spec) { return std::string_view(spec.key) == "aggregate"; }

  /// Stores an entered value. A value that the core refuses is shown below its field.
  template <class T, class Entered>
  void take(const std::string& name, T& value, const std::optional<Entered>& entered) {
    if (entered) {
      value = static_cast<T>(*entered);
      changed_ = true;
    }
    show_refusal(ui_, name);
  }
  void draw_value(const std::string& name, const LayoutField& field, double& value) {
    take(name, value, number_field(ui_, name, {value}, field_unit(field.spec.quantity)));
  }
  template <std::integral T>
  void draw_value(const std::string& name, const LayoutField& field, T& value) {
    take(name, value, whole_field(ui_, name, static_cast<std::uint64_t>(std::max(value, T{0})), field.largest));
  }
  void draw_value(const std::string& name, const LayoutField&, bool& value) {
    take(name, value, switch_field(ui_, name, value));
  }
  void draw_value(const std::string& name, const LayoutField&, dvec3& value) {
    const auto typed = vector_field(ui_, name, {value}, kDirection);
    if (!typed) return;
    value[typed->axis] = typed->value;
    changed_ = true;
  }
  template <class E>
  requires std::is_enum_v<E>
  void draw_value(const std::string& name, const LayoutField&, E& value) {
    take(name, value, word_field(ui_, name, value));
  }
  /// A law of points can be replaced here, and its points are edited in the file.
  void draw_value(const std::string& name, const LayoutField&, PressureLaw& law) {
    std::vector<std::string_view> words{"linear", "stiffening"};
    if (law.kind == LawKind::table) words.push_back("table");
    const auto chosen = choice_of(ui_, name, words, static_cast<std::size_t>(law.kind));
    if (chosen && *chosen != static_cast<std::size_t>(law.kind)) {
      constexpr double kUsual = 0.5;
      law = {static_cast<LawKind>(*chosen), kUsual * static_cast<double>(*chosen), {}};
      changed_ = true;
    }
    show_refusal(ui_, name);
    if (law.kind != LawKind::stiffening) return;
    begin_property("Stiffening", "k of p = E e/(1 - k e), e = depth over thickness; 0 or more, less than 1");
    take("Stiffening", law.k, number_field(ui_, "Stiffening", {law.k}, kExactNumber));
  }
  void draw_value(const std::string&, const LayoutField&, const FaceSet&) {}  // draw_region() shows it

  WindowUi& ui_;
  bool changed_ = false;
};

void draw_layout(WindowUi& ui, const Layout& layout) {
  if (!header(ui, "Layout") || !begin_properties("layout")) return;
  begin_property("Layout name", "Of the layout, not of its file");
  if (const auto name = text_field(ui, "Layout name", {layout.name})) post_edit(ui, SetName{*name});
  property("Mesh", layout.mesh.file.substr(layout.mesh.file.find_last_of('/') + 1));
  tooltip(layout.mesh.file);
  SensorFrame frame = layout.frame;
  if (SettingRows(ui).draw(frame)) post_edit(ui, SetFrame{frame});
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
  if (SettingRows(ui).draw(sampling, [](std::string_view key) { return key == "region"; }))
    post_edit(ui, SetSampling{sampling});
  draw_region(ui, project);
  draw_sample_counts(summary, *document.model);
  end_properties();
}

void draw_fields(WindowUi& ui, const Layout& layout) {
  if (!header(ui, "Receptive fields") || !begin_properties("fields")) return;
  ReceptiveFieldRule rule = layout.receptive_field;
  if (SettingRows(ui).draw(rule)) post_edit(ui, SetReceptiveField{rule});
  end_properties();
}

void draw_readout(WindowUi& ui, const Layout& layout) {
  if (!header(ui, "Readout") || !begin_properties("readout")) return;
  Readout readout = layout.readout;
  if (SettingRows(ui).draw(readout)) {
    if (readout.aggregate != layout.readout.aggregate)
      readout = ReadoutChoice{.aggregate = readout.aggregate}.applied_to(readout);
    post_edit(ui, SetReadout{readout});
  }
  end_properties();
}

void draw_material_settings(WindowUi& ui, const Layout& layout, MaterialState& material) {
  if (!header(ui, "Material") || !begin_properties("material")) return;
  Material m = layout.material;
  const bool sticks = m.tangential_stiffness > 0;
  if (SettingRows(ui).draw(m, [&](std::string_view key) { return key == "bristles" && !sticks; }))
    post_edit(ui, SetMaterial{m});
  end_properties();
  draw_material_sheet(ui, layout, material);
}

}  // namespace

void choose_elastomer(MaterialState& material, const std::string& word) {
  const auto& known = elastomers();
  const Elastomer& chosen =
      *std::find_if(known.begin(), known.end(), [&](const Elastomer& one) { return one.word == word; });
  material.is_open = true;
  material.preset = word;
  material.layer.youngs = chosen.youngs;
  material.layer.poisson = chosen.poisson;
  material.result.reset();
  material.problem.clear();
}

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
