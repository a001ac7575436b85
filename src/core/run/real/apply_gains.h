// Fitted gains as the calibration of a layout.
#pragma once

#include "core/layout/calibration_settings.h"
#include "core/run/real/gain_fit.h"

namespace taxel {

/// Returns `before` with the fitted gains. For each taxel with a fitted gain, the gain and the tare replace the former
/// gain, tare and curve of that taxel. The tare gives the fitted offset: recording = gain * (reading - tare), so tare =
/// -offset / gain. All other values remain. `unit` is the unit of the recording; if empty, the former unit remains.
/// Throws Error if no taxel has a gain.
Calibration with_gains(const std::optional<Calibration>& before, const std::vector<TaxelFit>& fits,
                       const std::string& unit);

}  // namespace taxel
