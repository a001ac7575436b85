// ROS 2 messages as bytes in the Common Data Representation.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/math.h"

namespace taxel {

/// A time since the start of a run, in the form of builtin_interfaces/Time.
struct RosStamp {
  std::int32_t sec = 0;
  std::uint32_t nanosec = 0;
  [[nodiscard]] std::uint64_t nanoseconds() const { return static_cast<std::uint64_t>(sec) * 1'000'000'000U + nanosec; }
};
/// Returns a time in seconds, rounded to nanoseconds. Throws Error if it is negative, not finite, or too large.
RosStamp ros_stamp(double time);

/// Time and coordinate frame of a message (std_msgs/Header).
struct RosHeader {
  RosStamp stamp;
  std::string_view frame;
};

/// The fields of taxel_msgs/TactileReadings that are the same in all messages of a topic.
struct TaxelNames {
  std::string sensor;  ///< name of the sensor's geom
  std::string unit;
  std::vector<std::int32_t> ids;
  std::vector<std::string> names;  ///< parallel to `ids`
};
/// Returns taxel_msgs/TactileReadings. `values` is parallel to the ids.
std::string readings_message(const RosHeader& header, const TaxelNames& taxels, std::span<const double> values);

/// Numbers of taxel_msgs/TactileContact.
struct ContactNumbers {
  double time = 0;    ///< [s]
  double travel = 0;  ///< [m]
  double area = 0;    ///< [m^2]
  std::uint32_t polygons = 0;
};
std::string contact_message(const RosHeader& header, const ContactNumbers& contact);

/// Returns geometry_msgs/Vector3Stamped: a vector in the frame of the header.
std::string vector_message(const RosHeader& header, const dvec3& vector);
/// Returns geometry_msgs/PoseStamped: a pose in the frame of the header. ROS writes quaternions as x y z w.
std::string pose_message(const RosHeader& header, const Pose& pose);

/// The pose of a frame in the frame of the message's header.
struct FramePose {
  std::string_view child;  ///< name of the frame
  Pose pose;
};
/// Returns tf2_msgs/TFMessage.
std::string transforms_message(const RosHeader& header, std::span<const FramePose> frames);

}  // namespace taxel
