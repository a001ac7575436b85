// ROS 2 messages as bytes in the Common Data Representation (CDR, little endian, of OMG's DDS-RTPS 2.3), with their
// types and the names of topics and frames.
#pragma once

#include <concepts>
#include <cstdint>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/math.h"

namespace taxel {

template <class Number>
concept CdrNumber =
    std::same_as<Number, std::int32_t> || std::same_as<Number, std::uint32_t> || std::same_as<Number, double>;

/// Appends the fields of one message in their order. Each number begins at a multiple of its size behind the head of
/// four bytes, which says that the message is plain and little endian.
class CdrWriter {
 public:
  CdrWriter() : bytes_("\0\1\0\0", kHeadBytes) {}  // plain CDR, little endian, no options
  void add(CdrNumber auto value) {
    align(sizeof value);
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  /// Appends a text with its length and a closing zero.
  void add(std::string_view text) {
    add(static_cast<std::uint32_t>(text.size() + 1));
    bytes_.append(text);
    bytes_ += '\0';
  }
  /// Appends a list of any length: the number of elements, then the elements.
  template <CdrNumber Number>
  void add_list(std::span<const Number> values) {
    add(static_cast<std::uint32_t>(values.size()));
    if (values.empty()) return;
    align(sizeof(Number));
    bytes_.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
  }
  void add_list(std::span<const std::string> texts) {
    add(static_cast<std::uint32_t>(texts.size()));
    for (const std::string& text : texts) add(std::string_view(text));
  }

  /// Returns the message. The object is empty afterwards.
  [[nodiscard]] std::string take() { return std::move(bytes_); }

 private:
  static constexpr std::size_t kHeadBytes = 4;

  void align(std::size_t size) {
    while ((bytes_.size() - kHeadBytes) % size != 0) bytes_ += '\0';
  }

  std::string bytes_;
};

/// Gives each name a part of a topic that ROS 2 accepts and no other name has: letters, digits and single underscores,
/// the first of them a letter.
class RosNames {
 public:
  /// Returns "thumb_tip" for "thumb tip", and "thumb_tip_2" if that is taken; "geom_3" for "3"; "geom" for "".
  std::string add(std::string_view name);

 private:
  std::set<std::string> taken_;
};

/// Returns a text that is valid UTF-8, as messages and records need it. In any other text each byte that is not ASCII
/// becomes "?".
std::string utf8_or_marks(std::string_view text);

/// The types of messages in an exported recording. Their definitions are in the file, so that readers need no package
/// of message types.
enum class RosType { tactile_readings, tactile_contact, vector_stamped, pose_stamped, transforms };

/// Returns the name of a type, such as "geometry_msgs/msg/PoseStamped".
std::string ros_type_name(RosType type);

/// Returns the definition of a type as the schema encoding "ros2msg" has it: the fields, then the definition of each
/// type that the fields use, behind a line of 80 "=" and a line with its name.
std::string ros_type_definition(RosType type);

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
