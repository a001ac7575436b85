// A recording as text: `time,travel,force_x,force_y,force_z,area,polygons,taxel_<id>...`, SI units. With error bars,
// columns `taxel_<id>_error...` follow, in the unit of the readings.
#pragma once

#include <string>

#include "core/run/recording/recording.h"

namespace taxel {

/// Returns the recording as one header line and one line for each row. Every number is in the shortest form that reads
/// back exactly. If there are several sensors, the names of all columns except time and travel begin with `<geom>/`,
/// sensor after sensor.
std::string recording_to_csv(const Recording& recording);

/// Returns a table `time,travel,taxel_<id>...` of the calibrated values of the sensors that have a calibration; empty
/// if no sensor has one.
std::string calibrated_to_csv(const Recording& recording);

/// Returns a table `time,travel,taxel_<id>_e1,taxel_<id>_e2...` of the sensors whose layouts have shear readings, in
/// the unit of their readings; empty if no layout has them.
std::string shear_to_csv(const Recording& recording);

/// Returns a table `time,travel,taxel_<id>...` of the share of each taxel's field that slips, from 0 to 1, of the
/// sensors whose friction sticks; empty if there are none.
std::string slip_to_csv(const Recording& recording);

}  // namespace taxel
