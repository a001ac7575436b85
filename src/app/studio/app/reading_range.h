// The colours of readings.
#pragma once

#include "app/studio/app/values/shown.h"

namespace taxel::ui {

/// Of the bars, the skin and the map: the range that all pressures share; of readings that are no pressures from 0 to
/// the top of the bars' axis.
[[nodiscard]] PressureRange reading_range(const Viewer& viewer, const Shown& shown);

}  // namespace taxel::ui
