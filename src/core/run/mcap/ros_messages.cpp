#include "core/run/mcap/ros_messages.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/run/mcap/cdr_writer.h"

namespace taxel {
namespace {

CdrWriter begin_message(const RosHeader& header) {
  CdrWriter writer;
  writer.add(header.stamp.sec);
  writer.add(header.stamp.nanosec);
  writer.add(header.frame);
  return writer;
}

void add_ros_vector(CdrWriter& writer, const dvec3& vector) {
  for (const double number : {vector.x, vector.y, vector.z}) writer.add(number);
}

/// Adds geometry_msgs/Pose or geometry_msgs/Transform, which have the same numbers.
void add_ros_pose(CdrWriter& writer, const Pose& pose) {
  add_ros_vector(writer, pose.p);
  for (const double number : {pose.q.x, pose.q.y, pose.q.z, pose.q.w}) writer.add(number);
}

}  // namespace

RosStamp ros_stamp(double time) {
  constexpr std::int64_t kSecond = 1'000'000'000;
  constexpr double kMaxSeconds = std::numeric_limits<std::int32_t>::max();
  if (!(time >= 0 && time < kMaxSeconds))
    throw Error("", "time",
                fmt::format("must be 0 to {:.0f} s in a message of ROS 2, is {} s: use CSV or NPZ", kMaxSeconds, time));
  const std::int64_t nanoseconds = std::llround(time * static_cast<double>(kSecond));
  return {static_cast<std::int32_t>(nanoseconds / kSecond), static_cast<std::uint32_t>(nanoseconds % kSecond)};
}

std::string readings_message(const RosHeader& header, const TaxelNames& taxels, std::span<const double> values) {
  CdrWriter writer = begin_message(header);
  writer.add(std::string_view(taxels.sensor));
  writer.add(std::string_view(taxels.unit));
  writer.add_list(std::span<const std::int32_t>(taxels.ids));
  writer.add_list(taxels.names);
  writer.add_list(values);
  return writer.take();
}

std::string contact_message(const RosHeader& header, const ContactNumbers& contact) {
  CdrWriter writer = begin_message(header);
  for (const double number : {contact.time, contact.travel, contact.area}) writer.add(number);
  writer.add(contact.polygons);
  return writer.take();
}

std::string vector_message(const RosHeader& header, const dvec3& vector) {
  CdrWriter writer = begin_message(header);
  add_ros_vector(writer, vector);
  return writer.take();
}

std::string pose_message(const RosHeader& header, const Pose& pose) {
  CdrWriter writer = begin_message(header);
  add_ros_pose(writer, pose);
  return writer.take();
}

std::string transforms_message(const RosHeader& header, std::span<const FramePose> frames) {
  CdrWriter writer;
  writer.add(static_cast<std::uint32_t>(frames.size()));
  for (const FramePose& frame : frames) {
    writer.add(header.stamp.sec);
    writer.add(header.stamp.nanosec);
    writer.add(header.frame);
    writer.add(frame.child);
    add_ros_pose(writer, frame.pose);
  }
  return writer.take();
}

}  // namespace taxel
