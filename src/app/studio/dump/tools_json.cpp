#include "app/studio/dump/tools_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/studio/features/camera/camera_follow.h"
#include "app/studio/features/view/scene_info.h"
#include "app/vector_json.h"

namespace taxel::studio {

namespace {

using Json = nlohmann::ordered_json;

Json probe_json(const ui::UiState& ui, const ui::UiInput& input) {
  if (!ui.probe.on) return nullptr;
  const ui::ProbeSettings& settings = ui.probe.settings;
  Json json = Json::object();
  json["held"] = ui.probe.held;
  json["shape"] = std::visit([](const auto& shape) { return shape.kWord; }, settings.shape());
  json["radius"] = settings.sphere().radius;
  json["modulus"] = settings.material.modulus;
  json["depth"] = settings.depth;
  json["at"] = ui.probe.at ? Json{ui.probe.at->x, ui.probe.at->y, ui.probe.at->z} : Json(nullptr);
  json["problem"] = input.probe ? input.probe->problem : "";
  json["latency"] = ui.probe.latency ? Json(*ui.probe.latency) : Json(nullptr);
  json["reading"] = nullptr;
  const SensorStep* state = input.shown_state(ui);
  if (state != nullptr && ui.mode == ui::Mode::layout) {
    json["reading"] = {{"force", input.probe->force},
                       {"area", input.probe->area},
                       {"polygons", input.probe->polygons},
                       {"max_pressure", input.probe->largest},
                       {"point", {input.probe->probe.point.x, input.probe->probe.point.y, input.probe->probe.point.z}},
                       {"values", state->readings}};
  }
  return json;
}

Json measure_json(const ui::UiState& ui, const ui::UiInput& input) {
  if (!ui.measure.on) return nullptr;
  Json json = {{"points", Json::array()}, {"straight", nullptr}, {"along", nullptr}, {"path", Json::array()}};
  for (const ui::MeasurePoint& point : ui.measure.points) {
    json["points"].push_back(
        {{"at", numbers<Json>(point.at)}, {"taxel", point.taxel ? Json(*point.taxel) : Json(nullptr)}});
  }
  if (!input.measured) return json;
  json["straight"] = input.measured->straight;
  if (std::isfinite(input.measured->along)) json["along"] = input.measured->along;
  for (const dvec3& p : input.measured->path) json["path"].push_back(numbers<Json>(p));
  return json;
}

Json clip_json(const ui::UiState& ui) {
  if (!ui.clip) return nullptr;
  return {{"normal", numbers<Json>(ui.clip->normal)}, {"offset", ui.clip->offset}};
}

Json info_json(const ui::UiState& ui, const ui::UiInput& input) {
  if (!ui.saved.panels.info) return nullptr;
  Json json = Json::object();
  for (const ui::InfoRow& row : ui::scene_info(input)) json[row.name] = row.value;
  return json;
}

Json labels_json(const ui::UiState& ui) {
  Json json = Json::array();
  for (const ui::SceneLabel& label : ui.view.labels)
    json.push_back({{"text", label.text},
                    {"taxel", label.taxel >= 0},
                    {"pixel",
                     {label.pixel.x + static_cast<double>(ui.view.rect.x0),
                      label.pixel.y + static_cast<double>(ui.view.rect.y0)}}});
  return json;
}

/// Means over what the profiler draws [s].
Json profile_json(const ui::UiState& ui, const ui::UiInput& input) {
  const std::vector<StepCost> steps = input.frame ? input.frame->costs : std::vector<StepCost>{};
  const auto mean = [](const auto& costs, auto member) {
    double sum = 0;
    for (const auto& cost : costs) sum += static_cast<double>(cost.*member);
    return costs.empty() ? 0.0 : sum / static_cast<double>(costs.size());
  };
  const auto& pictures = ui.profile.pictures;
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

}  // namespace

std::string tools_to_json(const ui::UiState& ui, const ui::UiInput& input) {
  const Json json = {{"probe", probe_json(ui, input)}, {"measure", measure_json(ui, input)},
                     {"clip", clip_json(ui)},          {"followed", ui::follow_text(ui, input)},
                     {"full_screen", ui.full_screen},  {"info", info_json(ui, input)},
                     {"labels", labels_json(ui)},      {"profile", profile_json(ui, input)}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace taxel::studio
