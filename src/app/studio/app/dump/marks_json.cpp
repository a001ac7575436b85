#include "app/studio/app/dump/marks_json.h"

#include <nlohmann/json.hpp>

#include "app/studio/app/reading_range.h"

namespace taxel::studio {
namespace {

using Json = nlohmann::ordered_json;

Json bars_json(const ui::App& app) {
  Json json = Json::array();
  for (const ui::BarShown& bar : app.simulate.bars) {
    json.push_back({{"taxel", bar.taxel_id},
                    {"value", bar.value},
                    {"height", bar.height},
                    {"rect", {bar.rect.x0, bar.rect.y0, bar.rect.x1, bar.rect.y1}},
                    {"top", bar.top},
                    {"axis_height", bar.axis_height},
                    {"color", {bar.color.x, bar.color.y, bar.color.z}},
                    {"outlined", bar.outlined},
                    {"over", bar.over}});
  }
  return json;
}

Json reading_range_json(const ui::App& app) {
  const ui::PressureRange range = ui::reading_range(app.viewer, app.shown);
  return {{"least", range.lo},
          {"largest", range.hi},
          {"automatic", range.automatic},
          {"linked", ui::shares_range(app.viewer, app.shown)},
          {"unit", ui::unit_of_readings(app.viewer, app.shown).text}};
}

}  // namespace

std::string marks_to_json(const ui::App& app) {
  const ui::PressureRange& range = app.viewer.range;
  return Json{{"range", {{"least", range.lo}, {"largest", range.hi}, {"automatic", range.automatic}}},
              {"reading_range", reading_range_json(app)},
              {"bars", bars_json(app)}}
      .dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace taxel::studio
