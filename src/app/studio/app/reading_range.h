// The colours of readings.
#pragma once

#include "app/studio/app/values/shown.h"

namespace taxel::ui {

struct App;

/// Minimum upper end of the pressure range [Pa].
inline constexpr double kLeastRange = 1000;

/// Fits an automatic range to the largest pressure of the run [Pa]; in LAYOUT to that of the probe.
void update_range(App& app, double largest_of_run);

/// Of the bars, the skin and the map: the range that all pressures share; of readings that are no pressures from 0 to
/// the top of the bars' axis.
[[nodiscard]] PressureRange reading_range(const Viewer& viewer, const Shown& shown);

}  // namespace taxel::ui
