#include "app/studio/app/dump/scene_json.h"

#include <nlohmann/json.hpp>

#include "app/studio/app/app.h"
#include "app/studio/app/values/shown.h"
#include "app/studio/app/values/simulate_features.h"
#include "app/studio/app/values/viewer.h"
#include "app/studio/features/scenario/path_tool.h"
#include "app/vector_json.h"
#include "core/document/scenario/scenario_json.h"

namespace taxel::studio {

namespace {

using Json = nlohmann::ordered_json;

Json turn_json(const dquat& q) {
  return {q.w, q.x, q.y, q.z};
}

/// Returns names with their values in SI units.
template <class Items, class Values>
Json named(const Items& items, const Values& values) {
  Json json = Json::array();
  for (std::size_t i = 0; i < items.size() && i < values.size(); ++i)
    json.push_back({{"name", items[i].name}, {"value", static_cast<double>(values[i])}});
  return json;
}

Json hand_json(const SimFrame& frame) {
  if (!frame.perturbed) return nullptr;
  const PerturbShown& hand = *frame.perturbed;
  return {{"turns", hand.kind == Perturb::Kind::turn},
          {"body", hand.body},
          {"grabbed", numbers<Json>(hand.grabbed_W)},
          {"at", numbers<Json>(hand.target_W)},
          {"turn", turn_json(hand.target_turn_W)}};
}

}  // namespace

std::string scene_to_json(const ui::App& app) {
  if (!app.shown->run.frame || !app.shown->run.frame->scene) return "null";
  const SimFrame& frame = *app.shown->run.frame;
  const SceneControls& controls = frame.scene->controls;
  Json json = Json::object();
  const auto body = static_cast<std::size_t>(app.viewer->selection.body);
  json["body"] =
      app.viewer->selection.body >= 0 && body < controls.bodies.size() ? Json(controls.bodies[body].name) : nullptr;
  json["actuators"] = named(controls.actuators, frame.controls.controls);
  json["joints"] = named(controls.joints, frame.controls.joints);
  json["keyframes"] = Json::array();
  for (const SceneKeyframe& key : controls.keyframes)
    json["keyframes"].push_back({{"name", key.name}, {"time", key.time}});
  json["mocaps"] = Json::array();
  for (std::size_t i = 0; i < frame.controls.mocaps.size(); ++i) {
    const Pose& X_WB = frame.controls.mocaps[i];
    json["mocaps"].push_back(
        {{"body", controls.mocaps[i]}, {"position", numbers<Json>(X_WB.p)}, {"quaternion", turn_json(X_WB.q)}});
  }
  json["equalities"] = named(controls.equalities, frame.controls.equalities);
  json["held"] = Json::array();
  for (const ConstraintPoints& held : frame.constraint_points)
    json["held"].push_back({{"a", numbers<Json>(held.a_W)}, {"b", numbers<Json>(held.b_W)}, {"weld", held.weld}});
  json["hand"] = hand_json(frame);
  json["gravity"] = numbers<Json>(controls.gravity);
  json["timestep"] = frame.scene->timestep;
  json["geoms"] = Json::array();
  for (std::size_t g = 0; g < frame.scene->geoms.size() && g < frame.geom_poses.size(); ++g) {
    const SceneGeom& geom = frame.scene->geoms[g];
    json["geoms"].push_back({{"name", geom.name},
                             {"body", geom.body},
                             {"sensor", geom.sensor},
                             {"position", numbers<Json>(frame.geom_poses[g].p)},
                             {"quaternion", turn_json(frame.geom_poses[g].q)}});
  }
  json["attached"] = Json::array();
  for (const SceneAttachment& one : app.shown->run.attached)
    json["attached"].push_back({{"geom", one.geom}, {"layout", one.layout}});
  json["chosen"] = app.simulate->controls.geoms;
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string scenario_to_state(const ui::App& app) {
  const Scenario* edited = ui::edited_scenario(*app.viewer, *app.shown);
  if (edited == nullptr) return "null";
  Json json = {{"edited", Json::parse(scenario_to_json(*edited))},
               {"running", Json::parse(scenario_to_json(app.shown->run.scenario))},
               {"selected", app.simulate->path.selected},
               {"recorded", app.simulate->path.recording ? Json(app.simulate->path.recording->points.size()) : Json()},
               {"way_points", Json::array()}};
  if (const auto path = ui::edited_path(*app.viewer, *app.shown, app.simulate->path)) {
    for (const dvec3& p_W : path->points_W) {
      const dvec3 pixel = app.viewer->project(p_W);
      json["way_points"].push_back({{"at", numbers<Json>(p_W)},
                                    {"pixel",
                                     {pixel.x + static_cast<double>(app.viewer->view.rect.x0),
                                      pixel.y + static_cast<double>(app.viewer->view.rect.y0)}}});
    }
  }
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string study_to_state(const ui::App& app) {
  Json runs = Json::array();
  const StudyCurvesPtr& curves = app.simulate->study.shown.curves;
  for (const StudyCurve& curve : curves ? curves->runs : std::vector<StudyCurve>{}) {
    double largest = 0;
    for (const std::vector<double>& readings : curve.readings)
      for (const double reading : readings) largest = std::max(largest, reading);
    runs.push_back(
        {{"values", curve.run.values}, {"rows", curve.time.size()}, {"largest", largest}, {"error", curve.error}});
  }
  return Json{{"busy", app.simulate->study.shown.busy},
              {"cancelled", app.simulate->study.cancelled},
              {"problem", curves ? curves->problem : ""},
              {"runs", runs}}
      .dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace taxel::studio
