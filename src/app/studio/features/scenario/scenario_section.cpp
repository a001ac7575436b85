#include "app/studio/features/scenario/scenario_section.h"

#include <fmt/format.h>
#include <imgui.h>

#include "app/studio/features/scenario/path_recorder.h"
#include "app/studio/features/scenario/path_tool.h"
#include "app/studio/features/scenario/scenario_fields.h"
#include "app/studio/features/scenario/way_point_table.h"
#include "core/document/paper_setting.h"
#include "core/document/scenario/recorded_path.h"
#include "ui/widgets/choice_field.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/number_field.h"

namespace taxel::ui {

namespace {

constexpr FieldUnit kTimestepUnit{"ms", -3, -1};

bool uses(const Scenario& scenario, ScenarioKind kind, double Scenario::*value) {
  for (const ScenarioParameter& parameter : scenario_parameters())
    if (parameter.value == value) return parameter.used_by(kind, scenario.shape);
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
  const bool begins_path = *kind == ScenarioKind::path && scenario.points.size() < 2;
  ask_edit(ui, SetScenario{begins_path ? path_of_run(scenario, input.scenario, points_to_begin_with(ui, input))
                                       : with_kind(scenario, *kind)});
}

void draw_object(UiState& ui, Scenario& edited, bool& changed) {
  begin_property("Object", "What the finger meets");
  if (const auto shape = word_field(ui, "Object", edited.shape)) {
    edited = with_shape(edited, *shape);
    changed = true;
  }
  begin_property("Object mesh", "Mesh file in metres, in place of the shape; empty: the shape");
  if (const auto file = text_field(ui, "Object mesh", {edited.object})) {
    edited = file->empty() ? with_shape(edited, default_shape(edited.kind)) : with_object(edited, *file);
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
      edited = with_kind(edited, ScenarioKind::replay);
      edited.source = *source;
      ui.path.chosen.reset();
      changed = true;
    }
    show_refusal(ui, "Recording");
  }
  for (const ScenarioField& field : scenario_fields()) {
    if (!uses(scenario, shown, field.value)) continue;
    begin_property(field.name, field.tip);
    if (const auto typed = number_field(ui, field.name, {scenario.*field.value}, field.unit)) {
      edited.*field.value = *typed;
      changed = true;
    }
    show_refusal(ui, field.name);
  }
  if (shown != ScenarioKind::paper) draw_object(ui, edited, changed);
  if (changed) ask_edit(ui, SetScenario{edited});
}

/// The paper's setting as one edit: body, samples and scenario.
void draw_paper_setting(UiState& ui, const UiInput& input) {
  const ProjectPtr project = input.editing.project;
  if (!project) return;
  if (button(ui, "As in the paper", ImVec2(-1, 0))) {
    ui.path.chosen.reset();
    ui.path.selected = -1;
    ask_edit(ui, paper_setting_edit(project->layout));
  }
  tooltip(
      "The setting of the paper's released demo as one change: its path over its box, star field, 1e6 samples per "
      "m\u00b2 "
      "of equal weight, modulus 50 kPa, dissipation 5 s/m, friction 0.3");
}

/// Its ways become a path's way points.
void draw_recorder(UiState& ui, const UiInput& input) {
  const std::optional<PathRecording>& recording = ui.path.recording;
  const std::string stop =
      fmt::format("Stop recording ({} way points)###record path", recording ? recording->points.size() : 0);
  const bool pressed =
      recording ? button(ui, stop.c_str(), ImVec2(-1, 0)) : button(ui, "Record a path###record path", ImVec2(-1, 0));
  ui.widgets.note_item("Record path");
  tooltip(
      "Keeps where the finger is, while a scenario leads it or you drag it, until this is pressed again or the run "
      "ends: way points of a path");
  if (pressed) toggle_path_recording(ui, input);
  if (!begin_properties("recorder")) return;
  begin_property("Way point every (ms)", "Of a recorded path; no more than one a picture");
  if (const auto every = number_field(ui, "Way point every", {ui.path.record_every}, kTimestepUnit)) {
    if (*every > 0) {
      ui.path.record_every = *every;
    } else {
      refuse(ui, "must be greater than 0");
    }
  }
  show_refusal(ui, "Way point every");
  end_properties();
}

/// Returns why the scenario cannot run; empty if it can.
std::string why_not_run(const UiInput& input, ScenarioKind shown, bool complete) {
  if (!complete)
    return shown == ScenarioKind::replay ? "Nothing to replay: choose the recording first."
                                         : "Nothing to run: the scenario of this kind is not complete yet.";
  if (!input.model) return "Nothing to simulate: the layout is not compiled.";
  if (input.model->taxel_count() == 0)
    return "Nothing to simulate: the layout has no taxels. Ctrl+click on the mesh places a taxel, Ctrl+G generates a "
           "pattern.";
  if (!input.editing.problem.empty()) return "The layout cannot be simulated: " + input.editing.problem;
  return {};
}

/// A click on the greyed button shows its reason as a message.
void draw_run_button(UiState& ui, const Scenario& scenario, const std::string& reason) {
  const ImGuiStyle& style = ImGui::GetStyle();
  ImGui::PushStyleVar(ImGuiStyleVar_Alpha, reason.empty() ? style.Alpha : style.Alpha * style.DisabledAlpha);
  const bool pressed = button(ui, "Run scenario", ImVec2(-1, 0));
  ImGui::PopStyleVar();
  tooltip(reason.empty() ? "Run the scenario from its start in SIMULATE" : reason.c_str());
  if (!pressed) return;
  if (reason.empty()) {
    ui.ask(RunScenario{scenario});
  } else {
    add_message(ui, Severity::warning, reason, ImGui::GetTime());
  }
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
  draw_run_button(ui, *scenario, why_not_run(input, shown, complete));
  draw_paper_setting(ui, input);
  draw_recorder(ui, input);
  if (complete && *scenario != input.scenario) caption("What runs is the scenario before this change.");
  if (complete && shown == ScenarioKind::path) draw_way_point_table(ui, input, *scenario);
  if (begin_properties("scenario")) {
    draw_fields(ui, *scenario, shown);
    end_properties();
  }
}

}  // namespace taxel::ui
