#include "app/studio/features/explain/explain_tool.h"

#include <algorithm>

namespace taxel::ui {
namespace {

/// The taxel that changed most; in a first step the one that reads most.
int taxel_to_explain(const UiState& ui, const UiInput& input) {
  const SensorStep& state = *input.sensor(ui);
  const HistoryLanes* lanes = input.frame->history.lanes.get();
  if (lanes != nullptr && lanes->rows() > 0) {
    const std::size_t row = lanes->row_of(input.frame->step);
    const int jumped = lanes->sensor(row, static_cast<std::size_t>(ui.selection.sensor)).jumped_taxel;
    if (jumped >= 0) return jumped;
  }
  return static_cast<int>(std::max_element(state.readings.begin(), state.readings.end()) - state.readings.begin());
}

}  // namespace

void explain_reading(UiState& ui, const UiInput& input) {
  ui.saved.panels.explain = ui.explain.wants_focus = true;
  const SensorModelPtr model = input.shown_model(ui);
  const SensorStep* state = input.sensor(ui);
  if (!ui.selection.empty() || !model || state == nullptr || state->readings.empty()) return;
  const auto taxel = static_cast<std::size_t>(taxel_to_explain(ui, input));
  if (taxel < model->layout.taxels.size()) ui.selection.set(model->layout.taxels[taxel].id);
}

std::optional<ExplainRequest> explain_request(const UiState& ui, const UiInput& input) {
  const std::optional<int> active = ui.selection.active();
  if (!ui.saved.panels.explain || ui.mode != Mode::simulate || !active || input.sensor(ui) == nullptr)
    return std::nullopt;
  return ExplainRequest{ui.selection.sensor, *active};
}

const Explanation* shown_explanation(const UiState& ui, const UiInput& input) {
  const std::optional<ExplainRequest> request = explain_request(ui, input);
  const ExplainedPtr& found = input.explained;
  if (!request || !found || !found->problem.empty() || found->request != *request || found->step != input.frame->step)
    return nullptr;
  return &found->explanation;
}

void inspect_polygon(UiState& ui, const UiInput& input, PolygonNumber polygon) {
  ui.explain.polygon = polygon;
  ui.explain.step = input.frame->step;
  ui.saved.panels.explain = ui.explain.wants_focus = true;
}

}  // namespace taxel::ui
