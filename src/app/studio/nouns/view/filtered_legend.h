// The legend of the polygons that the contact surface left out of the bodies' overlap, by reason.
#pragma once

#include <array>
#include <vector>

#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"

namespace taxel::ui {

/// Returns the sums over all surfaces of a sensor, by reason.
std::array<RejectedPolygons, kRejections> left_out(const SensorStep& sensor);

/// Draws colour, reason, count, area and force in the lower right corner of the view. Returns the legend's upper edge.
float draw_filtered_legend(const WindowUi& ui, const ViewPlace& place, const SensorStep& sensor);

}  // namespace taxel::ui
