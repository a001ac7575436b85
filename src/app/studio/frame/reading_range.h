// The ranges of the contact surface's pressures and of the taxels' readings.
#pragma once

#include "app/studio/frame/shown.h"

namespace taxel::ui {

struct App;

/// Minimum upper end of the pressure range [Pa].
inline constexpr double kLeastRange = 1000;

/// Fits an automatic range to the largest pressure of the run [Pa]; in LAYOUT to that of the probe. Remembers the
/// largest reading of the probe.
void update_range(App& app, double largest_of_run);

/// Returns the unit in which the displayed sensor's readings are shown.
[[nodiscard]] ReadingUnit unit_of_readings(const Viewer& viewer, const Shown& shown);
/// Returns whether readings are pressures, which can share the range of the contact surface.
[[nodiscard]] bool reads_pressures(const Viewer& viewer, const Shown& shown);
/// Returns whether surface and readings share one range now.
[[nodiscard]] bool shares_range(const Viewer& viewer, const Shown& shown);

/// Returns the range of the bars, the skin, the discs and the map: that of the surface if both are linked, or the
/// locked one, or else from 0 to a round number above the largest reading since the start, in SI units. The largest
/// reading is that of all sensors with the unit of the displayed sensor, or of the probe in LAYOUT. Hence the automatic
/// range only grows during a run.
[[nodiscard]] PressureRange reading_range(const Viewer& viewer, const Shown& shown);
/// Locks the range of the readings at its present value, or lets it follow the readings again.
void toggle_reading_lock(Viewer& viewer, const Shown& shown);

}  // namespace taxel::ui
