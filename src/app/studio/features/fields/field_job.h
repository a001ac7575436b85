// Computes receptive fields for the 3-D view on a worker.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "app/studio/jobs/newest_wins.h"
#include "ui/scene/geometry/shown_fields.h"

namespace taxel::studio {

class FieldJob : public NewestWins<ui::FieldsRequest, ui::ShownFields> {
 public:
  FieldJob(JobExecutor& executor, std::function<void()> wake)
      : NewestWins(
            executor, Priority::normal,
            [maker = std::make_shared<ui::FieldMaker>()](const ui::FieldsRequest& request, ui::ShownFields& out,
                                                         Progress&) { maker->make(request, out); },
            std::move(wake)) {}

  /// Posts a request. An empty request withdraws the posted one.
  void show(const ui::FieldsRequest& request) { post(request.empty() ? std::nullopt : std::optional(request)); }
  /// Computes the requested fields of a model that was just built, on the worker that built it, so that the model and
  /// its fields arrive together.
  void model_built(const SensorModelPtr& model) {
    std::optional<ui::FieldsRequest> request = posted();
    if (!request || !model || request->models.size() != 1) return;
    request->models = {model};
    run_here(*request);
  }
};

}  // namespace taxel::studio
