// The cards of LAYOUT about the layouts of a scene, and the menus of lists of its sensors and geoms.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "app/studio/frame/app.h"
#include "app/studio/frame/shown_scene.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/nouns/files/document_commands.h"
#include "app/studio/nouns/scene/controls_state.h"
#include "app/studio/nouns/scene/scene_layouts.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"

namespace taxel::ui {
namespace {

constexpr float kLayoutCardWidth = 21, kMaxLayoutRows = 8;  // in heights of text, and in rows
constexpr auto kLayoutCardFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoDocking |
                                  ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoMove |
                                  ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing;

bool sensor_has_taxels(const SimScene& scene, std::size_t sensor) {
  return scene.sensors[sensor]->taxel_count() > 0;
}

/// Returns the name under which lists show a geom.
std::string shown_geom(const RunView& run, const std::string& name) {
  for (const SceneGeom& geom : run.frame->scene->geoms)
    if (geom.name == name) return geom.shown_name();
  return name;
}

bool has_sensor_with_taxels(const SimScene& scene) {
  for (std::size_t i = 0; i < scene.sensors.size(); ++i)
    if (sensor_has_taxels(scene, i)) return true;
  return false;
}

/// Begins a card of the view with its left edge next to the tools, and its upper or lower edge at `y`.
void begin_card(const WindowUi& ui, const ViewPlace& place, const char* title, float y, float pivot) {
  const float line = ImGui::GetFontSize();
  ImGui::SetNextWindowPos({place.rect.x0 + place.strip + 0.8f * line, y}, ImGuiCond_Always, {0, pivot});
  ImGui::PushStyleColor(ImGuiCol_WindowBg, palette(ui.dark).raised);
  ImGui::PushStyleColor(ImGuiCol_Button, palette(ui.dark).panel);  // the usual button colour equals the card's
  ImGui::Begin(title, nullptr, kLayoutCardFlags);
}

void end_card() {
  ImGui::End();
  ImGui::PopStyleColor(2);
}

/// Draws a row for each sensor with taxels.
void draw_sensor_rows(WindowUi& ui, Selection& selection, const RunView& run) {
  const SimScene& scene = *run.frame->scene;
  const auto count = std::count_if(scene.sensors.begin(), scene.sensors.end(),
                                   [](const SensorModelPtr& model) { return model->taxel_count() > 0; });
  const float rows = std::min(kMaxLayoutRows, static_cast<float>(count));
  const ImVec2 size(kLayoutCardWidth * ImGui::GetFontSize(), (rows + 0.5f) * ImGui::GetTextLineHeightWithSpacing());
  if (ImGui::BeginChild("layouts", size, ImGuiChildFlags_FrameStyle)) {
    for (std::size_t i = 0; i < scene.sensors.size(); ++i) {
      if (!sensor_has_taxels(scene, i)) continue;
      const int sensor = static_cast<int>(i);
      if (selectable(ui, fmt::format("{}##layout of{}", shown_geom(run, scene.sensor_geoms[i]), i).c_str(),
                     selection.sensor == sensor))
        selection = {sensor, {}, selection.body};
      offer_sensor(ui, selection, run, sensor);
      ImGui::SameLine();
      ImGui::TextDisabled("%d taxels", scene.sensors[i]->taxel_count());
    }
  }
  ImGui::EndChild();
}

/// Returns the geom on which a button makes a layout, or an empty text.
std::string chosen_geom(const ControlsState& controls) {
  return controls.geoms.empty() ? "" : controls.geoms.front();
}

void draw_actions(WindowUi& ui, const ControlsState& controls, const Selection& selection, const RunView& run) {
  const SimScene& scene = *run.frame->scene;
  const std::string geom = chosen_geom(controls);
  const ImVec2 width(kLayoutCardWidth * ImGui::GetFontSize(), 0);
  const std::string label = geom.empty()
                                ? "New layout on this geom"
                                : fmt::format("New layout on {}###New layout on this geom", shown_geom(run, geom));
  ImGui::BeginDisabled(geom.empty());
  if (button(ui, label.c_str(), width)) ui.post(NewLayoutOnGeom{geom});
  if (button(ui, "Attach a layout file...", width)) ui.post(AttachLayout{controls.geoms, ""});
  ImGui::EndDisabled();
  const auto sensor = static_cast<std::size_t>(selection.sensor);
  if (sensor < scene.sensors.size() && sensor_has_taxels(scene, sensor)) {
    if (button(ui, "Edit the selected layout", width)) ui.post(EditSensorLayout{});
    if (button(ui, "Attach to every geom of this mesh", width)) ui.post(AttachToSameMesh{});
    tooltip("The selected layout, to one geom with the same mesh on each other body");
  }
  if (button(ui, "Open a mesh or another file...", width)) ui.post(ShowOpenDialog{});
}

/// Draws the card of LAYOUT while no layout of the scene is edited: the layouts, and how to make one.
void draw_layouts_card(WindowUi& ui, Viewer& viewer, const RunView& run, const ControlsState& controls) {
  begin_card(ui, viewer.view, "Layouts of the scene", view_line_top(viewer.view, 0), 0);
  const bool any = has_sensor_with_taxels(*run.frame->scene);
  ImGui::PushTextWrapPos(kLayoutCardWidth * ImGui::GetFontSize());
  ImGui::TextUnformatted(any ? "Layouts of this scene" : "No geom of this scene has taxels yet");
  ui.widgets.note_item("Layouts of this scene");
  if (any) {
    draw_sensor_rows(ui, viewer.selection, run);
    ImGui::TextDisabled("Double-click or Enter edits a layout.");
  }
  if (controls.geoms.empty())
    ImGui::TextDisabled("Double-click a geom in the view, or click one in the outliner: then make a layout on it.");
  ImGui::PopTextWrapPos();
  draw_actions(ui, controls, viewer.selection, run);
  end_card();
}

/// Draws the card of LAYOUT while a layout of the scene is edited.
void draw_edited_card(WindowUi& ui, const Viewer& viewer, const DocumentView& document, const RunView& run) {
  const float line = ImGui::GetFontSize();
  begin_card(ui, viewer.view, "Edited layout", viewer.view.rect.y1 - 0.8f * line, 1);
  const std::vector<std::string>& geoms = document.scene_layout->geoms;
  const std::string others = geoms.size() > 1 ? fmt::format(" and {} more", geoms.size() - 1) : "";
  ImGui::Text("On %s%s", shown_geom(run, geoms.front()).c_str(), others.c_str());
  std::string all;
  for (const std::string& geom : geoms) all += (all.empty() ? "" : "\n") + shown_geom(run, geom);
  tooltip(all);
  if (button(ui, "Attach to every geom of this mesh")) ui.post(AttachToSameMesh{});
  tooltip("One geom with the same mesh on each other body gets this layout as well");
  ImGui::SameLine();
  if (button(ui, "All layouts")) ui.post(LeaveLayout{});
  tooltip("End editing, and show the layouts of the scene");
  end_card();
}

void draw_cards(App& app) {
  const Shown& shown = *app.shown;
  const bool is_drawn = app.viewer->mode == Mode::layout && shown.document.is_scene && shown.run.frame &&
                        shown.run.frame->scene && app.viewer->view.rect.width() > 0;
  if (!is_drawn) return;
  if (shown.document.scene_layout) {
    draw_edited_card(*app.ui, *app.viewer, shown.document, shown.run);
  } else {
    draw_layouts_card(*app.ui, *app.viewer, shown.run, app.get<ControlsState>());
  }
}

constexpr auto has_chosen_geom = [](const App& app) {
  return app.shown->document.is_scene && !app.get<ControlsState>().geoms.empty();
};
constexpr auto has_selected_layout = [](const App& app) {
  const Shown& shown = *app.shown;
  if (!shown.document.is_scene || !shown.run.frame || !shown.run.frame->scene) return false;
  const SimScene& scene = *shown.run.frame->scene;
  const auto sensor = static_cast<std::size_t>(app.viewer->selection.sensor);
  return shown.document.scene_layout || (sensor < scene.sensors.size() && sensor_has_taxels(scene, sensor));
};
constexpr auto edits_scene_layout = [](const App& app) { return app.shown->document.scene_layout.has_value(); };

std::vector<Binding> layout_commands() {
  constexpr const char* kMenu = "Edit/Layouts of the scene";
  std::vector<Binding> rows;
  const auto add = [&](Command command, const char* label, Binding::Test enabled, const char* needs) {
    Binding row{std::move(command), kEverywhere, 0, label, enabled};
    row.menu = kMenu;
    row.needs = needs;
    rows.push_back(std::move(row));
  };
  add(NewLayoutOnGeom{}, "New layout on this geom", has_chosen_geom, "Choose a geom of a scene first");
  add(EditSensorLayout{}, "Edit the layout of the selected sensor", has_selected_layout,
      "Open a scene and select a sensor first");
  add(AttachToSameMesh{}, "Attach to every geom of this mesh", has_selected_layout,
      "Open a scene and select a sensor first");
  add(LeaveLayout{}, "All layouts of the scene", edits_scene_layout, "No layout of a scene is being edited");
  return rows;
}

}  // namespace

void offer_sensor(WindowUi& ui, Selection& selection, const RunView& run, int sensor) {
  if (!sensor_has_taxels(*run.frame->scene, static_cast<std::size_t>(sensor))) return;
  const bool is_entered = ImGui::IsItemFocused() && (ImGui::IsKeyPressed(ImGuiKey_Enter, false) ||
                                                     ImGui::IsKeyPressed(ImGuiKey_KeypadEnter, false));
  const bool is_opened = ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
  if (is_entered || is_opened) ui.post(EditSensorLayout{sensor});
  if (!ImGui::BeginPopupContextItem()) return;
  selection.sensor = sensor;
  if (menu_item(ui, "Edit this layout", "", false)) ui.post(EditSensorLayout{sensor});
  if (menu_item(ui, "Attach to every geom of this mesh", "", false)) ui.post(AttachToSameMesh{});
  ImGui::EndPopup();
}

void offer_geom(WindowUi& ui, ControlsState& controls, const SceneGeom& geom) {
  if (!ImGui::BeginPopupContextItem()) return;
  controls.geoms = {geom.name};
  if (menu_item(ui, "New layout on this geom", "", false)) ui.post(NewLayoutOnGeom{geom.name});
  if (menu_item(ui, "Attach a layout file...", "", false)) ui.post(AttachLayout{{geom.name}, ""});
  ImGui::EndPopup();
}

constinit const Feature kSceneLayouts{
    .draw_card = draw_cards,
    .commands = layout_commands,
    .dump = dump_scene_layout,
};

}  // namespace taxel::ui
