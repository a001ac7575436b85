// A recording as messages of ROS, without ROS: the field names of tactile_msgs/TactileState (github.com/ubi-agni/
// tactile_toolbox: std_msgs/Header header, sensor_msgs/ChannelFloat32[] sensors).
#pragma once

#include <string>

#include "core/run/recording/recording.h"

namespace taxel {

/// JSON Lines, a message a row:
/// {"header": {"seq": 0, "stamp": {"secs": 1, "nsecs": 250000000}, "frame_id": "world"},
///  "sensors": [{"name": "finger", "values": [...]}]}
/// One channel a sensor, named by its geom; values in the order of its taxels, as a device would report them: the
/// calibrated ones where its layout has a calibration, else the readings; rounded to single precision, as the message
/// has them. `seq` counts rows. Throws Error where a time is negative or too large for a stamp, or a value is not
/// finite.
std::string tactile_states(const Recording& recording);

}  // namespace taxel
