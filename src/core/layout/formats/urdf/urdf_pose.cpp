#include "core/layout/formats/urdf/urdf_pose.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/limits.h"

namespace taxel {

UrdfPose pose_of(const XmlNode& node) {
  const dvec3 rpy = node.vector("rpy", dvec3(0));
  if (const double most = std::max({std::abs(rpy.x), std::abs(rpy.y), std::abs(rpy.z)}); most > kMaxAngle)
    node.fail(fmt::format("must be angles of at most {:g} rad, one is {:g}", kMaxAngle, most), "rpy");
  const double cr = std::cos(rpy.x), sr = std::sin(rpy.x), cp = std::cos(rpy.y), sp = std::sin(rpy.y),
               cy = std::cos(rpy.z), sy = std::sin(rpy.z);
  UrdfPose pose;
  pose.turn = dmat3(dvec3(cy * cp, sy * cp, -sp), dvec3(cy * sp * sr - sy * cr, sy * sp * sr + cy * cr, cp * sr),
                    dvec3(cy * sp * cr + sy * sr, sy * sp * cr - cy * sr, cp * cr));
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row)
      if (std::abs(pose.turn[column][row]) < 1e-15) pose.turn[column][row] = 0;  // the cosine of a rounded right angle
  pose.shift = node.vector("xyz", dvec3(0));
  return pose;
}

UrdfPose origin_of(const XmlNode& node) {
  const std::optional<XmlNode> origin = node.child("origin");
  return origin ? pose_of(*origin) : UrdfPose{};
}

}  // namespace taxel
