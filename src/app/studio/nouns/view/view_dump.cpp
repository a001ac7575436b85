// The marks and numbers of the 3-D view in the state of the window.
#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/sensors_shown.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/shown_scene.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/nouns/view/view_state.h"
#include "app/vector_json.h"
#include "ui/scene/color_map.h"
#include "ui/scene/marks/marks.h"

namespace taxel::ui {

namespace {

using Json = nlohmann::ordered_json;

/// Maximum number of skin points in the dump, spread evenly: enough to compare with the frame.
constexpr std::size_t kMostPoints = 400;

Json color_json(const PressureRange& range, double value) {
  const glm::vec3 color = range.color(value);
  return {color.x, color.y, color.z};
}

Json tractions_json(const FieldNumbers& numbers) {
  if (!numbers.tractions) return nullptr;
  const TractionNumbers& t = *numbers.tractions;
  return {{"polygons", t.polygons},
          {"largest_pressure", t.largest_pressure},
          {"largest_friction", t.largest_friction},
          {"metres_per_pascal", t.metres_per_pascal},
          {"friction_known", t.friction_known}};
}

/// Returns the pixels and readings at the centers of triangles of the coloured skin.
Json skin_json(const App& app) {
  const SensorModelPtr model = app.shown->model(*app.viewer);
  const SensorStep* state = app.shown->state(*app.viewer);
  if (!app.viewer->overlays().readings_on_skin || !model || state == nullptr || !app.shown->document.fields)
    return nullptr;
  const SensorFields* fields = app.shown->document.fields->of(model);
  if (fields == nullptr || !fields->weights) return nullptr;
  const SkinWeights& skin = *fields->weights;
  std::vector<float> values;
  skin.spread(state->readings, values);
  const Pose X_WM = shown_pose(*app.viewer, *app.shown);
  const PressureRange range = reading_range(*app.viewer, *app.shown);
  Json points = Json::array();
  const std::size_t stride = 1 + skin.triangles.size() / kMostPoints;
  for (std::size_t t = 0; t < skin.triangles.size(); t += stride) {
    dvec3 corners[3];
    double value = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const auto i = static_cast<std::size_t>(skin.triangles[t][c]);
      corners[c] = X_WM * dvec3(skin.points[i]);
      value += static_cast<double>(values[i]) / 3.0;
    }
    const dvec3 middle = (corners[0] + corners[1] + corners[2]) / 3.0;
    const dvec3 pixel = app.viewer->project(middle);
    const dvec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    points.push_back({{"pixel",
                       {pixel.x + static_cast<double>(app.viewer->view.rect.x0),
                        pixel.y + static_cast<double>(app.viewer->view.rect.y0)}},
                      {"depth", pixel.z},
                      {"facing", glm::dot(normal, app.viewer->camera().eye() - middle) > 0},
                      {"value", value},
                      {"color", color_json(range, value)}});
  }
  return {{"triangles", skin.triangles.size()}, {"largest", range.hi}, {"points", std::move(points)}};
}

/// Returns the numbers of drawn marks.
Json marks_json(const App& app) {
  const MarkCounts& marks = app.get<ViewShown>().numbers.marks;
  const std::vector<SceneLabel>& labels = app.get<ViewShown>().labels;
  const auto count = [&](const auto& test) { return std::count_if(labels.begin(), labels.end(), test); };
  return {{"arrows", marks.arrows},
          {"discs", marks.discs},
          {"rings", marks.rings},
          {"bold_rings", marks.bold_rings},
          {"samples", marks.samples},
          {"forces", marks.forces},
          {"labels", labels.size()},
          {"leaders", count([](const SceneLabel& label) { return label.leader.has_value(); })},
          {"occluded", count([](const SceneLabel& label) { return label.occluded; })}};
}

/// Returns the area that a contact surface covers in the view, without overlaps and as seen from one side [pixel^2].
/// Polygons that reach out of the view do not count.
double area_in_view(const Viewer& viewer, const ContactSurface& surface, const Pose& X_WM) {
  double twice = 0;
  for (const ContactPolygon& polygon : surface.polygons) {
    std::vector<dvec3> pixels;
    for (int i = 0; i < polygon.count; ++i)
      pixels.push_back(viewer.project(X_WM * surface.vertices[static_cast<std::size_t>(polygon.first + i)]));
    const bool is_inside = std::all_of(pixels.begin(), pixels.end(), [&](const dvec3& p) {
      return p.z > 0 && p.x >= 0 && p.y >= 0 && p.x <= viewer.view.width && p.y <= viewer.view.height;
    });
    for (std::size_t i = 0; is_inside && i < pixels.size(); ++i) {
      const dvec3 &a = pixels[i], &b = pixels[(i + 1) % pixels.size()];
      twice += a.x * b.y - b.x * a.y;
    }
  }
  return 0.5 * std::abs(twice);
}

/// Returns the part of the view that contact surfaces cover, and the arrows of the net forces in pixels of the window.
Json contact_json(const App& app) {
  const Viewer& viewer = *app.viewer;
  const SceneInput& input = app.get<ViewShown>().input;
  const std::vector<SensorView> views = sensor_views(input);
  const double size = static_cast<double>(viewer.view.width) * viewer.view.height;
  double area = 0;
  for (const SensorView& view : views)
    if (view.state != nullptr)
      for (const ContactSurface& surface : view.state->surfaces) area += area_in_view(viewer, surface, view.X_WM);
  Json arrows = Json::array();
  for (const ForceMark& mark : force_marks_aside(input, views, viewer.camera())) {
    const ImVec2 base = on_screen(viewer, mark.base_W), tip = on_screen(viewer, mark.tip_W);
    arrows.push_back({{base.x, base.y}, {tip.x, tip.y}});
  }
  return {{"part_of_view", size > 0 ? area / size : 0.0}, {"arrows", std::move(arrows)}};
}

Json info_json(const App& app) {
  if (!app.get<PanelsShown>()[kInfo]) return nullptr;
  Json json = Json::object();
  for (const InfoRow& row : scene_info(app.shown->run)) json[row.name] = row.value;
  return json;
}

Json labels_json(const App& app) {
  Json json = Json::array();
  const dvec2 corner(static_cast<double>(app.viewer->view.rect.x0), static_cast<double>(app.viewer->view.rect.y0));
  for (const SceneLabel& label : app.get<ViewShown>().labels) {
    const dvec2 pixel = corner + label.pixel, lo = pixel - label.half, hi = pixel + label.half;
    json.push_back({{"text", label.text},
                    {"taxel", label.taxel >= 0},
                    {"pixel", {pixel.x, pixel.y}},
                    {"rect", {lo.x, lo.y, hi.x, hi.y}}});
  }
  return json;
}

/// Returns the boxes of the view that labels avoid.
Json covered_json(const App& app) {
  Json json = Json::array();
  const Rect& view = app.viewer->view.rect;
  const dvec2 corner(static_cast<double>(view.x0), static_cast<double>(view.y0));
  for (const LabelBox& box : app.get<ViewShown>().covered) {
    const dvec2 lo = corner + box.lo, hi = corner + box.hi;
    json.push_back({lo.x, lo.y, hi.x, hi.y});
  }
  return json;
}

/// Returns the numbers of the overlays about receptive fields, with null for overlays that are off.
Json field_numbers_json(const FieldNumbers& numbers) {
  Json json = {{"coverage", nullptr}, {"comparison", nullptr}, {"normals", nullptr}};
  if (const auto& c = numbers.coverage) {
    json["coverage"] = {{"area_of_overlap", c->area_of_overlap}, {"area", c->area}, {"overlap", c->overlap}};
  }
  if (const auto& c = numbers.comparison) {
    json["comparison"] = {{"euclidean", c->euclidean},
                          {"geodesic", c->geodesic},
                          {"euclidean_only", c->euclidean_only},
                          {"differing", c->differing}};
  }
  if (const auto& n = numbers.normals) {
    json["normals"] = {{"largest_deg", n->largest_deg}, {"mean_deg", n->mean_deg}, {"limit_deg", n->limit_deg}};
  }
  return json;
}

}  // namespace

void dump_view(const App& app, nlohmann::ordered_json& state) {
  const ViewShown& view = app.get<ViewShown>();
  state["info"] = info_json(app);
  state["labels"] = labels_json(app);
  state["covered"] = covered_json(app);
  state["tractions"] = tractions_json(view.numbers);
  state["skin"] = skin_json(app);
  state["marks"] = marks_json(app);
  state["contact"] = contact_json(app);
  state["fields"] = field_numbers_json(view.numbers);
  state["clicks"] = {{"left", view.clicks.left},
                     {"left_double", view.clicks.left_double},
                     {"right", view.clicks.right},
                     {"right_double", view.clicks.right_double}};
}

}  // namespace taxel::ui
