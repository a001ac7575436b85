// The measured distance in the state of the window.
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "app/studio/frame/app.h"
#include "app/studio/frame/shown.h"
#include "app/studio/nouns/measure/measure_state.h"
#include "app/vector_json.h"

namespace taxel::ui {

namespace {

using Json = nlohmann::ordered_json;

}  // namespace

void dump_measure(const App& app, nlohmann::ordered_json& state) {
  const MeasureState& measure = app.get<MeasureState>();
  state["measure"] = nullptr;
  if (!measure.on) return;
  Json json = {{"points", Json::array()}, {"straight", nullptr}, {"along", nullptr}, {"path", Json::array()}};
  for (const MeasurePoint& point : measure.points) {
    json["points"].push_back(
        {{"at", numbers<Json>(point.at)}, {"taxel", point.taxel ? Json(*point.taxel) : Json(nullptr)}});
  }
  const MeasuredPtr& measured = app.shown->document.measured;
  if (measured) {
    json["straight"] = measured->straight;
    if (std::isfinite(measured->along)) json["along"] = measured->along;
    for (const dvec3& p : measured->path) json["path"].push_back(numbers<Json>(p));
  }
  state["measure"] = std::move(json);
}

}  // namespace taxel::ui
