// Explains one taxel's reading, and why it changed since the previous step.
#pragma once

#include <memory>

#include "core/base/progress.h"
#include "core/sensor/explain/explanation.h"

namespace taxel {

/// Two steps of one model, of which the second follows the first.
struct StepPair {
  const SensorStep *before = nullptr, *now = nullptr;
};

/// Explains one reading after another. Models with other numbers of samples are kept for the next reading of the same
/// model. Not safe to share between threads.
class Explainer {
 public:
  Explainer();
  ~Explainer();
  /// Explains the reading of taxel number `taxel` of now.model. `before` is a step of the same model, or null. The
  /// result depends on the arguments alone. `worst` are the steps between which the reading of the taxel changes most
  /// in the run, if they are known: remedies are tried on them too. Throws Error for an unknown taxel, and Cancelled
  /// through `progress`.
  Explanation explain(int taxel, const SensorStep& now, const SensorStep* before, const ExplainLimits& limits,
                      Progress* progress = nullptr, const StepPair& worst = {});

 private:
  struct Kept;
  std::unique_ptr<Kept> kept_;
};

}  // namespace taxel
