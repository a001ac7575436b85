#include "app/studio/app/dump/tools_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/studio/app/app.h"
#include "app/studio/app/values/layout_features.h"
#include "app/studio/app/values/shown.h"
#include "app/studio/app/values/simulate_features.h"
#include "app/studio/app/values/viewer.h"
#include "app/studio/app/values/window_features.h"
#include "app/studio/features/camera/camera_follow.h"
#include "app/studio/features/view/scene_info.h"
#include "app/vector_json.h"

namespace taxel::studio {

namespace {

using Json = nlohmann::ordered_json;

Json probe_json(const ui::App& app) {
  if (!app.layout->probe.on) return nullptr;
  const ui::ProbeSettings& settings = app.layout->probe.settings;
  Json json = Json::object();
  json["held"] = app.layout->probe.held;
  json["shape"] = std::visit([](const auto& shape) { return shape.kWord; }, settings.shape());
  json["radius"] = settings.sphere().radius;
  json["modulus"] = settings.material.modulus;
  json["depth"] = settings.depth;
  json["at"] = app.layout->probe.at ? Json{app.layout->probe.at->x, app.layout->probe.at->y, app.layout->probe.at->z}
                                    : Json(nullptr);
  json["problem"] = app.shown->document.probe ? app.shown->document.probe->problem : "";
  json["latency"] = app.layout->probe.latency ? Json(*app.layout->probe.latency) : Json(nullptr);
  json["reading"] = nullptr;
  const SensorStep* state = app.shown->state(*app.viewer);
  if (state != nullptr && app.viewer->mode == ui::Mode::layout) {
    json["reading"] = {{"force", app.shown->document.probe->force},
                       {"area", app.shown->document.probe->area},
                       {"polygons", app.shown->document.probe->polygons},
                       {"max_pressure", app.shown->document.probe->largest},
                       {"point",
                        {app.shown->document.probe->probe.point.x, app.shown->document.probe->probe.point.y,
                         app.shown->document.probe->probe.point.z}},
                       {"values", state->readings}};
  }
  return json;
}

Json measure_json(const ui::App& app) {
  if (!app.layout->measure.on) return nullptr;
  Json json = {{"points", Json::array()}, {"straight", nullptr}, {"along", nullptr}, {"path", Json::array()}};
  for (const ui::MeasurePoint& point : app.layout->measure.points) {
    json["points"].push_back(
        {{"at", numbers<Json>(point.at)}, {"taxel", point.taxel ? Json(*point.taxel) : Json(nullptr)}});
  }
  if (!app.shown->document.measured) return json;
  json["straight"] = app.shown->document.measured->straight;
  if (std::isfinite(app.shown->document.measured->along)) json["along"] = app.shown->document.measured->along;
  for (const dvec3& p : app.shown->document.measured->path) json["path"].push_back(numbers<Json>(p));
  return json;
}

Json clip_json(const ui::App& app) {
  if (!app.viewer->clip) return nullptr;
  return {{"normal", numbers<Json>(app.viewer->clip->normal)}, {"offset", app.viewer->clip->offset}};
}

Json info_json(const ui::App& app) {
  if (!app.window->panels.info) return nullptr;
  Json json = Json::object();
  for (const ui::InfoRow& row : ui::scene_info(app.shown->run)) json[row.name] = row.value;
  return json;
}

Json labels_json(const ui::App& app) {
  Json json = Json::array();
  for (const ui::SceneLabel& label : app.window->view.labels)
    json.push_back({{"text", label.text},
                    {"taxel", label.taxel >= 0},
                    {"pixel",
                     {label.pixel.x + static_cast<double>(app.viewer->view.rect.x0),
                      label.pixel.y + static_cast<double>(app.viewer->view.rect.y0)}}});
  return json;
}

/// Returns the means of the costs that the profiler draws [s].
Json profile_json(const ui::App& app) {
  const std::vector<StepCost> steps = app.shown->run.frame ? app.shown->run.frame->costs : std::vector<StepCost>{};
  const auto mean = [](const auto& costs, auto member) {
    double sum = 0;
    for (const auto& cost : costs) sum += static_cast<double>(cost.*member);
    return costs.empty() ? 0.0 : sum / static_cast<double>(costs.size());
  };
  const auto& pictures = app.window->profile.pictures;
  return {{"steps", steps.size()},
          {"mujoco", mean(steps, &StepCost::mujoco)},
          {"surfaces", mean(steps, &StepCost::surfaces)},
          {"forces", mean(steps, &StepCost::forces)},
          {"readings", mean(steps, &StepCost::readings)},
          {"history", mean(steps, &StepCost::history)},
          {"pictures", pictures.size()},
          {"panels", mean(pictures, &ui::PictureCost::panels)},
          {"scene", mean(pictures, &ui::PictureCost::scene)},
          {"window", mean(pictures, &ui::PictureCost::window)}};
}

/// Returns the size of the window, the share of its area that the 3-D view has, and the panel that fills it, or null.
Json window_json(const ui::App& app) {
  const ui::Arrangement& arrangement = app.window->arrangement;
  const ui::Rect& view = app.viewer->view.rect;
  const double area = static_cast<double>(arrangement.width) * static_cast<double>(arrangement.height);
  Json json = {{"width", arrangement.width}, {"height", arrangement.height}};
  json["view_share"] =
      view.empty() || !(area > 0) ? 0.0 : static_cast<double>(view.width()) * static_cast<double>(view.height()) / area;
  json["maximised"] = arrangement.maximised.empty() ? Json(nullptr) : Json(arrangement.maximised);
  return json;
}

Json video_json(const ui::VideoState& video) {
  return {{"active", video.progress.active},     {"checking", video.progress.checking}, {"done", video.progress.done},
          {"total", video.progress.total},       {"annotated", video.annotated},        {"orbit", video.orbit},
          {"size", static_cast<int>(video.size)}};
}

}  // namespace

std::string tools_to_json(const ui::App& app) {
  const Json json = {{"probe", probe_json(app)},
                     {"measure", measure_json(app)},
                     {"clip", clip_json(app)},
                     {"followed", ui::follow_text(*app.viewer, app.shown->run, app.simulate->follow)},
                     {"full_screen", app.window->full_screen},
                     {"info", info_json(app)},
                     {"labels", labels_json(app)},
                     {"profile", profile_json(app)},
                     {"window", window_json(app)},
                     {"video", video_json(app.simulate->video)}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace taxel::studio
