#include "ui/panels/scenario_section.h"

#include <array>

#include "ui/panels/way_point_table.h"
#include "ui/tools/path_tool.h"
#include "ui/widgets/choice_field.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/number_field.h"

namespace taxel::ui {

namespace {

constexpr FieldUnit kMillimetres{"mm", -3, -1}, kMillimetresPerSecond{"mm/s", -3, -1}, kMilliseconds{"ms", -3, -1},
    kDegrees{"deg", 0, -1}, kGrams{"g", -3, -1}, kPlain{"", 0, -1};

struct Field {
  double Scenario::*value;
  const char* name;
  FieldUnit unit;
  const char* tip;
};
constexpr std::array<Field, 19> kFields{
    {{&Scenario::depth, "Depth (mm)", kMillimetres, "How far below first touch on the object's top it is led"},
     {&Scenario::speed, "Path speed (mm/s)", kMillimetresPerSecond, "Along straight ways"},
     {&Scenario::before, "Before the edge (mm)", kMillimetres, "Where the lowest point of the finger starts"},
     {&Scenario::past, "Past the edge (mm)", kMillimetres, "Where it ends"},
     {&Scenario::tilt_deg, "Tilt (\u00b0)", kDegrees, "Of the finger's distal axis below the horizontal"},
     {&Scenario::place, "Place (mm)", kMillimetres, "Lowest point of the finger, from the object's middle along x"},
     {&Scenario::clearance, "Clearance (mm)", kMillimetres, "Gap between finger and object at the start"},
     {&Scenario::angle_deg, "Angle (\u00b0)", kDegrees, "Through which it turns, and back; it rolls towards +x"},
     {&Scenario::rate_deg, "Rate (\u00b0/s)", kDegrees, "At which it turns"},
     {&Scenario::distance, "Slide distance (mm)", kMillimetres, "There, and the same way back"},
     {&Scenario::direction_deg, "Direction (\u00b0)", kDegrees, "Of the slide, from +x towards +y"},
     {&Scenario::hold, "Hold (s)", kPlain, "Rest at the depth, or at the end of the way there"},
     {&Scenario::height, "Height (mm)", kMillimetres, "From which it drops: the gap to the object"},
     {&Scenario::duration, "Drop lasts (s)", kPlain, "Until the scenario is over"},
     {&Scenario::box_size, "Object size (mm)", kMillimetres,
      "Edges of a box, sides of a plate (a tenth as thick), diameter of a sphere"},
     {&Scenario::finger_mass, "Finger mass (g)", kGrams, "Of the whole finger"},
     {&Scenario::record_every, "Row every (mm)", kMillimetres, "Of travel, in plots and recordings"},
     {&Scenario::record_interval, "Row every (ms)", kMilliseconds, "In plots and recordings"},
     {&Scenario::timestep, "Time step (ms)", kMilliseconds, "Of the simulation"}}};

bool uses(ScenarioKind kind, double Scenario::*value) {
  for (const ScenarioParameter& parameter : scenario_parameters())
    if (parameter.value == value) return parameter.used_by(kind);
  return false;
}

/// A kind that needs what is not there yet is remembered until it is.
void draw_kind(UiState& ui, const UiInput& input, const Scenario& scenario, ScenarioKind shown) {
  begin_property("Kind", "How the finger is led");
  const auto kind = word_field(ui, "Kind", shown);
  show_refusal(ui, "Kind");
  if (!kind) return;
  ui.path.chosen.reset();
  ui.path.selected = -1;
  if (*kind == ScenarioKind::replay && scenario.source.empty()) {
    ui.path.chosen = kind;
    return;
  }
  Scenario edited = scenario;
  edited.kind = *kind;
  if (*kind == ScenarioKind::path && scenario.points.size() < 2) edited.points = points_to_begin_with(ui, input);
  ask_edit(ui, SetScenario{edited});
}

void draw_object(UiState& ui, Scenario& edited, bool& changed) {
  begin_property("Object", "What the finger meets");
  if (const auto shape = word_field(ui, "Object", edited.shape)) {
    edited.shape = *shape;
    edited.object.clear();
    changed = true;
  }
  begin_property("Object mesh", "Mesh file in metres, in place of the shape; empty: the shape");
  if (const auto file = text_field(ui, "Object mesh", {edited.object})) {
    edited.object = *file;
    if (!file->empty()) edited.shape = ObjectShape::box;
    changed = true;
  }
  show_refusal(ui, "Object mesh");
}

void draw_fields(UiState& ui, const Scenario& scenario, ScenarioKind shown) {
  Scenario edited = scenario;
  bool changed = false;
  if (shown == ScenarioKind::replay) {
    begin_property("Recording", "A folder of taxel sweep, play or run, or its readings.npz");
    if (const auto source = text_field(ui, "Recording", {scenario.source}); source && !source->empty()) {
      edited.kind = ScenarioKind::replay;
      edited.source = *source;
      ui.path.chosen.reset();
      changed = true;
    }
    show_refusal(ui, "Recording");
  }
  for (const Field& field : kFields) {
    if (!uses(shown, field.value)) continue;
    begin_property(field.name, field.tip);
    if (const auto typed = number_field(ui, field.name, {scenario.*field.value}, field.unit)) {
      edited.*field.value = *typed;
      changed = true;
    }
    show_refusal(ui, field.name);
  }
  draw_object(ui, edited, changed);
  if (changed) ask_edit(ui, SetScenario{edited});
}

}  // namespace

void draw_scenario_section(UiState& ui, const UiInput& input) {
  const Scenario* scenario = edited_scenario(ui, input);
  if (scenario == nullptr || !header(ui, "Scenario")) return;
  const ScenarioKind shown = ui.path.chosen.value_or(scenario->kind);
  const bool complete = shown == scenario->kind;
  if (begin_properties("scenario kind")) {
    draw_kind(ui, input, *scenario, shown);
    end_properties();
  }
  ImGui::BeginDisabled(!input.simulates_document || !complete);
  if (button(ui, "Run scenario", ImVec2(-1, 0))) ui.ask(RunSweep{*scenario});
  ImGui::EndDisabled();
  if (complete && *scenario != input.scenario) caption("What runs is the scenario before this change.");
  if (complete && shown == ScenarioKind::path) draw_way_point_table(ui, input, *scenario);
  if (begin_properties("scenario")) {
    draw_fields(ui, *scenario, shown);
    end_properties();
  }
}

}  // namespace taxel::ui
