// The mesh of the edited document in the inspector: unit, size, direction, repair and defects.
#include <fmt/format.h>
#include <imgui.h>

#include <array>
#include <cmath>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/host/document/documents.h"
#include "app/studio/host/host.h"
#include "app/studio/nouns/camera/camera_state.h"
#include "app/studio/nouns/history/edit_commands.h"
#include "app/studio/nouns/mesh/mesh_state.h"
#include "app/studio/nouns/timeline/run_commands.h"
#include "ui/scene/scene_input.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/fields.h"
#include "ui/widgets/format.h"

namespace taxel::ui {
namespace {

struct Unit {
  const char* name;
  double metres;
};
constexpr std::array kUnits{Unit{"m", 1}, Unit{"cm", 0.01}, Unit{"mm", 0.001}, Unit{"um", 1e-6}, Unit{"inch", 0.0254}};

std::string unit_name(const dvec3& scale) {
  for (const Unit& unit : kUnits) {
    if (scale == dvec3(unit.metres)) return unit.name;
  }
  return fmt::format("x {:g}, {:g}, {:g}", scale.x, scale.y, scale.z);
}

struct NamedAxis {
  const char* name;
  dvec3 direction;
};
const std::array<NamedAxis, 6> kAxes{NamedAxis{"+x", {1, 0, 0}}, {"-x", {-1, 0, 0}}, {"+y", {0, 1, 0}},
                                     {"-y", {0, -1, 0}},         {"+z", {0, 0, 1}},  {"-z", {0, 0, -1}}};

std::string axis_name(const dvec3& direction) {
  for (const NamedAxis& axis : kAxes) {
    if (glm::distance(direction, axis.direction) < 1e-9) return axis.name;
  }
  return fmt::format("{:.2f}, {:.2f}, {:.2f}", direction.x, direction.y, direction.z);
}

/// Draws a row with a choice of words. Returns the index of the word that the user chooses now, or -1. Choices are
/// recorded as widgets named "Name: word".
template <class Words>
int property_choice(WindowUi& ui, const char* name, const std::string& now, const Words& words,
                    const char* explanation) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled("%s", name);
  tooltip(explanation);
  ImGui::TableNextColumn();
  ImGui::SetNextItemWidth(-1);
  int taken = -1;
  const bool open = ImGui::BeginCombo((std::string("##") + name).c_str(), now.c_str());
  if (!open) {
    ui.widgets.note_item(name);
    tooltip(explanation);
    return -1;
  }
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (ImGui::Selectable(words[i].name, now == words[i].name)) taken = static_cast<int>(i);
    ui.widgets.note_item(fmt::format("{}: {}", name, words[i].name));
  }
  ImGui::EndCombo();
  return taken;
}

void draw_frame_choices(WindowUi& ui, MeshState& mesh, const SensorFrame& frame) {
  const int tip = property_choice(ui, "Tip points to", axis_name(frame.distal), kAxes,
                                  "Axis of the mesh file along which the finger points (frame/distal)");
  const int pad = property_choice(ui, "Pad faces", axis_name(frame.pad), kAxes,
                                  "Axis of the mesh file on the side that touches (frame/pad)");
  SensorFrame chosen = frame;
  if (tip >= 0) chosen.distal = kAxes[static_cast<std::size_t>(tip)].direction;
  if (pad >= 0) chosen.pad = kAxes[static_cast<std::size_t>(pad)].direction;
  // If the new tip is along the pad direction, the two directions are exchanged. They stay at right angles.
  if (tip >= 0 && std::abs(glm::dot(chosen.distal, chosen.pad)) > 0.5) chosen.pad = frame.distal;
  if (pad >= 0 && std::abs(glm::dot(chosen.distal, chosen.pad)) > 0.5) chosen.distal = frame.pad;
  if (tip >= 0 || pad >= 0) set_frame(ui, mesh, chosen);
}

