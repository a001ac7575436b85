// Fitted gains as the calibration of a layout.
#pragma once

#include "core/layout/calibration_settings.h"
#include "core/run/real/gain_fit.h"

namespace taxel {

/// `before` with, for each taxel that has a gain, that gain and the tare that gives its offset: recording = gain *
/// (reading - tare), so tare = -offset / gain; instead of what it had of these, and of a curve of its own. All else
/// stays, and so do taxels without a gain. `unit`: of the recording; empty: as before. Throws Error where no taxel has
/// a gain.
Calibration with_gains(const std::optional<Calibration>& before, const std::vector<TaxelFit>& fits,
                       const std::string& unit);

}  // namespace taxel
