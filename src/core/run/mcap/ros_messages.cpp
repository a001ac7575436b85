#include "core/run/mcap/ros_messages.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/base/text/json.h"

namespace taxel {
namespace {

bool is_ascii_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}
bool is_ascii_digit(char c) {
  return c >= '0' && c <= '9';
}

}  // namespace

std::string RosNames::add(std::string_view name) {
  std::string base;
  for (const char c : name) {
    if (is_ascii_letter(c) || is_ascii_digit(c))
      base += c;
    else if (!base.empty() && base.back() != '_')
      base += '_';
  }
  while (base.ends_with('_')) base.pop_back();
  if (base.empty()) base = "geom";
  if (is_ascii_digit(base.front())) base = "geom_" + base;
  std::string chosen = base;
  for (int number = 2; !taken_.insert(chosen).second; ++number) chosen = base + "_" + std::to_string(number);
  return chosen;
}

std::string utf8_or_marks(std::string_view text) {
  std::string valid(text);
  if (is_utf8(text)) return valid;
  std::ranges::replace_if(
      valid, [](char c) { return (static_cast<unsigned char>(c) & 0x80U) != 0; }, '?');
  return valid;
}

namespace {

/// A definition, whose fields may use the types that are listed behind it.
struct RosDefinition {
  std::string_view name;
  std::string_view fields;
};

// Names and types of the fields are those of ROS 2 where the package is one of ROS 2. taxel_msgs is ours.
constexpr std::array<RosDefinition, 13> kRosDefinitions{{
    {"taxel_msgs/TactileReadings", R"(# Values of all taxels of one sensor at one time.
# The time since the start of the run, and the frame of the sensor's mesh.
std_msgs/Header header
# Name of the sensor's geom in the scene.
string sensor
# Unit of the values, such as Pa or N.
string unit
# Ids of the taxels in the layout, in the order of the values.
int32[] ids
# Names of the taxels; taxel_ID for a taxel without a name.
string[] names
float64[] values
)"},
    {"taxel_msgs/TactileContact", R"(# The contact of one sensor at one time.
std_msgs/Header header
# Time since the start of the run, not rounded to nanoseconds [s].
float64 time
# Distance that the mocap body has moved [m].
float64 travel
# Area of the contact surfaces [m^2].
float64 area
# Number of polygons of the contact surfaces.
uint32 polygons
)"},
    {"geometry_msgs/Vector3Stamped", "std_msgs/Header header\ngeometry_msgs/Vector3 vector\n"},
    {"geometry_msgs/PoseStamped", "std_msgs/Header header\ngeometry_msgs/Pose pose\n"},
    {"tf2_msgs/TFMessage", "geometry_msgs/TransformStamped[] transforms\n"},
    {"geometry_msgs/TransformStamped",
     "std_msgs/Header header\nstring child_frame_id\ngeometry_msgs/Transform transform\n"},
    {"geometry_msgs/Transform", "geometry_msgs/Vector3 translation\ngeometry_msgs/Quaternion rotation\n"},
    {"geometry_msgs/Pose", "geometry_msgs/Point position\ngeometry_msgs/Quaternion orientation\n"},
    {"geometry_msgs/Point", "float64 x\nfloat64 y\nfloat64 z\n"},
    {"geometry_msgs/Vector3", "float64 x\nfloat64 y\nfloat64 z\n"},
    {"geometry_msgs/Quaternion", "float64 x 0\nfloat64 y 0\nfloat64 z 0\nfloat64 w 1\n"},
    {"std_msgs/Header", "builtin_interfaces/Time stamp\nstring frame_id\n"},
    {"builtin_interfaces/Time", "int32 sec\nuint32 nanosec\n"},
}};

/// Returns whether a definition has a field of the type `name`, or a list of it.
bool has_field_of(const RosDefinition& definition, std::string_view name) {
  for (const char* end : {" ", "[] "}) {
    const std::string begin = std::string(name) + end;
    if (definition.fields.starts_with(begin) || definition.fields.find("\n" + begin) != std::string_view::npos)
      return true;
  }
  return false;
}

/// The first definitions are in the order of RosType.
const RosDefinition& definition_of(RosType type) {
  return kRosDefinitions[static_cast<std::size_t>(type)];
}

}  // namespace

std::string ros_type_name(RosType type) {
  std::string name(definition_of(type).name);
  return name.replace(name.find('/'), 1, "/msg/");
}

std::string ros_type_definition(RosType type) {
  std::vector<const RosDefinition*> used{&definition_of(type)};
  std::string text(used.front()->fields);
  // A type is listed behind all types that use it, so one pass finds all.
  for (const RosDefinition& other : kRosDefinitions) {
    if (std::ranges::none_of(used, [&](const RosDefinition* user) { return has_field_of(*user, other.name); }))
      continue;
    used.push_back(&other);
    text.append(80, '=').append("\nMSG: ").append(other.name).append("\n").append(other.fields);
  }
  return text;
}

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
