#include "app/studio/app/dump/marks_json.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/studio/app/reading_range.h"
#include "app/studio/app/values/shown.h"
#include "app/studio/app/values/simulate_features.h"
#include "app/studio/app/values/viewer.h"
#include "app/studio/app/values/window_features.h"

namespace taxel::studio {
namespace {

using Json = nlohmann::ordered_json;

Json bars_json(const ui::App& app) {
  Json json = Json::array();
  for (const ui::BarShown& bar : app.simulate->bars) {
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
  return json;
}

Json reading_range_json(const ui::App& app) {
  const ui::PressureRange range = ui::reading_range(*app.viewer, *app.shown);
  return {{"least", range.lo},
          {"largest", range.hi},
          {"automatic", range.automatic},
          {"linked", ui::shares_range(*app.viewer, *app.shown)},
          {"unit", ui::unit_of_readings(*app.viewer, *app.shown).text}};
}

/// Returns the numbers of drawn marks.
Json marks_json(const ui::App& app) {
  const ui::MarkCounts& marks = app.window->view.numbers.marks;
  const std::vector<ui::SceneLabel>& labels = app.window->view.labels;
  const auto count = [&](const auto& test) { return std::count_if(labels.begin(), labels.end(), test); };
  return {{"arrows", marks.arrows},
          {"discs", marks.discs},
          {"rings", marks.rings},
          {"samples", marks.samples},
          {"forces", marks.forces},
          {"labels", labels.size()},
          {"leaders", count([](const ui::SceneLabel& label) { return label.leader.has_value(); })},
          {"occluded", count([](const ui::SceneLabel& label) { return label.occluded; })}};
}

}  // namespace

std::string marks_to_json(const ui::App& app) {
  const ui::PressureRange& range = app.viewer->range;
  return Json{{"range", {{"least", range.lo}, {"largest", range.hi}, {"automatic", range.automatic}}},
              {"reading_range", reading_range_json(app)},
              {"bars", bars_json(app)},
              {"marks", marks_json(app)}}
      .dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace taxel::studio
