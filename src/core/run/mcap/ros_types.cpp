#include "core/run/mcap/ros_types.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

namespace taxel {
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

}  // namespace taxel
