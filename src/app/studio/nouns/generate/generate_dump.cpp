// The Generate panel in the state of the window.
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "app/studio/frame/app.h"
#include "app/studio/nouns/generate/generate_state.h"
#include "app/vector_json.h"

namespace taxel::ui {

namespace {

using Json = nlohmann::ordered_json;

}  // namespace

void dump_generate(const App& app, nlohmann::ordered_json& state) {
  const GenerateState& g = app.get<GenerateState>();
  state["generate"] = nullptr;
  if (!g.open) return;
  Json json = {{"center", numbers<Json>(g.frame.center)},
               {"normal", numbers<Json>(g.frame.normal)},
               {"turn_deg", g.pattern.turn_deg},
               {"hint", pattern_hint(*app.viewer, *app.shown, g)},
               {"waiting", g.waiting()},
               {"left_out", g.left_out},
               {"least_distance", nullptr},
               {"problem", g.problem},
               {"file_problem", g.file_problem},
               {"taxels", Json::array()}};
  if (std::isfinite(g.least_distance)) json["least_distance"] = g.least_distance;
  static const std::vector<Taxel> none;
  for (const Taxel& taxel : g.ghosts ? *g.ghosts : none)
    json["taxels"].push_back({{"id", taxel.id},
                              {"center", numbers<Json>(taxel.center)},
                              {"normal", numbers<Json>(taxel.normal)},
                              {"radius", taxel.radius}});
  state["generate"] = std::move(json);
}

}  // namespace taxel::ui
