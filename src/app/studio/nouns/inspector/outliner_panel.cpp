// The outliner: a tree of the document's sensor and of the bodies of the running scene.
#include "app/studio/nouns/inspector/inspector_state.h"

#include <fmt/format.h>
#include <imgui.h>
#include <misc/cpp/imgui_stdlib.h>

#include <algorithm>
#include <utility>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/scene_filter.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/scene/controls_state.h"
#include "app/studio/nouns/scene/scene_layouts.h"
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

/// Draws the row of a taxel, with the taxel's subtaxels below it.
void draw_taxel(WindowUi& ui, Selection& selection, const Taxel& taxel) {
  const bool bare = taxel.subtaxels.empty();
  auto flags =
      ImGuiTreeNodeFlags_SpanAvailWidth | ImGuiTreeNodeFlags_OpenOnArrow | ImGuiTreeNodeFlags_OpenOnDoubleClick;
  if (bare) flags |= ImGuiTreeNodeFlags_Leaf | ImGuiTreeNodeFlags_NoTreePushOnOpen;
  if (selection.contains(taxel.id)) flags |= ImGuiTreeNodeFlags_Selected;
  const std::string name = fmt::format("{}{}{}", taxel.id, taxel.name.empty() ? "" : "  ", taxel.name);
  const bool open = ImGui::TreeNodeEx(fmt::format("{}##taxel{}", name, taxel.id).c_str(), flags);
  if (ImGui::IsItemClicked() && !ImGui::IsItemToggledOpen()) click_taxel(selection, taxel.id, ImGui::GetIO().KeyShift);
  ui.widgets.note_item(fmt::format("Node of taxel {}", taxel.id));
  if (!open || bare) return;
  for (std::size_t i = 0; i < taxel.subtaxels.size(); ++i) {
    ImGui::TreeNodeEx(fmt::format("Subtaxel {}   {}", i, in_mm(taxel.subtaxels[i].radius)).c_str(), kLeafNode);
    ui.widgets.note_item(fmt::format("Subtaxel {} of taxel {}", i, taxel.id));
    if (ImGui::IsItemClicked()) click_taxel(selection, taxel.id, false);
  }
  ImGui::TreePop();
}

void draw_taxels(WindowUi& ui, Selection& selection, const Layout& layout) {
  const std::string title = fmt::format("Taxels  {}##taxels", layout.taxels.size());
  const bool open = ImGui::TreeNodeEx(title.c_str(), ImGuiTreeNodeFlags_SpanAvailWidth);
  ui.widgets.note_item("Taxels of the layout");
  if (!open) return;
  for (const Taxel& taxel : layout.taxels) draw_taxel(ui, selection, taxel);
  ImGui::TreePop();
}

void draw_sensor(WindowUi& ui, Selection& selection, const SensorModel& model, const Layout& layout,
                 const std::string& name) {
  const bool open = ImGui::TreeNodeEx(name.c_str(), kOpenNode);
  ui.widgets.note_item(name);
  if (!open) return;
  leaf("Mesh", fmt::format("{} triangles", grouped(model.mesh->face_count())));
  if (model.mesh->shell_count() > 1) leaf("Shells", std::to_string(model.mesh->shell_count()));
  draw_taxels(ui, selection, layout);
  leaf("Samples", grouped(static_cast<long long>(model.samples.size())));
  leaf("Rays", grouped(static_cast<long long>(model.rays.size())));
  ImGui::TreePop();
}

/// Scrolls to the row that was drawn last, if it is the first one of a body that was selected elsewhere.
class ScrollToBody {
 public:
  ScrollToBody(int& shown, int selected) : body_(std::exchange(shown, selected) != selected ? selected : -1) {}
  void row(int body) {
    if (body_ < 0 || body != body_) return;
    ImGui::SetScrollHereY();
    body_ = -1;
  }

 private:
  int body_;
};

