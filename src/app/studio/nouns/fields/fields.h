// The receptive fields in the 3-D view: the job that computes them on a worker, and the legends of their overlays and
// of the repair, with numbers.
#pragma once

#include <memory>
#include <optional>
#include <utility>

#include "app/studio/frame/feature.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/host/jobs/feature_job.h"
#include "app/studio/host/jobs/newest_wins.h"
#include "app/studio/nouns/mesh/mesh_state.h"
#include "core/run/frame.h"
#include "ui/scene/geometry/shown_fields.h"

namespace taxel::studio {

/// Computes receptive fields for the view.
class FieldJob : public NewestWins<ui::FieldsRequest, ui::ShownFields> {
 public:
  explicit FieldJob(JobExecutor& executor)
      : NewestWins(executor, Priority::normal,
                   [maker = std::make_shared<ui::FieldMaker>()](const ui::FieldsRequest& request, ui::ShownFields& out,
                                                                Progress&) { maker->make(request, out); }) {}

  /// Sets the fields to compute in `mode`.
  void request(ui::Mode mode, ui::FieldMap map, bool weights) {
    mode_ = mode;
    request_ = {{}, map, weights};
  }
  /// Posts the request for the sensors of the displayed scene in SIMULATE, otherwise for the edited layout.
  void post_for(const SensorModelPtr& layout, const SimFramePtr& frame) {
    request_.models.clear();
    if (ui::shows_run(mode_) && frame && frame->scene) {
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

namespace taxel::ui {

/// Draws the legends in the lower right corner of the view, one above the other. The lowest legend ends at `bottom`
/// [pixel of the window].
void draw_field_legends(const WindowUi& ui, const ViewPlace& place, const FieldNumbers& numbers,
                        const SensorModel& model, float bottom);

/// Draws the meaning of the colours of a repair's changes, in the upper right corner of the view, beginning at `top`
/// [pixel of the window].
void draw_repair_legend(const WindowUi& ui, const Viewer& viewer, const MeshState& mesh, const SensorModel& model,
                        float top);

/// The receptive fields of the taxels.
extern const Feature kFields;

}  // namespace taxel::ui
