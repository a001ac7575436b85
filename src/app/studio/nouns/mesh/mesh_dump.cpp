// The mesh section in the state of the window.
#include <nlohmann/json.hpp>

#include "app/studio/frame/app.h"
#include "app/studio/frame/shown.h"
#include "app/studio/nouns/mesh/mesh_state.h"

namespace taxel::ui {

namespace {

using Json = nlohmann::ordered_json;

}  // namespace

void dump_mesh(const App& app, nlohmann::ordered_json& state) {
  const MeshState& mesh = app.get<MeshState>();
  if (app.shown->document.model) state["document"]["mesh"]["show_changes"] = mesh.shows_changes;
  state["frame_guess"] = {{"is_guess", mesh.frame_is_guess},
                          {"arrows", frame_arrows(*app.viewer, *app.shown, mesh).size()}};
}

}  // namespace taxel::ui
