// The job that computes receptive fields.
#include "app/studio/nouns/fields/fields.h"

#include "app/studio/frame/app.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"

namespace taxel::studio {

namespace {

class FieldsOfFeature final : public FeatureJob {
 public:
  explicit FieldsOfFeature(JobExecutor& executor) : executor_(executor), fields_(executor) {}

  void request_about_layout(const ui::App& app, const SensorModelPtr& /*model*/) override {
    const ui::Overlays& overlays = app.viewer->overlays();
    fields_.request(app.viewer->mode, ui::field_map(overlays), overlays.readings_on_skin);
  }
  bool take_about_run(const SensorModelPtr& model, const FollowedRun& run, const SendToSimulation& /*send*/) override {
    fields_.post_for(model, run.frame);
    executor_.run_posted();
    return fields_.is_current() && store(shown_, fields_.newest());
  }
  void fill(ui::App& app) const override { app.shown->document.fields = shown_; }
  [[nodiscard]] bool busy() const override { return fields_.busy(); }
  void model_built(const SensorModelPtr& model) override { fields_.model_built(model); }

 private:
  JobExecutor& executor_;
  FieldJob fields_;
  ui::ShownFieldsPtr shown_;
};

}  // namespace

std::unique_ptr<FeatureJob> make_fields_job(JobExecutor& executor) {
  return std::make_unique<FieldsOfFeature>(executor);
}

}  // namespace taxel::studio
