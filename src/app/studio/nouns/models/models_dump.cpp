// The readings of other models in the state of the window.
#include <nlohmann/json.hpp>
#include <utility>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/nouns/models/models_state.h"
#include "app/vector_json.h"

namespace taxel::ui {

namespace {

using Json = nlohmann::ordered_json;

}  // namespace

void dump_models(const App& app, nlohmann::ordered_json& state) {
  const ComparedSteps* compared =
      shown_comparison(*app.viewer, *app.shown, app.get<ModelsState>(), is_in_use(kModels, app));
  state["models"] = nullptr;
  if (compared == nullptr) return;
  Json json{{"steps", compared->steps.size()}, {"due", compared->due}, {"problem", compared->problem}};
  const ComparedStep* step = compared->at(app.shown->run.frame->step);
  json["step"] = step != nullptr ? Json(step->step) : Json(nullptr);
  json["models"] = Json::object();
  const int taxel = compared_taxel(app.viewer->selection, *compared);
  json["taxel"] = taxel >= 0 ? Json(compared->model->layout.taxels[static_cast<std::size_t>(taxel)].id) : Json(nullptr);
  for (const ReadingModel model : kReadingModels) {
    Json& one = json["models"][to_word(model)];
    one["unit"] = unit_of(model, compared->model->layout.readout.aggregate);
    if (step != nullptr) one["values"] = step->readings[model].values;
    if (step != nullptr) one["missing"] = step->readings[model].missing;
    if (taxel < 0) continue;
    const CurveComparison c = compare_with_exact(compared->steps, model, static_cast<std::size_t>(taxel));
    one["peak"] = c.peak;
    one["largest_step"] = c.largest_step;
    one["correlation"] = c.correlation ? Json(*c.correlation) : Json(nullptr);
    one["rms"] = c.rms ? Json(*c.rms) : Json(nullptr);
  }
  state["models"] = std::move(json);
}

}  // namespace taxel::ui
