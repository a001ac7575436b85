#include "app/studio/nouns/scene/attach_section.h"

#include <fmt/format.h>
#include <imgui.h>
#include <misc/cpp/imgui_stdlib.h>

#include <algorithm>

#include "app/studio/nouns/files/document_commands.h"
#include "app/studio/nouns/scene/scene_commands.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/format.h"

namespace taxel::ui {

namespace {

constexpr std::size_t kFewGeoms = 8;  // largest number of geoms that need no filter
constexpr float kMostRows = 7;        // largest number of rows before the list scrolls

const SceneAttachment* attachment_on(const RunView& run, const std::string& geom) {
  const auto found = std::find_if(run.attached.begin(), run.attached.end(),
                                  [&](const SceneAttachment& attached) { return attached.geom == geom; });
  return found != run.attached.end() ? &*found : nullptr;
}

void draw_sensors(WindowUi& ui, Selection& selection, const RunView& run) {
  const SimScene& scene = *run.frame->scene;
  if (scene.sensors.empty()) ImGui::TextDisabled("None yet: choose a geom, attach a layout.");
  for (std::size_t i = 0; i < scene.sensors.size(); ++i) {
    const std::string& geom = scene.sensor_geoms[i];
    const SceneAttachment* attached = attachment_on(run, geom);
    ImGui::AlignTextToFramePadding();
    if (selectable(ui, fmt::format("{}##sensor of{}", geom, i).c_str(), selection.sensor == static_cast<int>(i),
                   ImGuiSelectableFlags_AllowOverlap) &&
        selection.sensor != static_cast<int>(i))
      selection = {static_cast<int>(i), {}, selection.body};
    if (attached != nullptr) tooltip(attached->layout);
    ImGui::SameLine();
    if (scene.sensors[i]->taxel_count() > 0) {
      ImGui::TextDisabled("%d taxels, %s", scene.sensors[i]->taxel_count(),
                          attached != nullptr ? "attached" : "declared");
    } else {
      ImGui::TextDisabled("soft, no taxels");
    }
    if (attached == nullptr) continue;
    ImGui::SameLine();
    if (button(ui, fmt::format("Detach##{}", geom).c_str())) ui.post(DetachLayout{geom});
    ui.widgets.note_item("Detach " + geom);
  }
}

/// Returns whether the geom carries no layout yet. The geom may be soft.
bool takes_layout(const SimScene& scene, const SceneGeom& geom) {
  return geom.sensor < 0 || scene.sensors[static_cast<std::size_t>(geom.sensor)]->taxel_count() == 0;
}

void choose(std::vector<std::string>& geoms, const std::string& geom) {
  const auto found = std::find(geoms.begin(), geoms.end(), geom);
  if (found == geoms.end()) {
    geoms.push_back(geom);
  } else {
    geoms.erase(found);
  }
}

/// Draws the geoms without a sensor. A click chooses a geom, and a second click removes it from the choice.
void draw_geoms(WindowUi& ui, ControlsState& controls, const SimScene& scene) {
  if (scene.geoms.size() > kFewGeoms) {
    ImGui::SetNextItemWidth(-1);
    ImGui::InputTextWithHint("##geom filter", "Filter geoms", &controls.filter);
    ui.widgets.note_item("Filter geoms", true);
  }
  const float rows = std::min(kMostRows, static_cast<float>(scene.geoms.size()));
  if (ImGui::BeginChild("geoms", ImVec2(0, (rows + 0.5f) * ImGui::GetTextLineHeightWithSpacing()),
                        ImGuiChildFlags_FrameStyle)) {
    for (const SceneGeom& geom : scene.geoms) {
      if (!takes_layout(scene, geom) || geom.plane || !contains_word(geom.name, controls.filter)) continue;
      const bool chosen = std::find(controls.geoms.begin(), controls.geoms.end(), geom.name) != controls.geoms.end();
      if (selectable(ui, fmt::format("{}##geom", geom.name).c_str(), chosen)) choose(controls.geoms, geom.name);
      ImGui::SameLine();
      ImGui::TextDisabled("%s", geom.body.c_str());
    }
  }
  ImGui::EndChild();
}

void draw_attach(WindowUi& ui, const RunView& run, ControlsState& controls) {
  const SimScene& scene = *run.frame->scene;
  std::erase_if(controls.geoms, [&](const std::string& name) {
    return std::none_of(scene.geoms.begin(), scene.geoms.end(),
                        [&](const SceneGeom& geom) { return geom.name == name && takes_layout(scene, geom); });
  });
  const auto flags = scene.sensors.empty() ? ImGuiTreeNodeFlags_DefaultOpen : ImGuiTreeNodeFlags_None;
  if (!ImGui::TreeNodeEx("Attach a layout##section", flags)) {
    ui.widgets.note_item("Attach a layout");
    return;
  }
  ui.widgets.note_item("Attach a layout");
  draw_geoms(ui, controls, scene);
  const std::size_t chosen = controls.geoms.size();
  ImGui::BeginDisabled(chosen == 0);
  const std::string label =
      chosen > 1 ? fmt::format("Attach a layout to {} geoms...###Attach", chosen) : "Attach a layout...###Attach";
  if (button(ui, label.c_str(), ImVec2(-1, 0))) ui.post(AttachLayout{controls.geoms, ""});
  ImGui::EndDisabled();
  ImGui::TreePop();
}

void draw_save(WindowUi& ui) {
  if (button(ui, "Save scene as...", ImVec2(-1, 0))) ui.post(SaveScene{});
  tooltip("A copy with its sensors declared, as any program with MuJoCo and the plugin reads it");
}

}  // namespace

void draw_attach_section(WindowUi& ui, Selection& selection, const RunView& run, ControlsState& controls) {
  if (!header(ui, "Sensors")) return;
  draw_sensors(ui, selection, run);
  draw_attach(ui, run, controls);
  draw_save(ui);
}

}  // namespace taxel::ui
