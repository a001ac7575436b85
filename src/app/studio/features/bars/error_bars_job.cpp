#include "app/studio/features/bars/error_bars_job.h"

#include <memory>
#include <utility>

#include "core/run/history/step_view.h"
#include "core/sim/compare/error_bars.h"

namespace taxel::studio {
namespace {

/// The prepared measures of a scene, kept from step to step.
struct Prepared {
  std::shared_ptr<const SimScene> scene;
  std::unique_ptr<ErrorBars> errors;
};

void measure(Prepared& prepared, const SimFrame& frame, ui::MeasuredErrors& out, Progress& progress) {
  if (prepared.scene != frame.scene) {
    prepared.errors = std::make_unique<ErrorBars>(frame.scene, &progress);
    prepared.scene = frame.scene;
  }
  out.id = frame.id();
  const StepView view = view_of(frame);
  for (std::size_t s = 0; s < view.sensors.size(); ++s) {
    out.missing.push_back(prepared.errors->missing(s));
    out.bars.emplace_back();
    if (out.missing.back().empty()) out.bars.back() = prepared.errors->measure(view, s);
  }
}

}  // namespace

ErrorBarsJob::ErrorBarsJob(JobExecutor& executor)
    : NewestWins(executor, Priority::normal,
                 [prepared = std::make_shared<Prepared>()](const ErrorBarsInput& input, ui::MeasuredErrors& out,
                                                           Progress& progress) {
                   measure(*prepared, *input.frame, out, progress);
                 }) {}

}  // namespace taxel::studio
