#include "app/studio/shell/state/state_json.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/sensors_shown.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/shown_scene.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_state.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/menus/menus_state.h"
#include "app/studio/shell/menus/menus.h"
#include "app/studio/shell/script/script.h"
#include "app/vector_json.h"
#include "core/layout/file/layout_json.h"
#include "core/layout/words.h"
#include "core/mesh/repair/repair.h"
#include "ui/widgets/word_count.h"

namespace taxel::studio {
namespace {

using Json = nlohmann::ordered_json;

/// Maximum number of samples and of polygons in the dump, spread evenly: enough to compare with the frame.
constexpr std::size_t kMostMarks = 400;

Json to_json(const ui::Rect& r) {
  return {r.x0, r.y0, r.x1, r.y1};
}

/// Projection of points of the mesh frame into the window.
struct Projector {
  const ui::App& app;
  Pose X_WM;

  /// Returns {"pixel": [x, y], "depth": ..., "inside": bool, "facing": bool} of a point and its normal in frame M.
  [[nodiscard]] Json operator()(const dvec3& p_M, const dvec3& normal_M) const {
    const dvec3 p_W = X_WM * p_M;
    const ui::Camera& camera = app.viewer->camera();
    const dvec3 pixel = camera.project(p_W, app.viewer->view.width, app.viewer->view.height);
    const bool inside = pixel.z > 0 && pixel.x >= 0 && pixel.y >= 0 && pixel.x < app.viewer->view.width &&
                        pixel.y < app.viewer->view.height;
    Json json = Json::object();
    json["pixel"] = {pixel.x + static_cast<double>(app.viewer->view.rect.x0),
                     pixel.y + static_cast<double>(app.viewer->view.rect.y0)};
    json["depth"] = pixel.z;
    json["inside"] = inside;
    json["facing"] = glm::dot(X_WM.rotate(normal_M), camera.eye() - p_W) > 0;
    return json;
  }
};

Json camera_json(const ui::Camera& camera) {
  return {{"target", numbers<Json>(camera.target)},
          {"azimuth_deg", camera.azimuth_deg},
          {"elevation_deg", camera.elevation_deg},
          {"distance", camera.distance},
          {"fov_deg", camera.fov_deg},
          {"roll_deg", camera.roll_deg},
          {"orthographic", camera.orthographic}};
}

Json overlays_json(const ui::Overlays& o) {
  return {{"sensor_transparent", o.sensor_transparent},
          {"wireframe", o.wireframe},
          {"rays", o.rays},
          {"all_rays", o.all_rays},
          {"contact_surface", o.contact_surface},
          {"contact_edges", o.contact_edges},
          {"slip_map", o.slip_map},
          {"tractions", o.tractions},
          {"readings_on_skin", o.readings_on_skin},
          {"filtered_polygons", o.filtered_polygons},
          {"samples", o.samples},
          {"sample_normals", o.sample_normals},
          {"taxels", o.taxels},
          {"taxel_labels", o.taxel_labels},
          {"all_taxels", o.all_taxels},
          {"reading_discs", o.reading_discs},
          {"receptive_fields", o.receptive_fields},
          {"fields_filled", o.fields_filled},
          {"fields_compared", o.fields_compared},
          {"coverage", o.coverage},
          {"normal_angles", o.normal_angles},
          {"path", o.path},
          {"grid", o.grid},
          {"scene_grid", o.scene_grid},
          {"constraints", o.constraints},
          {"geom_groups", o.geom_groups},
          {"site_groups", o.site_groups},
          {"frames", to_word(o.frames)},
          {"labels", to_word(o.labels)}};
}

/// Returns the quality of the document's compiled model and whether it is being polished, or null without a model.
Json model_json(const ui::App& app) {
  if (!app.shown->document.model) return nullptr;
  return {{"quality", to_string(app.shown->document.model->quality)},
          {"polishing", app.shown->document.polishing.active}};
}

Json repair_steps_json(const SensorModel& model) {
  Json steps = Json::array();
  for (const RepairStep& step : model.repaired->report.steps)
    steps.push_back({{"code", step.code},
                     {"severity", to_string(step.severity)},
                     {"count", step.count},
                     {"message", step.message},
                     {"place", numbers<Json>(step.place)}});
  return steps;
}

Json document_json(const ui::App& app) {
  if (!app.shown->document.model) return nullptr;
  Json json = Json::object();
  json["name"] = app.shown->document.name;
  json["file"] = app.shown->document.file;
  const Layout& layout = app.shown->document.editing.project ? app.shown->document.editing.project->layout
                                                             : app.shown->document.model->layout;
  json["layout"] = Json::parse(layout_to_json(layout));
  const TriMesh& mesh = *app.shown->document.model->mesh;
  json["mesh"] = {{"triangles", mesh.face_count()},
                  {"shells", mesh.shell_count()},
                  {"closed", mesh.closed()},
                  {"size", numbers<Json>(mesh.bounds().extent())},
                  {"level", std::string(to_word(layout.mesh.repair.level))},
                  {"repaired", app.shown->document.model->mesh != app.shown->document.model->loaded},
                  {"summary", repair_summary(app.shown->document.model->repaired->report)},
                  {"steps", repair_steps_json(*app.shown->document.model)}};
  json["samples"] = app.shown->document.model->samples.size();
  return json;
}

Json history_json(const ui::Editing& editing) {
  Json steps = Json::array(), saved = nullptr;
  for (std::size_t i = 0; editing.steps && i < editing.steps->size(); ++i) {
    steps.push_back((*editing.steps)[i].name);
    if ((*editing.steps)[i].revision == editing.saved_revision) saved = i;
  }
  return {{"steps", std::move(steps)},        {"saved_step", std::move(saved)}, {"depth", editing.undo_depth},
          {"redo_depth", editing.redo_depth}, {"undo", editing.undo},           {"redo", editing.redo},
          {"dirty", editing.dirty},           {"compiled", editing.compiled},   {"problem", editing.problem}};
}

Json simulation_json(const ui::App& app) {
  if (!app.shown->run.frame) return nullptr;
  const SimFrame& frame = *app.shown->run.frame;
  Json json = Json::object();
  json["title"] = frame.scene->title;
  json["step"] = frame.step;
  json["time"] = frame.time;
  json["travel"] = frame.travel;
  json["playing"] = app.shown->run.playing;
  json["finished"] = frame.finished;
  json["speed"] = app.shown->run.speed;
  json["rows"] = frame.trace ? frame.trace->rows.size() : 0;
  const auto is_preview = [](const TraceRow& row) { return row.quality == SampleQuality::preview; };
  json["preview_rows"] =
      frame.trace ? std::count_if(frame.trace->rows.begin(), frame.trace->rows.end(), is_preview) : 0;
  json["sensors"] = Json::array();
  for (std::size_t s = 0; s < frame.sensors.size(); ++s) {
    const SensorStep& sensor = frame.sensors[s];
    std::size_t polygons = 0;
    double largest = 0;
    for (const ContactSurface& surface : sensor.surfaces) {
      polygons += surface.polygons.size();
      largest = std::max(largest, surface.max_pressure());
    }
    json["sensors"].push_back({{"quality", to_string(frame.scene->sensors[s]->quality)},
                               {"readings", sensor.readings},
                               {"force", numbers<Json>(sensor.force_W)},
                               {"polygons", polygons},
                               {"max_pressure", largest},
                               {"position", numbers<Json>(sensor.X_WM.p)},
                               {"quaternion", {sensor.X_WM.q.w, sensor.X_WM.q.x, sensor.X_WM.q.y, sensor.X_WM.q.z}}});
  }
  json["readings"] =
      app.shown->sensor(*app.viewer) != nullptr ? Json(app.shown->sensor(*app.viewer)->readings) : Json::array();
  json["peaks"] = app.shown->run.peaks;
  return json;
}

Json taxels_json(const Projector& project, const SensorModel& model) {
  Json json = Json::array();
  for (std::size_t i = 0; i < model.layout.taxels.size(); ++i) {
    const Taxel& taxel = model.layout.taxels[i];
    Json mark = project(taxel.center, taxel.normal);
    mark["id"] = taxel.id;
    mark["name"] = taxel.name;
    const glm::vec3 color = ui::taxel_color(model.color(static_cast<int>(i)));
    mark["color"] = {color.x, color.y, color.z};
    json.push_back(std::move(mark));
  }
  return json;
}

Json samples_json(const Projector& project, const SensorModel& model) {
  Json json = Json::array();
  std::vector<std::size_t> used;
  for (std::size_t i = 0; i < model.taxels_of_sample.size(); ++i) {
    if (!model.taxels_of_sample[i].empty()) used.push_back(i);
  }
  const std::size_t stride = 1 + used.size() / kMostMarks;
  for (std::size_t k = 0; k < used.size(); k += stride) {
    const SurfaceSample& sample = model.samples[used[k]];
    Json mark = project(sample.position, sample.normal);
    const int nearest = model.taxels_of_sample[used[k]].front();
    mark["sample"] = used[k];
    mark["taxel"] = model.layout.taxels[static_cast<std::size_t>(nearest)].id;
    const glm::vec3 color = ui::taxel_color(model.color(nearest));
    mark["color"] = {color.x, color.y, color.z};
    json.push_back(std::move(mark));
  }
  return json;
}

Json polygons_json(const ui::App& app, const Projector& project, const SensorStep& sensor) {
  Json json = Json::array();
  for (const ContactSurface& surface : sensor.surfaces) {
    const std::size_t stride = 1 + surface.polygons.size() / kMostMarks;
    for (std::size_t i = 0; i < surface.polygons.size(); i += stride) {
      const ContactPolygon& polygon = surface.polygons[i];
      Json mark = project(polygon.centroid, polygon.normal);
      mark["pressure"] = polygon.pressure;
      mark["area"] = polygon.area;
      const glm::vec3 color = app.viewer->range.color(polygon.pressure);
      mark["color"] = {color.x, color.y, color.z};
      json.push_back(std::move(mark));
    }
  }
  return json;
}
Json widgets_json(const ui::App& app) {
  Json json = Json::array();
  for (const ui::WidgetRegistry::Entry& entry : app.ui->widgets.entries()) {
    json.push_back(
        {{"panel", entry.panel}, {"label", entry.label}, {"rect", to_json(entry.rect)}, {"field", entry.field}});
  }
  return json;
}

/// Returns the refused input of a field, or null if no input is refused.
Json refused_json(const ui::FieldState& fields) {
  if (!fields.refused) return nullptr;
  return {
      {"field", fields.refused->input.field}, {"typed", fields.refused->input.typed}, {"words", fields.refused->words}};
}

Json clip_json(const ui::App& app) {
  if (!app.viewer->clip) return nullptr;
  return {{"normal", numbers<Json>(app.viewer->clip->normal)}, {"offset", app.viewer->clip->offset}};
}

/// Returns the number of widgets, of words and of numbers on the screen, and the words and numbers themselves with
/// their places.
Json amount_json(const ui::App& app) {
  const ImDrawData* drawn = ImGui::GetDrawData();
  const ui::WordCount count = drawn != nullptr ? ui::count_words(*drawn) : ui::WordCount{};
  Json texts = Json::array(), places = Json::array();
  for (const ui::WordShown& word : count.shown) {
    texts.push_back(word.text);
    places.push_back({{"panel", word.panel}, {"rect", to_json(word.ink)}, {"cut", word.is_cut}});
  }
  return {{"widgets", app.ui->widgets.entries().size()},
          {"words", count.words},
          {"numbers", count.numbers},
          {"texts", std::move(texts)},
          {"places", std::move(places)}};
}

/// Returns the size of the window, the share of its area that the 3-D view has, and the panel that fills it, or null.
Json window_json(const ui::App& app) {
  const ui::Arrangement& arrangement = app.get<ui::Arrangement>();
  const ui::Rect& view = app.viewer->view.rect;
  const double area = static_cast<double>(arrangement.width) * static_cast<double>(arrangement.height);
  Json json = {{"width", arrangement.width}, {"height", arrangement.height}};
  json["view_share"] =
      view.empty() || !(area > 0) ? 0.0 : static_cast<double>(view.width()) * static_cast<double>(view.height()) / area;
  json["maximised"] = arrangement.maximised.empty() ? Json(nullptr) : Json(arrangement.maximised);
  return json;
}

Json range_json(const ui::PressureRange& range) {
  return {{"least", range.lo}, {"largest", range.hi}, {"automatic", range.automatic}};
}

Json reading_range_json(const ui::App& app) {
  const ui::PressureRange range = ui::reading_range(*app.viewer, *app.shown);
  return {{"least", range.lo},
          {"largest", range.hi},
          {"automatic", range.automatic},
          {"linked", ui::shares_range(*app.viewer, *app.shown)},
          {"unit", ui::unit_of_readings(*app.viewer, *app.shown).text}};
}

Json pace_json(const ui::App& app, const Pace& pace) {
  return {{"pictures", pace.pictures},
          {"seconds", pace.seconds},
          {"frames_per_second", pace.seconds > 0 ? pace.pictures / pace.seconds : 0.0},
          {"worst_seconds", pace.worst_seconds},
          {"scene_draws", pace.scene_draws},
          {"simulation_speed", app.shown->run.performance.simulation_speed},
          {"step_seconds", app.shown->run.performance.step_seconds}};
}

}  // namespace

std::string state_to_json(const ui::App& app, const Pace& pace) {
  Json json = Json::object();
  json["mode"] = app.viewer->mode == ui::Mode::layout     ? "layout"
                 : app.viewer->mode == ui::Mode::simulate ? "simulate"
                                                          : "analyse";
  json["camera"] = camera_json(app.viewer->camera());
  json["selection"] = {
      {"sensor", app.viewer->selection.sensor}, {"taxel", nullptr}, {"taxels", app.viewer->selection.taxels}};
  if (const std::optional<int> active = app.viewer->selection.active()) json["selection"]["taxel"] = *active;
  const SensorModelPtr model = app.shown->model(*app.viewer);
  json["document"] = document_json(app);
  json["model"] = model_json(app);
  json["title"] = app.get<ui::WindowState>().title;
  json["history"] = history_json(app.shown->document.editing);
  json["refused"] = refused_json(app.ui->fields);
  json["keyboard"] = app.ui->fields.keyboard_panel;
  json["menus"] = {{"keyboard", app.get<ui::MenuKeys>().on}, {"open", ui::open_menu(app)}};
  json["simulation"] = simulation_json(app);
  json["clip"] = clip_json(app);
  json["range"] = range_json(app.viewer->range);
  json["reading_range"] = reading_range_json(app);
  json["full_screen"] = app.get<ui::WindowState>().full_screen;
  json["window"] = window_json(app);
  json["amount"] = amount_json(app);
  json["overlays"] = overlays_json(app.viewer->overlays());
  json["view"] = {
      {"rect", to_json(app.viewer->view.rect)}, {"width", app.viewer->view.width}, {"height", app.viewer->view.height}};
  const Projector project{app, ui::shown_pose(*app.viewer, *app.shown)};
  json["taxels"] = model ? taxels_json(project, *model) : Json::array();
  json["samples"] = model ? samples_json(project, *model) : Json::array();
  const SensorStep* sensor = app.shown->state(*app.viewer);
  json["polygons"] = sensor != nullptr ? polygons_json(app, project, *sensor) : Json::array();
  json["widgets"] = widgets_json(app);
  json["pace"] = pace_json(app, pace);
  for (const ui::Feature* row : ui::features())
    if (row->dump != nullptr) row->dump(app, json);
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";  // messages may quote invalid UTF-8
}

std::optional<ui::Camera> camera_of_state(const std::string& json) {
  try {
    const Json state = Json::parse(json);
    if (state.at("mode") == "layout") return std::nullopt;
    const Json& from = state.at("camera");
    ui::Camera camera;
    for (int i = 0; i < 3; ++i) camera.target[i] = from.at("target").at(static_cast<std::size_t>(i)).get<double>();
    from.at("azimuth_deg").get_to(camera.azimuth_deg);
    from.at("elevation_deg").get_to(camera.elevation_deg);
    from.at("distance").get_to(camera.distance);
    from.at("fov_deg").get_to(camera.fov_deg);
    camera.roll_deg = from.value("roll_deg", 0.0);
    camera.orthographic = from.value("orthographic", false);
    const bool possible = is_finite(camera.target) && std::abs(camera.elevation_deg) <= 90 && camera.distance > 0 &&
                          camera.fov_deg > 0 && camera.fov_deg < 180;
    return possible ? std::optional(camera) : std::nullopt;
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

void check_expectation(const ExpectCommand& expect, const std::string& state_json) {
  const Json state = Json::parse(state_json);
  const Json::json_pointer pointer(expect.pointer);
  if (!state.contains(pointer)) throw Error(fmt::format("expected {}, which the state does not have", expect.pointer));
  const Json& value = state.at(pointer);
  const auto fail = [&](const std::string& wanted) {
    throw Error(fmt::format("expected {} {}, is {}", expect.pointer, wanted,
                            value.dump(-1, ' ', false, Json::error_handler_t::replace)));
  };
  if (!expect.equals.empty() && value != Json::parse(expect.equals)) fail("to be " + expect.equals);
  if (!expect.contains.empty() &&
      value.dump(-1, ' ', false, Json::error_handler_t::replace).find(expect.contains) == std::string::npos)
    fail("to contain " + expect.contains);
  if ((expect.least || expect.most) && !value.is_number()) fail("to be a number");
  if (expect.least && value.get<double>() < *expect.least) fail(fmt::format("to be at least {}", *expect.least));
  if (expect.most && value.get<double>() > *expect.most) fail(fmt::format("to be at most {}", *expect.most));
}

}  // namespace taxel::studio
