// Computes receptive fields for the 3-D view on a worker.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "app/studio/frame/viewer.h"
#include "app/studio/host/jobs/feature_job.h"
#include "app/studio/host/jobs/newest_wins.h"
#include "core/run/frame.h"
#include "ui/scene/geometry/shown_fields.h"

namespace taxel::studio {

class FieldJob : public NewestWins<ui::FieldsRequest, ui::ShownFields> {
 public:
  explicit FieldJob(JobExecutor& executor)
      : NewestWins(executor, Priority::normal,
                   [maker = std::make_shared<ui::FieldMaker>()](const ui::FieldsRequest& request, ui::ShownFields& out,
                                                                Progress&) { maker->make(request, out); }) {}

  /// Sets the fields to compute in `mode`.
  void request(ui::Mode mode, ui::FieldMap map, bool weights, bool discs) {
    mode_ = mode;
    request_ = {{}, map, weights, discs};
  }
  /// Posts the request for the sensors of the displayed scene in SIMULATE, otherwise for the edited layout.
  void post_for(const SensorModelPtr& layout, const SimFramePtr& frame) {
    request_.models.clear();
    if (mode_ == ui::Mode::simulate && frame && frame->scene) {
      request_.models = frame->scene->sensors;
    } else if (layout) {
      request_.models = {layout};
    }
    show(request_);
  }
  /// Whether the newest result, if there is one, is that of the newest request.
  [[nodiscard]] bool is_current() const {
    const ui::ShownFieldsPtr result = newest();
    return !result || result->request == request_;
  }
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

 private:
  ui::FieldsRequest request_;
  ui::Mode mode_ = ui::Mode::simulate;
};

/// Makes the job of the feature.
[[nodiscard]] std::unique_ptr<FeatureJob> make_fields_job(JobExecutor& executor);

}  // namespace taxel::studio
