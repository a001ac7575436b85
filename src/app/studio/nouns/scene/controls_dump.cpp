// The scene and its controls in the state of the window.
#include <nlohmann/json.hpp>
#include <utility>

#include "app/studio/frame/app.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/nouns/scene/controls_state.h"
#include "app/vector_json.h"

namespace taxel::ui {

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

void dump_controls(const App& app, nlohmann::ordered_json& state) {
  state["scene"] = nullptr;
  if (!app.shown->run.frame || !app.shown->run.frame->scene) return;
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
                             {"label", geom.shown_name()},
                             {"body", geom.body},
                             {"sensor", geom.sensor},
                             {"covered_by", geom.covered_by},
                             {"position", numbers<Json>(frame.geom_poses[g].p)},
                             {"quaternion", turn_json(frame.geom_poses[g].q)}});
  }
  json["attached"] = Json::array();
  for (const SceneAttachment& one : app.shown->run.attached)
    if (!one.is_declared) json["attached"].push_back({{"geom", one.geom}, {"layout", one.layout}});
  json["chosen"] = app.get<ControlsState>().geoms;
  state["scene"] = std::move(json);
}

}  // namespace taxel::ui
