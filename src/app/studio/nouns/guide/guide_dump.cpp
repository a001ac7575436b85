// The guide in the state of the window that scripts see.
#include <nlohmann/json.hpp>

#include "app/studio/frame/app.h"
#include "app/studio/nouns/guide/guide_state.h"

namespace taxel::ui {

void dump_guide(const App& app, nlohmann::ordered_json& state) {
  state["guide"] = {{"open", app.get<PanelsShown>()[kGuide]}, {"section", app.get<GuideState>().section}};
}

}  // namespace taxel::ui
