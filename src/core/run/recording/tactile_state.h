// Writes a recording as ROS messages, without ROS. The fields are those of tactile_msgs/TactileState
// (github.com/ubi-agni/tactile_toolbox: std_msgs/Header header, sensor_msgs/ChannelFloat32[] sensors).
#pragma once

#include <string>

#include "core/run/recording/recording.h"

namespace taxel {

/// Returns the messages as JSON Lines, one message for each row:
/// {"header": {"seq": 0, "stamp": {"secs": 1, "nsecs": 250000000}, "frame_id": "world"},
///  "sensors": [{"name": "finger", "values": [...]}]}
/// Each sensor is a channel, named by its geom. Its values are in the order of its taxels: calibrated values if its
/// layout has a calibration, otherwise readings, rounded to the single precision of the message. `seq` counts rows.
/// Throws Error if a time is negative or too large for a stamp, or if a value is not finite.
std::string tactile_states(const Recording& recording);

}  // namespace taxel
