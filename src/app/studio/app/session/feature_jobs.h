// The jobs of all features: their requests and their newest results.
#pragma once

#include <functional>
#include <optional>

#include "app/studio/features/bars/error_bars_job.h"
#include "app/studio/features/compare/compare_job.h"
#include "app/studio/features/data_set/data_set_job.h"
#include "app/studio/features/explain/explain_job.h"
#include "app/studio/features/fields/field_job.h"
#include "app/studio/features/generate/pattern_job.h"
#include "app/studio/features/measure/measure_job.h"
#include "app/studio/features/models/models_job.h"
#include "app/studio/features/probe/probe_job.h"
#include "app/studio/features/study/study_job.h"
#include "app/studio/features/study/study_saver.h"

namespace taxel::ui {
struct App;
}

namespace taxel::studio {

using SendToSimulation = std::function<void(SimCommand)>;

/// The part of a run that jobs depend on.
struct FollowedRun {
  SimFramePtr frame;               ///< displayed frame, or null
  bool runs = false;               ///< whether the displayed step changes by itself
  bool keeps_explanation = false;  ///< whether the last explanation stays until the run pauses
};

/// An earlier result stays until there is one for the displayed model.
class FeatureJobs {
 public:
  explicit FeatureJobs(JobExecutor& executor);

  /// To be called on the worker that built an edited model, so that what depends on the model arrives together with it.
  void model_built(const SensorModelPtr& model);
  /// Whether a result is under way. Patterns are not included: the Generate panel waits for them itself.
  [[nodiscard]] bool busy() const;
  /// Registers an edit of the layout.
  void note_edit() { probe_.note_edit(); }
  /// To be called when no scene is displayed any more.
  void drop_scene() { explain_.forget_request(); }
  /// Accepts recorded steps that a job has recalled.
  void accept(StepsRecalled recalled) {
    if (recalled.asker == kCompareAsks) return compare_.accept(std::move(recalled));
    if (recalled.asker == kExplainAsks) return explain_.accept(std::move(recalled));
    models_.accept(std::move(recalled));
  }

  /// Posts the requests of the tools for the edited layout. `model` was compiled from it.
  void request_about_layout(const ui::App& app, const SensorModelPtr& model);
  /// Posts the requests of the open panels about the run.
  void request_about_run(const ui::App& app, const SensorModelPtr& model, const SendToSimulation& send);
  /// Takes the newest results. Returns whether one of them is new. `is_compiled`: the model includes all edits.
  bool update_layout(const SensorModelPtr& model, bool is_compiled);
  bool update_run(const SensorModelPtr& model, const FollowedRun& run, const SendToSimulation& send);
  /// Takes the newest results about data sets. Returns whether one of them is new.
  bool update_data_set() { return data_set_.update(); }
  /// Returns the outcome of writing a study as a data set, once. Null if there is none.
  [[nodiscard]] std::shared_ptr<const SavedStudy> take_saved_study();
  /// The data set that was read last, or null.
  [[nodiscard]] const ui::OpenDataSetPtr& data_set() const { return data_set_.set(); }
  /// Sets the results that panels display.
  void fill(ui::App& app) const;

  [[nodiscard]] PatternJob& patterns() { return patterns_; }
  [[nodiscard]] const PatternJob& patterns() const { return patterns_; }

 private:
  JobExecutor& executor_;
  ProbeJob probe_;
  MeasureJob measure_;
  FieldJob fields_;
  ExplainJob explain_;
  ModelsJob models_;
  CompareJob compare_;
  StudyJob study_;
  StudySaver study_saver_;
  DataSetJob data_set_;
  PatternJob patterns_;
  ErrorBarsJob error_bars_;
  ui::MeasuredErrorsPtr measured_errors_;
  ui::MeasuredPtr measured_;
  ui::ShownFieldsPtr shown_fields_;
  ui::ExplainedPtr explained_;
  ui::ComparedPtr compared_;
  ui::ComparedLayoutsPtr compared_layouts_;
  std::shared_ptr<const SavedStudy> saved_study_;
};

}  // namespace taxel::studio
