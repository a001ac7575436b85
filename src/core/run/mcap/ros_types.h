// The types of ROS 2 messages in an exported recording. Their definitions are in the file, so that readers need no
// package of message types.
#pragma once

#include <string>

namespace taxel {

enum class RosType { tactile_readings, tactile_contact, vector_stamped, pose_stamped, transforms };

/// Returns the name of a type, such as "geometry_msgs/msg/PoseStamped".
std::string ros_type_name(RosType type);

/// Returns the definition of a type as the schema encoding "ros2msg" has it: the fields, then the definition of each
/// type that the fields use, behind a line of 80 "=" and a line with its name.
std::string ros_type_definition(RosType type);

}  // namespace taxel
