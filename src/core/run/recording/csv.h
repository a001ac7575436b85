// A recording as text: `time,travel,force_x,force_y,force_z,area,polygons,taxel_<id>...`, SI units.
#pragma once

#include <string>

#include "core/run/recording/recording.h"

namespace taxel {

/// One header line, one line a row, every number in the shortest form that reads back exactly. With several sensors all
/// but time and travel are headed `<geom>/...`, sensor after sensor.
std::string recording_to_csv(const Recording& recording);

/// `time,travel,taxel_<id>...` of the sensors that have a calibration, in their calibrated values; empty: none has one.
std::string calibrated_to_csv(const Recording& recording);

/// `time,travel,taxel_<id>_e1,taxel_<id>_e2...` of the sensors whose layouts ask for shear, in the unit of their
/// readings; empty: none does.
std::string shear_to_csv(const Recording& recording);

}  // namespace taxel
