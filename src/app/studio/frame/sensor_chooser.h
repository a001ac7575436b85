// A list from which the user chooses the selected sensor, with a filter.
#pragma once

#include <string>
#include <vector>

#include "app/studio/frame/sensors_shown.h"
#include "app/studio/frame/window_ui.h"

namespace taxel::ui {

/// The filter of the list while it is open.
struct SensorChooser {
  std::string filter;
};

/// Returns the indices of the sensors that the filter finds: each of its words is part of the short name, or of the
/// names of the geom, body, mesh, class, joints and sites.
[[nodiscard]] std::vector<std::size_t> matching_sensors(const std::vector<SensorShown>& sensors,
                                                        const std::string& filter);

/// Draws a field of `width` pixels with the name of the selected sensor. A click opens the list of all sensors; Enter
/// in its filter chooses the first match. Choosing selects the sensor without a taxel.
void draw_sensor_chooser(WindowUi& ui, SensorChooser& chooser, Selection& selection,
                         const std::vector<SensorShown>& sensors, float width);

}  // namespace taxel::ui
