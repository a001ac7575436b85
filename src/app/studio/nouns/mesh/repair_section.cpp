#include "app/studio/nouns/mesh/repair_section.h"

#include <fmt/format.h>
#include <imgui.h>

#include <cmath>

#include "app/studio/nouns/camera/camera_follow.h"
#include "app/studio/nouns/history/edit_commands.h"
#include "app/studio/nouns/timeline/run_commands.h"
#include "ui/theme.h"
#include "ui/widgets/choice_field.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/format.h"

namespace taxel::ui {

namespace {

void set_level(WindowUi& ui, RepairRecipe recipe, RepairLevel level) {
  recipe.level = level;
  ui.post(EditProject{SetRepair{recipe}, {}});
}

/// Moves the camera to look at the place of a step from outside of the skin, near enough to see the faces around it.
void frame_step(WindowUi& ui, Viewer& viewer, const DocumentView& document, MeshState& mesh_state, FollowState& follow,
                const SensorModel& model, std::size_t step) {
  constexpr double kPartOfMesh = 0.3, kSteepest = 85;
  const dvec3 place = model.repaired->report.steps[step].place;
  const SurfacePoint nearest = model.skin->closest_point(place);
  const dvec3 n = model.skin->mesh().face_normals()[static_cast<std::size_t>(nearest.face)];
  if (viewer.mode != Mode::layout) ui.post(SetMode{Mode::layout});
  Camera& camera = viewer.cameras[0];
  camera.target = place;
  camera.azimuth_deg = glm::degrees(std::atan2(n.y, n.x));
  camera.elevation_deg = std::clamp(glm::degrees(std::asin(std::clamp(n.z, -1.0, 1.0))), -kSteepest, kSteepest);
  camera.distance = kPartOfMesh * model.mesh->bounds().diagonal() / std::tan(0.5 * glm::radians(camera.fov_deg)) * 0.5;
  mesh_state.step = static_cast<int>(step);
  mesh_state.shows_changes = true;
  if (viewer.mode == Mode::layout && document.model) free_camera(viewer, follow);
}

}  // namespace

std::string mesh_state_text(const SensorModel& model) {
  const RepairReport& report = model.repaired->report;
  if (!model.mesh->closed()) return "open";
  if (model.mesh == model.loaded) return "closed";
  if (report.level == RepairLevel::wrap)
    return fmt::format("wrapped, off by {} rms, {} at most", in_mm(report.distance_rms, 3),
                       in_mm(report.distance_max, 3));
  constexpr double kRounding = 5e-8;
  if (report.vertices_moved > 0 && report.largest_move < kRounding) return "repaired exactly, joined within rounding";
  if (report.vertices_moved > 0)
    return fmt::format("repaired exactly, moved by {} at most", in_mm(report.largest_move, 4));
  return "repaired exactly, no vertex moved";
}

void draw_repair_rows(WindowUi& ui, const DocumentView& document, const SensorModel& model) {
  const Palette& colors = palette(ui.dark);
  const bool closed = model.mesh->closed();
  const bool repairing = !document.editing.compiled && (closed == document.editing.problem.empty()) &&
                         document.editing.project->layout.mesh.repair != model.layout.mesh.repair;
  if (repairing) {
    begin_property("Repair", "A wrap takes seconds; the mesh shown is the one before");
    ImGui::TextUnformatted("running ...");
    ImGui::SameLine();
    if (ImGui::SmallButton("Cancel##repair")) ui.post(UndoStep{});
    ui.widgets.note_item("Cancel the repair");
  }
  property("State", mesh_state_text(model), closed ? colors.text : colors.warning);
  tooltip(closed ? "A closed mesh has an inside, and so it can be soft. The file is not changed by a repair."
                 : document.editing.problem);
  ui.widgets.note_item("Mesh state");
  const RepairRecipe& recipe = document.editing.project->layout.mesh.repair;
  begin_property(
      "Repair level",
      "auto: exact steps, and a wrap of parts that they cannot close\nexact: no wrap\nwrap: a closed surface around "
      "every part\nkeep: the mesh stays as the file has it (mesh/repair/level)");
  if (const auto level = word_field(ui, "Repair level", recipe.level)) set_level(ui, recipe, *level);
}

void draw_repair_steps(WindowUi& ui, Viewer& viewer, const DocumentView& document, MeshState& mesh, FollowState& follow,
                       const SensorModel& model) {
  const std::vector<RepairStep>& steps = model.repaired->report.steps;
  const RepairRecipe& recipe = document.editing.project->layout.mesh.repair;
  const bool can_repair = recipe.level != RepairLevel::automatic && !model.mesh->closed();
  if (!can_repair && steps.empty()) return;
  ImGui::BeginDisabled(!can_repair);
  if (button(ui, "Repair")) set_level(ui, recipe, RepairLevel::automatic);
  ImGui::EndDisabled();
  tooltip("Close the mesh by as little as it needs. The file is not changed, and Undo takes the repair back.");
  if (steps.empty()) return;
  ImGui::SameLine();
  if (toggle(ui, "Show changes", mesh.shows_changes,
             "Filled faces green, removed ones outlined in red, parted edges yellow, a wrap by its distance"))
    mesh.shows_changes = !mesh.shows_changes;
  const Palette& colors = palette(ui.dark);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    ImGui::PushID(static_cast<int>(i));
    ImGui::PushStyleColor(ImGuiCol_Text, severity_color(colors, steps[i].severity));
    const float room = ImGui::GetContentRegionAvail().x;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const ImVec2 size = ImGui::CalcTextSize(steps[i].message.c_str(), nullptr, false, room);
    if (ImGui::Selectable("##step", mesh.step == static_cast<int>(i), 0, {room, size.y}))
      frame_step(ui, viewer, document, mesh, follow, model, i);
    ui.widgets.note_item("Step " + steps[i].code);
    ImGui::GetWindowDrawList()->AddText(ImGui::GetFont(), ImGui::GetFontSize(), corner,
                                        ImGui::GetColorU32(ImGuiCol_Text), steps[i].message.c_str(), nullptr, room);
    ImGui::PopStyleColor();
    tooltip("Click to see the place");
    ImGui::PopID();
  }
}

}  // namespace taxel::ui
