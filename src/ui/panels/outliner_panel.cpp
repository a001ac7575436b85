#include "ui/panels/outliner_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include "ui/panels/dock_layout.h"
#include "ui/tools/actions.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/format.h"

namespace taxel::ui {

namespace {

constexpr auto kOpenNode = ImGuiTreeNodeFlags_DefaultOpen | ImGuiTreeNodeFlags_SpanAvailWidth;
constexpr auto kLeafNode =
    ImGuiTreeNodeFlags_Leaf | ImGuiTreeNodeFlags_NoTreePushOnOpen | ImGuiTreeNodeFlags_SpanAvailWidth;

void leaf(const std::string& text, const std::string& detail) {
  ImGui::TreeNodeEx(text.c_str(), kLeafNode);
  if (detail.empty()) return;
  ImGui::SameLine();
  ImGui::TextDisabled("%s", detail.c_str());
}

void draw_sensor(UiState& ui, const SensorModel& model, const std::string& name) {
  const bool open = ImGui::TreeNodeEx(name.c_str(), kOpenNode);
  ui.widgets.note_item(name);
  if (!open) return;
  leaf("Mesh", fmt::format("{} triangles", grouped(model.mesh->face_count())));
  if (model.mesh->shell_count() > 1) leaf("Shells", std::to_string(model.mesh->shell_count()));
  leaf("Taxels", std::to_string(model.taxel_count()));
  leaf("Samples", grouped(static_cast<long long>(model.samples.size())));
  leaf("Rays", grouped(static_cast<long long>(model.rays.size())));
  ImGui::TreePop();
}

void draw_scene(UiState& ui, const UiInput& input) {
  const SimScene& scene = *input.frame->scene;
  if (!ImGui::TreeNodeEx("Scene", kOpenNode)) return;
  for (std::size_t i = 0; i < scene.sensors.size(); ++i) {
    const std::string geom = i < scene.sensor_geoms.size() ? scene.sensor_geoms[i] : fmt::format("sensor {}", i);
    const std::string label = fmt::format("{}##sensor{}", geom, i);
    if (selectable(ui, label.c_str(), ui.selection.sensor == static_cast<int>(i)) &&
        ui.selection.sensor != static_cast<int>(i)) {
      ui.selection = {static_cast<int>(i), {}};
    }
    ImGui::SameLine();
    ImGui::TextDisabled("sensor, %d taxels", scene.sensors[i]->taxel_count());
  }
  for (const SceneGeom& geom : scene.geoms) {
    if (geom.sensor < 0) leaf(geom.name.empty() ? "(unnamed)" : geom.name, geom.plane ? "plane" : "geom");
  }
  ImGui::TreePop();
}

}  // namespace

void draw_outliner(UiState& ui, const UiInput& input) {
  if (begin_panel(ui, kOutlinerTitle, &ui.saved.panels.outliner)) {
    if (input.model) draw_sensor(ui, *input.model, input.name.empty() ? "layout" : input.name);
    if (input.frame && input.frame->scene) draw_scene(ui, input);
    if (!input.model && !input.frame) ImGui::TextDisabled("Nothing is open.");
  }
  ImGui::End();
}

}  // namespace taxel::ui
