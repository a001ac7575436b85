// The fields, choices and buttons of the inspector that the command palette finds, from the rows that draw them.
#include <algorithm>
#include <array>
#include <type_traits>
#include <utility>

#include "app/studio/frame/app.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/nouns/inspector/inspector_state.h"
#include "app/studio/nouns/mesh/mesh_state.h"
#include "app/studio/nouns/scenario/scenario_state.h"
#include "core/hydro/material/elastomers.h"
#include "core/layout/layout_fields.h"

namespace taxel::ui {
namespace {

const char* why_no_settings(const App& app) {
  return app.shown->document.editing.project ? nullptr : "No layout is open";
}

const char* why_no_taxel(const App& app) {
  if (const char* why = why_no_settings(app)) return why;
  return app.viewer->selection.empty() ? "Select a taxel first" : nullptr;
}

/// Appends the settings of S, which are drawn below this header.
template <LayoutSettings S>
void add_settings(std::vector<PanelPart>& parts, const char* section) {
  for_each_field<S>([&](const LayoutField& field, auto member) {
    using Value = std::remove_cvref_t<decltype(std::declval<S>().*member)>;
    if constexpr (std::is_same_v<Value, FaceSet>) return;  // the brush edits the region
    parts.push_back({.label = field.spec.label,
                     .section = section,
                     .help = field.spec.help,
                     .mode = kLayout,
                     .why_not = why_no_settings,
                     .widget = label_with_unit(field.spec)});
  });
}

void add_taxel_fields(std::vector<PanelPart>& parts) {
  constexpr std::pair<const char*, const char*> kFields[] = {
      {"Id", "Number of the taxel in files and readings"},
      {"Name", "Name of the selected taxel"},
      {"Centre (mm)", "Position of the selected taxels in the frame of the mesh file"},
      {"Normal", "Outward direction of the selected taxels"},
      {"Radius (mm)", "Size of the receptive fields of the selected taxels"},
      {"Samples (1/mm\u00b2)", "Samples per area in the fields of the selected taxels"}};
  for (const auto& [label, help] : kFields) parts.push_back({label, "Selected taxel", help, kLayout, why_no_taxel});
  for (PanelPart& part : parts)
    if (part.label == "Id") part.instead = "Name";  // several taxels have no common id
  parts.push_back({"Add a subtaxel", "Subtaxels", "A taxel with subtaxels reads their fields instead of its own",
                   kLayout, why_no_taxel});
}

/// Appends the fields of the data sheet, which appear when its switch is on, and a row for each elastomer.
void add_data_sheet(std::vector<PanelPart>& parts) {
  const auto open = [](App& app) { app.get<MaterialState>().is_open = true; };
  parts.push_back({"From a data sheet", "Material", "Modulus from Young's modulus, Poisson's ratio and thickness",
                   kLayout, why_no_settings});
  constexpr std::pair<const char*, const char*> kFields[] = {
      {"Elastomer", "Young's modulus and Poisson's ratio of a known silicone or rubber"},
      {"Young's modulus (kPa)", "Of the elastomer at small strain"},
      {"Poisson's ratio", "At least 0, less than 0.5"},
      {"Layer (mm)", "Thickness of the elastomer over the rigid core"},
      {"Glued", "The elastomer is glued to the core, or slides on it"},
      {"Contact radius (mm)", "Radius of the contact for which the force is right"},
      {"Apply data sheet", "Sets modulus, thickness and field of the material"}};
  for (const auto& [label, help] : kFields) {
    PanelPart part{label, "Material", help, kLayout, why_no_settings};
    part.instead = "From a data sheet";
    part.prepare = open;
    parts.push_back(std::move(part));
  }
  for (const Elastomer& one : elastomers()) {
    PanelPart part{one.title, "Material", "A known elastomer of the data sheet", kLayout, why_no_settings, "Elastomer"};
    part.instead = "From a data sheet";
    part.prepare = [word = one.word](App& app) { choose_elastomer(app.get<MaterialState>(), word); };
    parts.push_back(std::move(part));
  }
}

/// Appends the fields of the calibration. Most of them appear when the layout has one.
void add_calibration(std::vector<PanelPart>& parts) {
  parts.push_back(
      {"Calibrated", "Calibration", "Also record values as a device would report them", kLayout, why_no_settings});
  for_each_field<Calibration>([&](const LayoutField& field, auto /*member*/) {
    const std::string_view key = field.spec.key;
    if (key == "curve" || key == "taxels" || key == "response" || key == "crosstalk_matrix") return;  // files only
    PanelPart part{field.spec.label, "Calibration", field.spec.help, kLayout, why_no_settings};
    part.instead = "Calibrated";
    if (key == "quantisation") {
      part.widget = "Step";
      parts.push_back(part);
      part.label = part.widget = "Bits";
    }
    if (key == "rate") part.widget = "Rate (Hz)";
    if (key == "latency") part.widget = "Latency (s)";
    parts.push_back(std::move(part));
  });
}

}  // namespace

std::vector<PanelPart> inspector_parts() {
  std::vector<PanelPart> parts;
  add_taxel_fields(parts);
  for (PanelPart& part : mesh_parts()) parts.push_back(std::move(part));
  add_settings<Sampling>(parts, "Sampling");
  add_settings<ReceptiveFieldRule>(parts, "Receptive fields");
  add_settings<Readout>(parts, "Readout");
  add_settings<Material>(parts, "Material");
  add_data_sheet(parts);
  parts.push_back({"Layout name", "Layout", "Name of the layout, not of its file", kLayout, why_no_settings});
  add_settings<SensorFrame>(parts, "Layout");
  add_calibration(parts);
  parts.push_back({"Fix all", "Problems", "Every repair of the layout that needs no decision, as one step", kLayout,
                   [](const App& app) -> const char* {
                     return app.get<LayoutProblems>().list.empty() ? "The layout has no problems" : nullptr;
                   }});
  for (PanelPart& part : scenario_parts()) parts.push_back(std::move(part));
  for (PanelPart& part : parts)
    if (part.label == "Bristles")
      part.instead = label_with_unit({"", "Tangential stiffness", "", FieldQuantity::pressure_per_length});
  return parts;
}

}  // namespace taxel::ui
