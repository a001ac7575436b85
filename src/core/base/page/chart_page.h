// Draws charts as pages.
#pragma once

#include "core/base/page/chart.h"
#include "core/base/page/page.h"

namespace taxel {

/// Returns the chart on white. Curves are thinned to a resolution of 0.25 points, in which the lowest and the highest
/// value remain. A legend has columns to the right of its axes. On a page of a given size, legends take at most half of
/// the width; entries that have no place become "and 7 more". Throws Error if a page of the given size leaves less than
/// kMinAxes to the axes.
[[nodiscard]] Page chart_page(const Chart& chart);

}  // namespace taxel
