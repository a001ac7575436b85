#include "app/studio/nouns/mesh/mesh_section.h"

#include <fmt/format.h>
#include <imgui.h>

#include <array>
#include <cmath>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/camera/frame_tool.h"
#include "app/studio/nouns/mesh/mesh_commands.h"
#include "app/studio/nouns/mesh/mesh_state.h"
#include "app/studio/nouns/mesh/repair_section.h"
#include "ui/scene/scene_input.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"
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

struct Axis {
  const char* name;
  dvec3 direction;
};
const std::array<Axis, 6> kAxes{Axis{"+x", {1, 0, 0}}, {"-x", {-1, 0, 0}}, {"+y", {0, 1, 0}},
                                {"-y", {0, -1, 0}},    {"+z", {0, 0, 1}},  {"-z", {0, 0, -1}}};

std::string axis_name(const dvec3& direction) {
  for (const Axis& axis : kAxes) {
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

constinit const Feature kMeshReport{
    .title = "Mesh report",
    .dock = Dock::floating,
    .opens = Opens::by_user,
    .key = "panel_mesh_report",
    .label = "Mesh report...",
    .draw = [](App& app) { draw_mesh_report(*app.ui, app.viewer->view, app.shown->document, app.get<PanelsShown>()); },
    .mark =
        [](const App& app, SceneInput& scene) {
          scene.repair_changes = app.viewer->mode == Mode::layout && app.get<MeshState>().shows_changes;
        },
    .dump = dump_mesh,
};

}  // namespace taxel::ui