/// Draws the note that tip and pad are a guess, and the buttons that set them by clicks.
void draw_frame_buttons(WindowUi& ui, MeshState& mesh) {
  if (mesh.frame_is_guess) {
    ImGui::TextWrapped("Tip and pad are a guess: see the arrows.");
    if (ImGui::Button("Confirm tip and pad", ImVec2(-1, 0))) mesh.frame_is_guess = false;
    ui.widgets.note_item("Confirm tip and pad");
  }
  const auto pick = [&](const char* label, FramePick what, const char* explanation) {
    if (ImGui::Button(label, ImVec2(-1, 0))) mesh.pick = what;
    ui.widgets.note_item(label);
    tooltip(explanation);
  };
  pick("Click the tip", FramePick::tip,
       "The next click on a face makes its outward direction the tip's (frame/distal)");
  pick("Click the pad", FramePick::pad, "The next click on a face makes its outward direction the pad's (frame/pad)");
}

void draw_mesh_report(WindowUi& ui, const ViewPlace& place, const DocumentView& document, PanelsShown& panels) {
  if (!panels[kMeshReport]) return;
  const float em = ImGui::GetFontSize();
  const ImGuiViewport* viewport = ImGui::GetMainViewport();
  ImGui::SetNextWindowPos({place.rect.x0 + place.strip + em, place.rect.y0 + 5 * em}, ImGuiCond_Appearing);
  ImGui::SetNextWindowSizeConstraints({24 * em, 0}, {0.9f * viewport->Size.x, 0.6f * viewport->Size.y});
  ImGui::SetNextWindowSize({38 * em, 0}, ImGuiCond_Appearing);
  ImGui::PushStyleColor(ImGuiCol_WindowBg, palette(ui.dark).raised);
  constexpr auto kFlags = ImGuiWindowFlags_NoDocking | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNavInputs |
                          ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoFocusOnAppearing |
                          ImGuiWindowFlags_AlwaysAutoResize;
  if (ImGui::Begin("Mesh report", &panels[kMeshReport], kFlags)) {
    ImGui::PushTextWrapPos(37 * em);
    if (!document.editing.project) {
      ImGui::TextDisabled("No mesh is open.");
    } else {
      ImGui::TextDisabled("%s", document.editing.project->layout.mesh.file.c_str());
      ui.widgets.note_item("Mesh report window");
      if (!document.editing.mesh_findings) {
        ImGui::TextDisabled("It could not be read.");
      } else if (document.editing.mesh_findings->empty()) {
        ImGui::TextUnformatted("Closed, wound alike, nothing repaired, nothing found.");
      } else {
        for (const MeshFinding& finding : *document.editing.mesh_findings) {
          ImGui::Spacing();
          ImGui::TextColored(severity_color(palette(ui.dark), finding.severity), "%s", finding.what.c_str());
          ui.widgets.note_item(finding.what);
          ImGui::TextUnformatted(finding.meaning.c_str());
        }
      }
    }
    ImGui::PopTextWrapPos();
  }
  ImGui::End();
  ImGui::PopStyleColor();
}

}  // namespace

