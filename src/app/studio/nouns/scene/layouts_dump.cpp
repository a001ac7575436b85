// The edited layout of a scene in the state of the window.
#include <nlohmann/json.hpp>

#include "app/studio/frame/app.h"
#include "app/studio/nouns/scene/scene_layouts.h"

namespace taxel::ui {

void dump_scene_layout(const App& app, nlohmann::ordered_json& state) {
  const std::optional<SceneLayout>& edited = app.shown->document.scene_layout;
  state["scene_layout"] = nullptr;
  if (edited)
    state["scene_layout"] = {{"file", edited->file}, {"geoms", edited->geoms}, {"is_written", edited->is_written}};
}

}  // namespace taxel::ui
