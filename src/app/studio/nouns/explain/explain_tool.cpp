#include "app/studio/nouns/explain/explain_tool.h"

#include <algorithm>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/nouns/explain/explain.h"

namespace taxel::ui {
namespace {

/// Returns the taxel whose reading changed most; in the first step, the taxel with the largest reading.
int taxel_to_explain(const Viewer& viewer, const Shown& shown) {
  const SensorStep& state = *shown.sensor(viewer);
  const HistoryLanes* lanes = shown.run.frame->history.lanes.get();
  if (lanes != nullptr && lanes->rows() > 0) {
    const std::size_t row = lanes->row_of(shown.run.frame->step);
    const int jumped = lanes->sensor(row, static_cast<std::size_t>(viewer.selection.sensor)).jumped_taxel;
    if (jumped >= 0) return jumped;
  }
  return static_cast<int>(std::max_element(state.readings.begin(), state.readings.end()) - state.readings.begin());
}

}  // namespace

void explain_reading(Viewer& viewer, const Shown& shown, ExplainState& explain, bool& open) {
  open = explain.wants_focus = true;
  const SensorModelPtr model = shown.model(viewer);
  const SensorStep* state = shown.sensor(viewer);
  if (!viewer.selection.empty() || !model || state == nullptr || state->readings.empty()) return;
  const auto taxel = static_cast<std::size_t>(taxel_to_explain(viewer, shown));
  if (taxel < model->layout.taxels.size()) viewer.selection.set(model->layout.taxels[taxel].id);
}

std::optional<ExplainRequest> explain_request(const Viewer& viewer, const Shown& shown, bool open) {
  const std::optional<int> active = viewer.selection.active();
  if (!open || viewer.mode != Mode::simulate || !active || shown.sensor(viewer) == nullptr) return std::nullopt;
  return ExplainRequest{viewer.selection.sensor, *active};
}

const Explanation* shown_explanation(const Viewer& viewer, const Shown& shown, const ExplainState& explain, bool open) {
  const std::optional<ExplainRequest> request = explain_request(viewer, shown, open);
  const ExplainedPtr& found = explain.explained;
  if (!request || !found || !found->problem.empty() || found->request != *request ||
      found->step != shown.run.frame->step)
    return nullptr;
  return &found->explanation;
}

void inspect_polygon(const RunView& run, ExplainState& explain, bool& open, PolygonNumber polygon) {
  explain.polygon = polygon;
  explain.step = run.frame->step;
  open = explain.wants_focus = true;
}

void carry_out(const ExplainReading&, App& app) {
  explain_reading(*app.viewer, *app.shown, app.get<ExplainState>(), app.get<PanelsShown>()[kExplain]);
}

}  // namespace taxel::ui
