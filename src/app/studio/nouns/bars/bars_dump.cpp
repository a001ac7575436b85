// The bars in the state of the window.
#include <nlohmann/json.hpp>
#include <utility>

#include "app/studio/frame/app.h"
#include "app/studio/nouns/bars/bars_state.h"

namespace taxel::ui {

namespace {

using Json = nlohmann::ordered_json;

}  // namespace

void dump_bars(const App& app, nlohmann::ordered_json& state) {
  Json json = Json::array();
  for (const BarShown& bar : app.get<BarsShown>()) {
    json.push_back({{"sensor", bar.sensor},
                    {"taxel", bar.taxel_id},
                    {"value", bar.value},
                    {"error", bar.error},
                    {"height", bar.height},
                    {"rect", {bar.rect.x0, bar.rect.y0, bar.rect.x1, bar.rect.y1}},
                    {"top", bar.top},
                    {"axis_height", bar.axis_height},
                    {"color", {bar.color.x, bar.color.y, bar.color.z}},
                    {"outlined", bar.outlined},
                    {"over", bar.over}});
  }
  state["bars"] = std::move(json);
}

}  // namespace taxel::ui
