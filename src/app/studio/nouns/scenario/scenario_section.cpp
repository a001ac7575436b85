// The inspector's section about the scenario, which moves the finger.
#include "app/studio/nouns/scenario/scenario_state.h"

#include <fmt/format.h>
#include <imgui.h>

#include "app/studio/frame/app.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/history/edit_commands.h"
#include "app/studio/nouns/timeline/run_commands.h"
#include "core/document/paper_setting.h"
#include "core/document/scenario/path.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/fields.h"

namespace taxel::ui {

namespace {

/// Returns the words of the values of E, with commas.
template <class E>
std::string word_list() {
  std::string list;
  for (const auto& word : words_of(E{})) list += (list.empty() ? "" : ", ") + std::string(word.text);
  return list;
}

constexpr FieldUnit kSeconds{"s", 0, -1}, kAngleUnit{"deg", 0, 2};
constexpr const char* kAxisNames[] = {"X", "Y", "Z"};

/// Returns the rotation vector, axis times angle [degrees].
dvec3 turn_vector(const dquat& q) {
  const dvec3 v = (q.w < 0 ? -1.0 : 1.0) * dvec3(q.x, q.y, q.z);
  const double sine = glm::length(v);
  return sine > 0 ? glm::degrees(2 * std::atan2(sine, std::abs(q.w))) / sine * v : dvec3(0);
}
dquat turned_by(const dvec3& degrees) {
  const double angle = glm::length(degrees);
  return angle > 0 ? glm::angleAxis(glm::radians(angle), degrees / angle) : dquat(1, 0, 0, 0);
}

/// Draws a row of the table. Returns whether the user changed a number of the row.
bool draw_row(WindowUi& ui, PathState& path, int number, WayPoint& point) {
  bool changed = false;
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  if (small_choice(ui, fmt::format("{}##point", number).c_str(), path.selected == number)) path.selected = number;
  ui.widgets.note_item(fmt::format("Way point {}", number));
  ImGui::TableNextColumn();
  if (const auto time = number_field(ui, fmt::format("Time {}", number), {point.time}, kSeconds)) {
    point.time = *time;
    changed = true;
  }
  for (int axis = 0; axis < 3; ++axis) {
    ImGui::TableNextColumn();
    const std::string name = fmt::format("{} {}", kAxisNames[axis], number);
    if (const auto value = number_field(ui, name, {point.X_WM.p[axis]}, kMillimetres)) {
      point.X_WM.p[axis] = *value;
      changed = true;
    }
  }
  return changed;
}

bool draw_turn(WindowUi& ui, WayPoint& point) {
  begin_property("Turned (\u00b0)",
                 "How the frame of the finger's mesh file is turned in the world: an axis times the angle about it");
  dvec3 turn = turn_vector(point.X_WM.q);
  const auto typed = vector_field(ui, "Turned", {turn}, kAngleUnit);
  if (!typed) return false;
  turn[typed->axis] = typed->value;
  point.X_WM.q = turned_by(turn);
  return true;
}

void draw_buttons(WindowUi& ui, const Viewer& viewer, const Shown& shown, PathState& path, const Scenario& scenario) {
  if (button(ui, "Add here")) add_way_point(ui, viewer, shown, path);
  tooltip("Where the finger is now, behind the selected way point");
  ImGui::SameLine();
  ImGui::BeginDisabled(path.selected < 0 || scenario.as<scenarios::Path>().points.size() <= 2);
  if (button(ui, "Delete way point")) delete_way_point(ui, viewer, shown, path);
  ImGui::EndDisabled();
}

/// Draws time and place of each waypoint, the rotation of the selected waypoint, and buttons that add and delete.
void draw_way_point_table(WindowUi& ui, const Viewer& viewer, const Shown& shown, PathState& path,
                          const Scenario& scenario) {
  Scenario edited = scenario;
  std::vector<WayPoint>& points = edited.as<scenarios::Path>().points;
  bool changed = false;
  if (path.selected >= static_cast<int>(points.size())) path.selected = -1;
  if (ImGui::BeginTable("##points", 5, ImGuiTableFlags_SizingStretchProp)) {
    ImGui::TableSetupColumn("#", ImGuiTableColumnFlags_WidthFixed);
    for (const char* name : {"time (s)", "x (mm)", "y (mm)", "z (mm)"}) ImGui::TableSetupColumn(name);
    ImGui::TableHeadersRow();
    for (std::size_t i = 0; i < points.size(); ++i)
      changed = draw_row(ui, path, static_cast<int>(i), points[i]) || changed;
    ImGui::EndTable();
  }
  for (std::size_t i = 0; i < points.size(); ++i)
    for (const char* column : {"Time", "X", "Y", "Z"}) show_refusal(ui, fmt::format("{} {}", column, i));
  if (path.selected >= 0 && begin_properties("turn")) {
    changed = draw_turn(ui, points[static_cast<std::size_t>(path.selected)]) || changed;
    end_properties();
  }
  if (changed) post_edit(ui, SetScenario{edited});
  draw_buttons(ui, viewer, shown, path, scenario);
}

constexpr FieldUnit kTimestepUnit{"ms", -3, -1};

/// Draws the choice of the kind. A kind that lacks a required value stays chosen, without an edit, until the value is
/// set.
void draw_kind(WindowUi& ui, const Viewer& viewer, const Shown& displayed, PathState& path_state,
               const Scenario& scenario, ScenarioKind shown) {
  begin_property("Kind", "How the finger is led");
  const auto kind = word_field(ui, "Kind", shown);
  show_refusal(ui, "Kind");
  if (!kind) return;
  path_state.chosen.reset();
  path_state.selected = -1;
  const Scenario changed = with_kind(scenario, *kind, path_state.last);
  const auto* replay = std::get_if<scenarios::Replay>(&changed.motion);
  if (replay != nullptr && replay->source.empty()) {
    path_state.chosen = kind;
    return;
  }
  const auto* path = std::get_if<scenarios::Path>(&changed.motion);
  const bool begins_path = path != nullptr && path->points.size() < 2;
  post_edit(ui, SetScenario{begins_path
                                ? path_of_run(scenario, displayed.run.scenario, points_to_begin_with(viewer, displayed))
                                : changed});
}

void draw_object(WindowUi& ui, Scenario& edited, bool& changed) {
  begin_property("Object", "Object that the finger touches");
  if (const auto shape = word_field(ui, "Object", edited.shape)) {
    edited = with_shape(edited, *shape);
    changed = true;
  }
  begin_property("Object mesh", "Mesh file in metres, in place of the shape; empty: the shape");
  if (const auto file = text_field(ui, "Object mesh", {edited.object})) {
    edited = file->empty() ? with_shape(edited, default_shape(edited.kind())) : with_object(edited, *file);
    changed = true;
  }
  show_refusal(ui, "Object mesh");
}

bool draw_field(WindowUi& ui, PathState& /*path*/, const FieldSpec& field, double& value) {
  const std::string name = label_with_unit(field);
  begin_property(name.c_str(), field.help);
  const auto typed = number_field(ui, name, {value}, field_unit(field.quantity));
  if (typed) value = *typed;
  show_refusal(ui, name);
  return typed.has_value();
}

bool draw_field(WindowUi& ui, PathState& path, const FieldSpec& field, std::string& file) {
  begin_property(field.label, field.help);
  const auto typed = text_field(ui, field.label, {file});
  const bool changed = typed && !typed->empty();
  if (changed) {
    file = *typed;
    path.chosen.reset();
  }
  show_refusal(ui, field.label);
  return changed;
}

bool draw_field(WindowUi&, PathState&, const FieldSpec&, std::vector<WayPoint>&) {
  return false;  // draw_way_point_table() draws the waypoints
}

/// Returns `scenario` with the values that it shares with `edited`, which is of another kind.
Scenario with_shared_values(Scenario scenario, Scenario edited) {
  if (scenario.shape != edited.shape || scenario.object != edited.object) {
    scenario = with_shape(scenario, edited.shape);
    scenario.object = edited.object;
  }
  for (const ScenarioNumber& number : numbers_of(edited))
    if (double* shared = find_number(scenario, number.field.key)) *shared = *number.value;
  return scenario;
}

void draw_fields(WindowUi& ui, PathState& path, const Scenario& scenario, ScenarioKind shown) {
  Scenario edited = shown == scenario.kind() ? scenario : with_kind(scenario, shown, path.last);
  bool changed = false;
  visit_fields(edited,
               [&](const FieldSpec& field, auto& value) { changed = draw_field(ui, path, field, value) || changed; });
  if (has_object(edited)) draw_object(ui, edited, changed);
  if (!changed) return;
  path.last[shown] = edited;
  post_edit(ui, SetScenario{path.chosen ? with_shared_values(scenario, edited) : edited});
}

/// Draws the button that applies the paper's setting as one edit: body, samples and scenario.
void draw_paper_setting(WindowUi& ui, const DocumentView& document, PathState& path) {
  const ProjectPtr project = document.editing.project;
  if (!project) return;
  if (button(ui, "As in the paper", ImVec2(-1, 0))) {
    path.chosen.reset();
    path.selected = -1;
    post_edit(ui, paper_setting_edit(project->layout));
  }
  tooltip(
      "The setting of the paper's released demo as one change: its path over its box, star field, 1e6 samples per "
      "m\u00b2 "
      "of equal weight, modulus 50 kPa, dissipation 5 s/m, friction 0.3");
}

/// Draws the controls of the recorder, which turns the motion of the tool into the waypoints of a path.
void draw_recorder(WindowUi& ui, const Viewer& viewer, const Shown& shown, PathState& path, Messages& messages) {
  const std::optional<PathRecording>& recording = path.recording;
  const std::string stop =
      fmt::format("Stop recording ({} way points)###record path", recording ? recording->points.size() : 0);
  const bool pressed =
      recording ? button(ui, stop.c_str(), ImVec2(-1, 0)) : button(ui, "Record a path###record path", ImVec2(-1, 0));
  ui.widgets.note_item("Record path");
  tooltip("Record path (click again to stop): the positions of the finger become waypoints");
  if (pressed) toggle_path_recording(ui, viewer, shown, path, messages);
  if (!begin_properties("recorder")) return;
  begin_property("Way point every (ms)", "Of a recorded path; no more than one a picture");
  if (const auto every = number_field(ui, "Way point every", {path.record_every}, kTimestepUnit)) {
    if (*every > 0) {
      path.record_every = *every;
    } else {
      refuse(ui, "must be greater than 0");
    }
  }
  show_refusal(ui, "Way point every");
  end_properties();
}

/// Returns why the scenario cannot run; empty if it can.
std::string why_not_run(const DocumentView& document, ScenarioKind shown, bool complete) {
  if (!complete)
    return shown == kKind<scenarios::Replay> ? "Nothing to replay: choose the recording first."
                                             : "Nothing to run: the scenario of this kind is not complete yet.";
  if (!document.model) return "Nothing to simulate: the layout is not compiled.";
  if (document.model->taxel_count() == 0)
    return "Nothing to simulate: the layout has no taxels. Ctrl+click on the mesh places a taxel, Ctrl+G generates a "
           "pattern.";
  if (!document.editing.problem.empty()) return "The layout cannot be simulated: " + document.editing.problem;
  return {};
}

/// Draws the run button. A click on the disabled button shows the reason as a message.
void draw_run_button(WindowUi& ui, Messages& messages, const Scenario& scenario, const std::string& reason) {
  const ImGuiStyle& style = ImGui::GetStyle();
  ImGui::PushStyleVar(ImGuiStyleVar_Alpha, reason.empty() ? style.Alpha : style.Alpha * style.DisabledAlpha);
  const bool pressed = button(ui, "Run scenario", ImVec2(-1, 0));
  ImGui::PopStyleVar();
  tooltip(reason.empty() ? "Run the scenario from its start in SIMULATE" : reason.c_str());
  if (!pressed) return;
  if (reason.empty()) {
    ui.post(RunScenario{scenario});
  } else {
    add_message(messages, Severity::warning, reason, ImGui::GetTime(), Holds::while_unrunnable);
  }
}

}  // namespace

std::vector<PanelPart> scenario_parts() {
  constexpr auto kWhyNot = [](const App& app) -> const char* {
    return app.shown->run.runs_scenario && app.shown->document.editing.project
               ? nullptr
               : "The scenario of a layout is not what runs";
  };
  std::vector<PanelPart> parts;
  const auto add = [&](const std::string& label, const std::string& help, const std::string& widget,
                       const std::string& instead) {
    const auto is_same = [&](const PanelPart& part) { return part.label == label; };
    if (std::none_of(parts.begin(), parts.end(), is_same))
      parts.push_back({label, "Scenario", help, kSimulate, kWhyNot, widget, instead});
  };
  add("Kind", "How the finger is led: " + word_list<ScenarioKind>(), "", "");
  add("Object", "Object that the finger touches: " + word_list<ObjectShape>(), "", "Kind");
  add("Object mesh", "Mesh file in place of the object's shape", "", "Kind");
  for (const Word<ScenarioKind>& kind : words_of(ScenarioKind{})) {
    Scenario scenario = default_scenario(kind.value);
    visit_fields(scenario, [&](const FieldSpec& field, auto& /*value*/) {
      if (field.quantity != FieldQuantity::list) add(field.label, field.help, label_with_unit(field), "Kind");
    });
  }
  add("Run scenario", "Run the scenario from its start", "", "");
  add("As in the paper", "The setting of the paper's released demo, as one change", "", "");
  add("Way point every (ms)", "Time between the way points of a recorded path", "Way point every", "");
  return parts;
}

void draw_scenario_section(WindowUi& ui, const Viewer& viewer, const Shown& displayed, PathState& path,
                           Messages& messages) {
  const Scenario* scenario = edited_scenario(viewer, displayed);
  if (scenario == nullptr || !header(ui, "Scenario")) return;
  const ScenarioKind shown = path.chosen.value_or(scenario->kind());
  const bool complete = shown == scenario->kind();
  if (begin_properties("scenario kind")) {
    draw_kind(ui, viewer, displayed, path, *scenario, shown);
    end_properties();
  }
  draw_run_button(ui, messages, *scenario, why_not_run(displayed.document, shown, complete));
  draw_paper_setting(ui, displayed.document, path);
  draw_recorder(ui, viewer, displayed, path, messages);
  if (complete && *scenario != displayed.run.scenario) caption("What runs is the scenario before this change.");
  if (complete && shown == kKind<scenarios::Path>) draw_way_point_table(ui, viewer, displayed, path, *scenario);
  if (begin_properties("scenario")) {
    draw_fields(ui, path, *scenario, shown);
    end_properties();
  }
}

}  // namespace taxel::ui
