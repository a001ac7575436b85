#include "app/studio/nouns/scenario/way_point_table.h"

#include <fmt/format.h>

#include "app/studio/nouns/history/edit_commands.h"
#include "app/studio/nouns/scenario/path_tool.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/number_field.h"

namespace taxel::ui {

namespace {

constexpr FieldUnit kSeconds{"s", 0, -1}, kAngleUnit{"deg", 0, 2};
constexpr const char* kAxes[] = {"X", "Y", "Z"};

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
    const std::string name = fmt::format("{} {}", kAxes[axis], number);
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

}  // namespace

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

}  // namespace taxel::ui
