// `taxel presets`: the layouts of known sensors, and where their numbers come from.
#pragma once

#include <string>
#include <vector>

#include "core/layout/sensor_presets.h"

namespace taxel::cli {

std::string presets_text(const std::vector<SensorPreset>& presets);
std::string presets_json(const std::vector<SensorPreset>& presets);

}  // namespace taxel::cli
