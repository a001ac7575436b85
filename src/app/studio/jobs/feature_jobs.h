// The jobs of all features.
#pragma once

#include <functional>

#include "app/studio/features/explain/explain_job.h"
#include "app/studio/features/fields/field_job.h"
#include "app/studio/features/generate/pattern_job.h"
#include "app/studio/features/measure/measure_job.h"
#include "app/studio/features/models/models_job.h"
#include "app/studio/features/probe/probe_job.h"
#include "app/studio/features/study/study_job.h"

namespace taxel::studio {

struct FeatureJobs {
  FeatureJobs(JobExecutor& executor, const std::function<void()>& wake)
      : probe(executor, wake),
        measure(executor, wake),
        fields(executor, wake),
        explain(executor, wake),
        models(executor, wake),
        study(executor, wake),
        patterns(executor, wake) {}

  /// To be called on the worker that built an edited model, so that what depends on the model arrives together with it.
  void model_built(const SensorModelPtr& model) {
    probe.model_built(model);
    fields.model_built(model);
  }
  /// Whether a result is under way. Patterns are not included: the Generate panel waits for them itself.
  [[nodiscard]] bool busy() const {
    return probe.busy() || measure.busy() || fields.busy() || explain.busy() || models.busy() || study.busy();
  }

  ProbeJob probe;
  MeasureJob measure;
  FieldJob fields;
  ExplainJob explain;
  ModelsJob models;
  StudyJob study;
  PatternJob patterns;
};

}  // namespace taxel::studio
