#include "app/studio/nouns/models/models_tool.h"

#include <algorithm>
#include <cmath>

namespace taxel::ui {

std::optional<ModelsRequest> models_request(const Viewer& viewer, const Shown& shown, bool open) {
  if (!open || viewer.mode != Mode::simulate || shown.sensor(viewer) == nullptr) return std::nullopt;
  return ModelsRequest{viewer.selection.sensor};
}

const ComparedSteps* shown_comparison(const Viewer& viewer, const Shown& shown, const ModelsState& models, bool open) {
  const std::optional<ModelsRequest> request = models_request(viewer, shown, open);
  const ComparedPtr& found = models.compared;
  if (!request || !found || found->sensor != request->sensor || found->model != shown.model(viewer)) return nullptr;
  return found.get();
}

std::vector<double> model_curve(const ComparedSteps& compared, ReadingModel model, std::size_t taxel) {
  std::vector<double> curve;
  for (const ComparedStep& step : compared.steps)
    curve.push_back(step.readings[model].has(taxel) ? step.readings[model].values[taxel] : std::nan(""));
  return curve;
}

int compared_taxel(const Selection& selection, const ComparedSteps& compared) {
  if (const int active = active_index(selection, compared.model->layout); active >= 0) return active;
  int best = compared.steps.empty() || compared.model->layout.taxels.empty() ? -1 : 0;
  double largest = 0;
  for (const ComparedStep& step : compared.steps) {
    const std::vector<double>& readings = step.readings[ReadingModel::reading].values;
    const auto most = std::max_element(readings.begin(), readings.end());
    if (most == readings.end() || !(*most > largest)) continue;
    largest = *most;
    best = static_cast<int>(most - readings.begin());
  }
  return best;
}

}  // namespace taxel::ui