void draw_scene_sensor(WindowUi& ui, Selection& selection, int& shown_body, const RunView& run, int sensor) {
  const SimScene& scene = *run.frame->scene;
  const auto i = static_cast<std::size_t>(sensor);
  const std::string name = i < scene.sensor_geoms.size() ? scene.sensor_geoms[i] : fmt::format("sensor {}", i);
  if (selectable(ui, fmt::format("{}##sensor{}", name, i).c_str(), selection.sensor == sensor)) {
    const int body = body_of_sensor(scene, sensor);
    if (selection.sensor != sensor) selection = {sensor, {}, body > 0 ? body : -1};
    selection.is_sensor_chosen = true;
    shown_body = selection.body;
  }
  offer_sensor(ui, selection, run, sensor);
  ImGui::SameLine();
  if (scene.sensors[i]->taxel_count() > 0) {
    ImGui::TextDisabled("sensor, %d taxels", scene.sensors[i]->taxel_count());
  } else {
    ImGui::TextDisabled("soft, no taxels");
  }
}

/// Draws the row of a geom without a sensor. A click chooses the geom for a layout and selects its body.
void draw_geom_node(WindowUi& ui, Selection& selection, ControlsState& controls, const SceneGeom& geom) {
  const bool is_chosen = std::find(controls.geoms.begin(), controls.geoms.end(), geom.name) != controls.geoms.end();
  const std::string label = geom.name.empty() ? "(unnamed)" : geom.shown_name();
  if (selectable(ui, fmt::format("{}##geom of {}", label, geom.body).c_str(), is_chosen)) {
    controls.geoms = {geom.name};
    selection.body = geom.body_index > 0 ? geom.body_index : -1;
    controls.outlined_body = selection.body;
  }
  offer_geom(ui, controls, geom);
  ImGui::SameLine();
  ImGui::TextDisabled("%s", geom.plane ? "plane" : geom.mesh_name.empty() ? "geom" : geom.mesh_name.c_str());
}

void draw_scene_tree(WindowUi& ui, Selection& selection, ControlsState& controls, const RunView& run) {
  constexpr std::size_t kFewRows = 8;  // largest number of rows that need no filter
  const SimScene& scene = *run.frame->scene;
  if (!ImGui::TreeNodeEx("Scene", kOpenNode)) return;
  if (scene.geoms.size() > kFewRows) {
    ImGui::SetNextItemWidth(-1);
    ImGui::InputTextWithHint("##outliner filter", "Filter: body, mesh, joint, site", &controls.filter);
    ui.widgets.note_item("Filter the outliner", true);
  }
  ScrollToBody scroll(controls.outlined_body, selection.body);
  for (std::size_t i = 0; i < scene.sensors.size(); ++i) {
    const int body = body_of_sensor(scene, static_cast<int>(i));
    if (!finds_sensor(controls.filter, scene, i)) continue;
    draw_scene_sensor(ui, selection, controls.outlined_body, run, static_cast<int>(i));
    scroll.row(body);
  }
  for (const SceneGeom& geom : scene.geoms) {
    if (geom.sensor >= 0 || !finds_geom(controls.filter, scene, geom)) continue;
    draw_geom_node(ui, selection, controls, geom);
    scroll.row(geom.body_index);
  }
  ImGui::TreePop();
}

void draw_outliner(WindowUi& ui, Selection& selection, ControlsState& controls, const Shown& shown,
                   PanelsShown& panels) {
  if (begin_panel(ui, kOutliner.title, &panels[kOutliner])) {
    if (shown.document.model) {
      const Layout& layout =
          shown.document.editing.project ? shown.document.editing.project->layout : shown.document.model->layout;
      draw_sensor(ui, selection, *shown.document.model, layout,
                  shown.document.name.empty() ? "layout" : shown.document.name);
    }
    if (shown.run.frame && shown.run.frame->scene) draw_scene_tree(ui, selection, controls, shown.run);
    if (!shown.document.model && !shown.run.frame) ImGui::TextDisabled("%s", shown.empty_text());
  }
  ImGui::End();
}

}  // namespace

constinit const Feature kOutliner{
    .title = "Outliner",
    .dock = Dock::outline,
    .opens = Opens::by_user,
    .open = true,
    .key = "panel_outliner",
    .label = "Outliner",
    .draw =
        [](App& app) {
          draw_outliner(*app.ui, app.viewer->selection, app.get<ControlsState>(), *app.shown, app.get<PanelsShown>());
        },
    .guide = "Place taxels on a robot of your own",
};

}  // namespace taxel::ui
