// Which sensor of a recording an option names.
#pragma once

#include <cstddef>
#include <string>

#include "core/run/recording/recording.h"

namespace taxel::cli {

/// The sensor on `geom`; if that is empty, the only one with taxels. Throws Error naming `file` and the sensors that
/// there are, also for a soft geom without taxels.
std::size_t sensor_of(const Recording& recording, const std::string& geom, const std::string& file);

}  // namespace taxel::cli
