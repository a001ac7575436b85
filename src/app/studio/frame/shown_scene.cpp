#include "app/studio/frame/shown_scene.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/sensors_shown.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_state.h"
#include "app/studio/frame/window_ui.h"
#include "ui/scene/camera.h"
#include "ui/scene/scene_input.h"
#include "ui/theme.h"

namespace taxel::ui {
namespace {

bool has_simulated_scene(const Viewer& viewer, const Shown& shown) {
  return shown.shows_scene(viewer) && shown.run.frame && shown.run.frame->scene;
}

void include_mesh(Aabb& box, const TriMesh& mesh, const Pose& X_WM) {
  const RigidTransform transform(X_WM);
  for (const dvec3& p : mesh.vertices()) box.include(transform(p));
}

/// Sets the taxel under the pointer: the one whose centre is there, or the nearest one of the sample that is there.
void set_hovered(const App& app, SceneInput& scene) {
  if (!app.viewer->hovered || scene.overlays.all_taxels) return;
  const Pick& under = *app.viewer->hovered;
  const auto sensor = static_cast<std::size_t>(under.sensor);
  SensorModelPtr model = scene.document_model;
  if (scene.frame && scene.frame->scene)
    model = under.sensor >= 0 && sensor < scene.frame->scene->sensors.size() ? scene.frame->scene->sensors[sensor]
                                                                             : nullptr;
  if (!model || under.sensor < 0) return;
  const auto sample = static_cast<std::size_t>(under.sample);
  if (under.taxel >= 0) {
    scene.hovered_taxel = under.taxel;
  } else if (under.sample >= 0 && sample < model->taxels_of_sample.size() && !model->taxels_of_sample[sample].empty()) {
    scene.hovered_taxel = model->taxels_of_sample[sample].front();
  }
  if (scene.hovered_taxel >= 0) scene.hovered_sensor = under.sensor;
}

/// Returns the overlays of a scene that LAYOUT displays while no layout is edited: those of SIMULATE without its
/// contact.
Overlays without_contact(Overlays shown) {
  for (bool Overlays::*overlay :
       {&Overlays::rays, &Overlays::all_rays, &Overlays::contact_surface, &Overlays::contact_edges, &Overlays::slip_map,
        &Overlays::tractions, &Overlays::ghost, &Overlays::filtered_polygons, &Overlays::path,
        &Overlays::readings_on_skin, &Overlays::reading_discs})
    shown.*overlay = false;
  return shown;
}

/// Removes the marks of tools that are only for work on the scene.
void leave_out_tools(SceneInput& scene) {
  scene.has_gizmo = false;
  scene.overlays.constraints = false;
  scene.measure_points.clear();
  scene.measured.reset();
  if (!scene.path) return;
  scene.path->points_W.clear();
  scene.path->selected = -1;
}

}  // namespace

std::optional<Surroundings> surroundings(const Viewer& viewer, const Shown& shown) {
  if (viewer.mode != Mode::layout || !shown.document.scene_layout || !shown.run.frame || !shown.run.frame->scene)
    return std::nullopt;
  const std::vector<SceneGeom>& geoms = shown.run.frame->scene->geoms;
  const std::vector<Pose>& X_WG = shown.run.frame->geom_poses;
  for (std::size_t g = 0; g < geoms.size() && g < X_WG.size(); ++g)
    if (geoms[g].name == shown.document.scene_layout->geoms.front())
      return Surroundings{shown.run.frame, (X_WG[g] * geoms[g].skin.X_GM).inverse(), geoms[g].body_index};
  return std::nullopt;
}

SceneInput scene_input(const App& app) {
  SceneInput scene;
  const bool shows_scene = app.shown->shows_scene(*app.viewer);
  scene.surroundings = surroundings(*app.viewer, *app.shown);
  if (shows_scene) scene.frame = app.shown->run.frame;
  scene.document_model = app.shown->document.model;
  if (app.viewer->mode == Mode::layout) scene.probe = app.shown->document.probe;
  scene.clip = app.viewer->clip;
  scene.fields = app.shown->document.fields;
  scene.overlays = app.viewer->mode_overlays[shows_scene ? 1 : 0];
  if (shows_scene && app.viewer->mode == Mode::layout) scene.overlays = without_contact(scene.overlays);
  // The presentation has the legend of one range, that of the surface.
  if (app.get<WindowParts>().is_presenting && !shares_range(*app.viewer, *app.shown))
    scene.overlays.reading_discs = false;
  scene.range = app.viewer->range;
  scene.reading_range = reading_range(*app.viewer, *app.shown);
  scene.selected_sensor = shows_scene ? app.viewer->selection.sensor : 0;
  scene.selected_body = shows_scene ? app.viewer->selection.body : -1;
  if (const SensorModelPtr model = app.shown->model(*app.viewer)) {
    scene.selected_taxel = active_index(app.viewer->selection, model->layout);
    scene.selected_taxels = selected_indices(app.viewer->selection, model->layout);
  }
  set_hovered(app, scene);
  if (app.viewer->mode == Mode::layout && app.shown->document.editing.project && app.shown->document.model) {
    for (const int id : app.shown->document.editing.project->hidden) {
      if (const int index = index_of(app.shown->document.model->layout, id); index >= 0)
        scene.hidden_taxels.push_back(index);
    }
    std::sort(scene.hidden_taxels.begin(), scene.hidden_taxels.end());
  }
  if (app.viewer->mode == Mode::layout && app.shown->document.editing.project)
    scene.region = app.shown->document.editing.project->layout.sampling.region;
  scene.dark = app.ui->dark;
  scene.scale = app.ui->pixel_scale;
  for (const Feature* row : features())
    if (row->mark != nullptr) row->mark(app, scene);
  if (app.get<WindowParts>().is_presenting) leave_out_tools(scene);
  return scene;
}

void toggle_clip(Viewer& viewer, const Shown& shown) {
  const Aabb box = scene_box(viewer, shown);
  if (viewer.clip || box.empty()) return viewer.clip.reset();
  const Camera& camera = viewer.camera();
  const dvec3 towards_eye = glm::normalize(camera.eye() - camera.target);
  viewer.clip = ClipPlane{towards_eye, glm::dot(towards_eye, box.center())};
}

Pose shown_pose(const Viewer& viewer, const Shown& shown) {
  const SensorStep* sensor = shown.shows_scene(viewer) ? shown.sensor(viewer) : nullptr;
  return sensor != nullptr ? sensor->X_WM : Pose{};
}

Aabb scene_box(const Viewer& viewer, const Shown& shown) {
  Aabb box;
  if (!has_simulated_scene(viewer, shown)) {
    if (shown.document.model) box = shown.document.model->mesh->bounds();
    return box;
  }
  const SimScene& scene = *shown.run.frame->scene;
  for (std::size_t i = 0; i < scene.sensors.size() && i < shown.run.frame->sensors.size(); ++i) {
    include_mesh(box, *scene.sensors[i]->mesh, shown.run.frame->sensors[i].X_WM);
  }
  for (const dvec3& p : scene.path_W) box.include(p);
  if (!scene.path_W.empty()) return box;
  const Aabb sensors = box;
  for (std::size_t i = 0; i < scene.geoms.size() && i < shown.run.frame->geom_poses.size(); ++i) {
    if (!scene.geoms[i].plane && scene.geoms[i].mesh && shows(viewer.overlays(), scene.geoms[i]))
      include_mesh(box, *scene.geoms[i].mesh, shown.run.frame->geom_poses[i]);
  }
  constexpr double kMuchLarger = 5;  // a room around a robot hand
  return !sensors.empty() && box.diagonal() > kMuchLarger * sensors.diagonal() ? sensors : box;
}

Aabb contact_box(const Viewer& viewer, const Shown& shown, int sensor) {
  Aabb box;
  const auto include = [&](const SensorStep& state, const Pose& X_WM) {
    for (const ContactSurface& surface : state.surfaces)
      for (const dvec3& p_M : surface.vertices) box.include(X_WM * p_M);
  };
  if (has_simulated_scene(viewer, shown)) {
    const std::vector<SensorStep>& states = shown.run.frame->sensors;
    for (std::size_t s = 0; s < states.size(); ++s)
      if (sensor < 0 || s == static_cast<std::size_t>(sensor)) include(states[s], states[s].X_WM);
  } else if (const SensorStep* probed = shown.state(viewer)) {
    include(*probed, shown_pose(viewer, shown));
  }
  if (box.empty()) return box;
  constexpr double kRoom = 0.2;  // around the contact, in diagonals of its box
  const dvec3 room(kRoom * box.diagonal());
  return {box.lo - room, box.hi + room};
}

Aabb selection_box(const Viewer& viewer, const Shown& shown) {
  const int chosen = viewer.selection.is_sensor_chosen ? viewer.selection.sensor : -1;
  Aabb box;
  for (const int sensor : {chosen, -1})
    if (viewer.selection.empty() && box.empty()) box = contact_box(viewer, shown, sensor);
  if (!box.empty()) return box;
  const SensorModelPtr model = shown.model(viewer);
  if (!model) return box;
  if (viewer.selection.empty() && has_simulated_scene(viewer, shown)) {
    const std::vector<SensorStep>& states = shown.run.frame->sensors;
    for (std::size_t s = 0; s < states.size() && s < shown.run.frame->scene->sensors.size(); ++s)
      if (chosen < 0 || s == static_cast<std::size_t>(chosen))
        include_mesh(box, *shown.run.frame->scene->sensors[s]->mesh, states[s].X_WM);
  }
  for (const int index : selected_indices(viewer.selection, model->layout)) {
    const Taxel& taxel = model->layout.taxels[static_cast<std::size_t>(index)];
    const dvec3 center_W = shown_pose(viewer, shown) * taxel.center;
    box.include(center_W - dvec3(taxel.radius));
    box.include(center_W + dvec3(taxel.radius));
  }
  return box;
}

ImVec2 on_screen(const Viewer& viewer, const dvec3& p_W) {
  const dvec3 pixel = viewer.project(p_W);
  return {viewer.view.rect.x0 + static_cast<float>(pixel.x), viewer.view.rect.y0 + static_cast<float>(pixel.y)};
}

float view_line_top(const ViewPlace& place, int row) {
  const float line = ImGui::GetFontSize();
  return std::round(place.rect.y0 + 2.9f * line + 1.7f * line * static_cast<float>(row));
}

void draw_view_line(const WindowUi& ui, const ViewPlace& place, ImDrawList& list, int row, const std::string& text,
                    const ImVec4& color) {
  const float line = ImGui::GetFontSize();
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  const ImVec2 at(place.rect.x0 + place.strip + 0.8f * line, view_line_top(place, row));
  list.AddRectFilled({at.x - 6, at.y - 3}, {at.x + size.x + 6, at.y + size.y + 3},
                     to_u32(palette(ui.dark).panel, 0.85f), 3);
  list.AddText(at, to_u32(color), text.c_str());
}

int draw_view_name(const WindowUi& ui, const Viewer& viewer, ImDrawList& list, int row) {
  std::string name = standard_view_name(viewer.camera());
  if (viewer.camera().orthographic) name += name.empty() ? "Orthographic" : ", orthographic";
  if (name.empty()) return row;
  draw_view_line(ui, viewer.view, list, row, name, palette(ui.dark).text);
  return row + 1;
}

namespace {

constexpr const char *kViewOverlays = "View", *kContactOverlays = "View/Contact and rays",
                     *kTaxelsOverlays = "View/Taxels and fields", *kSceneOverlays = "View/Frames and labels";
constexpr std::array kOverlayRows = {
    OverlaySpec{"sensor_transparent", kViewOverlays, "X-ray", &Overlays::sensor_transparent, ImGuiKey_T},
    OverlaySpec{"wireframe", kViewOverlays, "Wireframe", &Overlays::wireframe, ImGuiKey_W},
    OverlaySpec{"rays", kContactOverlays, "Rays", &Overlays::rays, ImGuiKey_Y},
    OverlaySpec{"all_rays", kContactOverlays, "Rays of all taxels", &Overlays::all_rays},
    OverlaySpec{"contact_surface", kContactOverlays, "Contact surface", &Overlays::contact_surface, ImGuiKey_C},
    OverlaySpec{"contact_edges", kContactOverlays, "Contact edges", &Overlays::contact_edges},
    OverlaySpec{"slip_map", kContactOverlays, "Slip map of the contact", &Overlays::slip_map},
    OverlaySpec{"tractions", kContactOverlays, "Traction arrows", &Overlays::tractions, ImGuiKey_V},
    OverlaySpec{"ghost", kContactOverlays, "Onion skin (previous step)", &Overlays::ghost, 0, kSimulate},
    OverlaySpec{"filtered_polygons", kContactOverlays, "Filtered polygons", &Overlays::filtered_polygons},
    OverlaySpec{"taxels", kTaxelsOverlays, "Taxels", &Overlays::taxels},
    OverlaySpec{"taxel_labels", kTaxelsOverlays, "Taxel labels", &Overlays::taxel_labels},
    OverlaySpec{"all_taxels", kTaxelsOverlays, "Marks of all taxels", &Overlays::all_taxels},
    OverlaySpec{"receptive_fields", kTaxelsOverlays, "Receptive fields", &Overlays::receptive_fields},
    OverlaySpec{"fields_filled", kTaxelsOverlays, "Fields filled", &Overlays::fields_filled},
    OverlaySpec{"fields_compared", kTaxelsOverlays, "Receptive fields: Euclidean vs. geodesic",
                &Overlays::fields_compared},
    OverlaySpec{"readings_on_skin", kTaxelsOverlays, "Readings on the skin", &Overlays::readings_on_skin, ImGuiKey_S},
    OverlaySpec{"reading_discs", kTaxelsOverlays, "Readings on the receptive fields", &Overlays::reading_discs},
    OverlaySpec{"samples", kTaxelsOverlays, "Samples", &Overlays::samples, ImGuiKey_P},
    OverlaySpec{"sample_normals", kTaxelsOverlays, "Sample normals", &Overlays::sample_normals, ImGuiKey_N},
    OverlaySpec{"coverage", kTaxelsOverlays, "Coverage and overlap", &Overlays::coverage},
    OverlaySpec{"normal_angles", kTaxelsOverlays, "Normal deviation", &Overlays::normal_angles},
    OverlaySpec{"path", kSceneOverlays, "Path", &Overlays::path},
    OverlaySpec{"constraints", kSceneOverlays, "Welds and connections", &Overlays::constraints},
    OverlaySpec{"grid", kSceneOverlays, "Ground grid", &Overlays::grid},
    OverlaySpec{"scene_grid", kSceneOverlays, "Ground grid in scenes", &Overlays::scene_grid, 0, kSimulate},
};

}  // namespace

std::span<const OverlaySpec> overlays() {
  return kOverlayRows;
}

}  // namespace taxel::ui
