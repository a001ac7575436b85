#include <nlohmann/json.hpp>

#include "app/studio/frame/app.h"
#include "app/studio/frame/window_state.h"
#include "app/studio/nouns/present/present.h"

namespace taxel::ui {

void dump_presentation(const App& app, nlohmann::ordered_json& state) {
  const WindowParts& parts = app.get<WindowParts>();
  const PresentState& present = app.get<PresentState>();
  const auto box = [](const Rect& r) { return nlohmann::ordered_json{r.x0, r.y0, r.x1, r.y1}; };
  state["presentation"] = {{"on", parts.is_presenting},
                           {"few_panels", parts.has_few},
                           {"caption", box(present.caption)},
                           {"bars", box(present.bars)}};
}

}  // namespace taxel::ui
