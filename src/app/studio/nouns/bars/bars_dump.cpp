// The bars in the state of the window.
#include <nlohmann/json.hpp>
#include <utility>

#include "app/studio/frame/app.h"
#include "app/studio/nouns/bars/bars_state.h"

namespace taxel::ui {

namespace {

using Json = nlohmann::ordered_json;

Json rect_json(const Rect& rect) {
  return {rect.x0, rect.y0, rect.x1, rect.y1};
}

}  // namespace

void dump_bars(const App& app, nlohmann::ordered_json& state) {
  Json json = Json::array();
  const BarsShown& shown = app.get<BarsShown>();
  for (const BarShown& bar : shown.bars) {
    json.push_back({{"sensor", bar.sensor},
                    {"taxel", bar.taxel_id},
                    {"value", bar.value},
                    {"error", bar.error},
                    {"height", bar.height},
                    {"rect", rect_json(bar.rect)},
                    {"top", bar.top},
                    {"axis_height", bar.axis_height},
                    {"color", {bar.color.x, bar.color.y, bar.color.z}},
                    {"outlined", bar.outlined},
                    {"over", bar.over}});
  }
  state["bars"] = std::move(json);
  Json cells = Json::array();
  for (const CellShown& cell : shown.cells)
    cells.push_back({{"sensor", cell.sensor},
                     {"taxel", cell.taxel_id},
                     {"value", cell.value},
                     {"color", {cell.color.x, cell.color.y, cell.color.z}},
                     {"rect", rect_json(cell.rect)}});
  state["cells"] = std::move(cells);
  Json texts = Json::array();
  for (const TextShown& text : shown.texts) texts.push_back({{"text", text.text}, {"rect", rect_json(text.rect)}});
  state["bar_texts"] = std::move(texts);
}

}  // namespace taxel::ui
