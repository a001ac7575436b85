#include "app/studio/jobs/feature_results.h"

#include <utility>

#include "app/studio/app/app.h"

namespace taxel::studio {
namespace {

/// Stores a result. Returns whether it differs from the previous one.
template <class Ptr>
bool store(Ptr& stored, Ptr newest) {
  if (newest == stored) return false;
  stored = std::move(newest);
  return true;
}

}  // namespace

void FeatureResults::press(std::optional<Probe> probe, const SensorModelPtr& model) {
  probe_request_ = std::move(probe);
  if (!probe_request_) {
    pressed_.reset();
    edited_at_.reset();
    edit_latency_.reset();
  }
  jobs_.probe.press(model, probe_request_);
}

void FeatureResults::show_fields(ui::Mode mode, ui::FieldMap map, bool weights) {
  field_mode_ = mode;
  field_request_ = {{}, map, weights};
}

bool FeatureResults::explain(std::optional<ui::ExplainRequest> request) {
  const bool switches = request.has_value() != explain_request_.has_value();
  explain_request_ = request;
  return switches;
}

void FeatureResults::note_edit() {
  if (probe_request_) edited_at_ = std::chrono::steady_clock::now();
}

bool FeatureResults::update_reading(const SensorModelPtr& model, bool is_compiled) {
  jobs_.probe.press(model, probe_request_);
  executor_.run_posted();
  const bool is_measured = store(measured_, jobs_.measure.newest());
  if (pressed_ && pressed_->model != model) pressed_.reset();
  ui::PressedProbePtr newest = jobs_.probe.newest();
  if (!newest || newest == pressed_ || newest->model != model) return is_measured;
  pressed_ = std::move(newest);
  if (edited_at_ && is_compiled) {
    edit_latency_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - *edited_at_).count();
    edited_at_.reset();
  }
  return true;
}

bool FeatureResults::update_fields(const SensorModelPtr& model, const SimFramePtr& frame) {
  ui::FieldsRequest request = field_request_;
  if (field_mode_ == ui::Mode::simulate && frame && frame->scene) {
    request.models = frame->scene->sensors;
  } else if (model) {
    request.models = {model};
  }
  jobs_.fields.show(request);
  executor_.run_posted();
  ui::ShownFieldsPtr newest = jobs_.fields.newest();
  return (!newest || newest->request == request) && store(shown_fields_, std::move(newest));
}

bool FeatureResults::update_explanation(const SimFramePtr& frame, bool keeps_result) {
  if (!keeps_result || !explain_request_) jobs_.explain.explain(frame, explain_request_);
  executor_.run_posted();
  return store(explained_, jobs_.explain.newest());
}

bool FeatureResults::update_comparison() {
  executor_.run_posted();
  return store(compared_, jobs_.models.newest());
}

void FeatureResults::fill(ui::App& app) const {
  app.shown.document.probe = pressed_;
  app.shown.document.measured = measured_;
  app.shown.document.fields = shown_fields_;
  app.simulate.explain.explained = explained_;
  app.simulate.models.compared = compared_;
  app.simulate.study.shown = {jobs_.study.newest(), jobs_.study.busy(), jobs_.study.fraction()};
}

}  // namespace taxel::studio