void draw_mesh_section(WindowUi& ui, Viewer& viewer, const DocumentView& document, MeshState& mesh, FollowState& follow,
                       PanelsShown& panels, const SensorModel& model) {
  if (!document.editing.project || !header(ui, "Mesh") || !begin_properties("mesh")) return;
  const Layout& layout = document.editing.project->layout;
  property("File", layout.mesh.file.substr(layout.mesh.file.find_last_of('/') + 1));
  tooltip(layout.mesh.file);
  const int unit = property_choice(ui, "Unit", unit_name(layout.mesh.scale), kUnits,
                                   "Length of one unit of the file. It is a guess if the file was opened alone.");
  if (unit >= 0) ui.post(SetMeshUnit{kUnits[static_cast<std::size_t>(unit)].metres});
  const dvec3 size = 1e3 * model.mesh->bounds().extent();
  property("Size (mm)", fmt::format("{:.4g} x {:.4g} x {:.4g}", size.x, size.y, size.z));
  property("Triangles", model.mesh == model.loaded
                            ? grouped(model.mesh->face_count())
                            : fmt::format("{}, {} in the file", grouped(model.mesh->face_count()),
                                          grouped(model.loaded->face_count())));
  draw_repair_rows(ui, document, model);
  draw_frame_choices(ui, mesh, layout.frame);
  end_properties();
  draw_frame_buttons(ui, mesh);
  draw_repair_steps(ui, viewer, document, mesh, follow, model);
  if (!document.editing.mesh_findings) return;
  const std::string found = count_findings(*document.editing.mesh_findings);
  const std::string label = "Mesh report: " + (found.empty() ? "nothing found" : found);
  if (ImGui::Button((label + "###mesh_report").c_str(), ImVec2(-1, 0))) panels[kMeshReport] = true;
  ui.widgets.note_item("Mesh report");
}

std::vector<PanelPart> mesh_parts() {
  constexpr auto kWhyNot = [](const App& app) -> const char* {
    return app.shown->document.editing.project ? nullptr : "No layout is open";
  };
  const auto part = [&](const char* label, const char* help) {
    return PanelPart{label, "Mesh", help, kLayout, kWhyNot};
  };
  std::vector<PanelPart> parts{
      part("Unit", "Length of one unit of the mesh file: mm, cm, m or inches"),
      part("Repair level", "How far a repair of the mesh may go: auto, exact, wrap or keep"),
      part("Tip points to", "Axis of the mesh file along which the finger points"),
      part("Pad faces", "Axis of the mesh file on the side that touches"),
      part("Click the tip", "The next click on a face makes its outward direction the tip's"),
      part("Click the pad", "The next click on a face makes its outward direction the pad's"),
      part("Repair", "Close the mesh by as little as it needs"),
      part("Show changes", "Filled faces green, removed ones outlined in red, parted edges yellow")};
  // A mesh that is closed has no buttons for a repair.
  for (PanelPart& one : parts)
    if (one.label == "Repair" || one.label == "Show changes") one.instead = "Repair level";
  return parts;
}

constinit const Feature kMeshReport{
    .title = "Mesh report",
    .dock = Dock::floating,
    .opens = Opens::by_user,
    .key = "panel_mesh_report",
    .label = "Mesh report...",
    .draw = [](App& app) { draw_mesh_report(*app.ui, app.viewer->view, app.shown->document, app.get<PanelsShown>()); },
    .guide = "Repair a mesh",
    .mark =
        [](const App& app, SceneInput& scene) {
          scene.repair_changes = app.viewer->mode == Mode::layout && app.get<MeshState>().shows_changes;
        },
    .dump = dump_mesh,
};

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

namespace taxel::studio {

/// The taxels stay where they are. Where there are none yet, there will be as many samples as before.
void carry_out(const ui::SetMeshUnit& command, Host& host) {
  edit_document(host, [&](EditSession& edits) {
    const Layout& layout = edits.project()->layout;
    ReplaceMesh replace{layout.mesh, *edits.project()->layout.sampling.region};
    const double ratio = command.metres / replace.mesh.scale.x;
    replace.mesh.scale = dvec3(command.metres);
    std::vector<Edit> steps;
    if (const OpenMeshPtr mesh = edits.mesh(); mesh && layout.taxels.empty()) {
      Sampling sampling = layout.sampling;
      sampling.density = density_for(mesh->loaded.mesh->area() * ratio * ratio);
      steps.emplace_back(SetSampling{sampling});
    }
    steps.emplace_back(replace);
    edits.edit_together(steps);
  });
}

void carry_out(const ui::PolishSamples&, Host& host) {
  polish(host);
}

}  // namespace taxel::studio
