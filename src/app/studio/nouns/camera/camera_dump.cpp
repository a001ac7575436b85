// The followed body or camera, and the sensors in the view, in the state of the window.
#include <nlohmann/json.hpp>
#include <utility>

#include "app/studio/frame/app.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/nouns/camera/camera_state.h"
#include "app/vector_json.h"

namespace taxel::ui {

namespace {

using Json = nlohmann::ordered_json;

}  // namespace

void dump_camera_follow(const App& app, nlohmann::ordered_json& state) {
  state["followed"] = follow_text(*app.viewer, app.shown->run, app.get<FollowState>());
  const Camera& camera = app.viewer->camera();
  Json json = Json::array();
  for (const BoxCorners& box : sensor_boxes(*app.viewer, *app.shown)) {
    Json corners = Json::array();
    for (const dvec3& p_W : box) corners.push_back(numbers<Json>(app.viewer->project(p_W)));
    json.push_back({{"corners", std::move(corners)},
                    {"inside", is_inside_view(box, camera, app.viewer->view.width, app.viewer->view.height)},
                    {"outside", is_outside_view(box, camera, app.viewer->view.width, app.viewer->view.height)}});
  }
  state["sensor_boxes"] = std::move(json);
}

}  // namespace taxel::ui
