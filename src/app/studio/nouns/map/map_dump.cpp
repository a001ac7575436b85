// The taxel map in the state of the window.
#include <nlohmann/json.hpp>
#include <utility>

#include "app/studio/frame/app.h"
#include "app/studio/frame/sensors_shown.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/nouns/map/map_panel.h"
#include "app/vector_json.h"

namespace taxel::ui {

namespace {

using Json = nlohmann::ordered_json;

}  // namespace

void dump_taxel_map(const App& app, nlohmann::ordered_json& state) {
  Json discs = Json::array();
  const PressureRange range = reading_range(*app.viewer, *app.shown);
  for (const MapDisc& disc : app.get<MapState>().discs) {
    const glm::vec3 color = range.color(disc.value);
    discs.push_back({{"sensor", disc.sensor},
                     {"taxel", disc.taxel_id},
                     {"value", disc.value},
                     {"at", {disc.x, disc.y}},
                     {"radius", disc.radius},
                     {"color", {color.x, color.y, color.z}}});
  }
  state["map"] = {{"unrolled", app.get<MapState>().unrolled}, {"discs", std::move(discs)}};
}

}  // namespace taxel::ui
