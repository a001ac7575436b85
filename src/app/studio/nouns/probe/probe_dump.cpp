// The probe in the state of the window.
#include <nlohmann/json.hpp>
#include <utility>
#include <variant>

#include "app/studio/frame/app.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/nouns/probe/probe_state.h"

namespace taxel::ui {

namespace {

using Json = nlohmann::ordered_json;

}  // namespace

void dump_probe(const App& app, nlohmann::ordered_json& state) {
  const ProbeState& probe = app.get<ProbeState>();
  const PressedProbePtr& pressed = app.shown->document.probe;
  state["probe"] = nullptr;
  if (!probe.on) return;
  const ProbeSettings& settings = probe.settings;
  Json json = Json::object();
  json["held"] = probe.held;
  json["shape"] = std::visit([](const auto& shape) { return shape.kWord; }, settings.shape());
  json["radius"] = settings.sphere().radius;
  json["modulus"] = settings.material.modulus;
  json["depth"] = settings.depth;
  json["at"] = probe.at ? Json{probe.at->x, probe.at->y, probe.at->z} : Json(nullptr);
  json["problem"] = pressed ? pressed->problem : "";
  json["latency"] = probe.latency ? Json(*probe.latency) : Json(nullptr);
  json["reading"] = nullptr;
  const SensorStep* step = app.shown->state(*app.viewer);
  if (step != nullptr && app.viewer->mode == Mode::layout) {
    json["reading"] = {{"force", pressed->force},
                       {"area", pressed->area},
                       {"polygons", pressed->polygons},
                       {"max_pressure", pressed->largest},
                       {"point", {pressed->probe.point.x, pressed->probe.point.y, pressed->probe.point.z}},
                       {"values", step->readings}};
  }
  state["probe"] = std::move(json);
}

}  // namespace taxel::ui
