// The row of a trace that belongs to a step.
#pragma once

#include "core/run/history/step_view.h"
#include "core/run/trace.h"

namespace taxel {

/// Returns the row of a step: readings, and shear and slip of the sensors that have them.
[[nodiscard]] TraceRow trace_row_of(const StepView& step, SampleQuality quality);

}  // namespace taxel
