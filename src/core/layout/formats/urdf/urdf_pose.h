// Poses of URDF.
#pragma once

#include "core/base/math.h"
#include "core/layout/formats/text/xml_node.h"

namespace taxel {

/// A pose: x_parent = turn x + shift.
struct UrdfPose {
  dmat3 turn{1.0};
  dvec3 shift{0};
};

/// Returns the pose of the attributes xyz [m] and rpy [rad], rotations about the fixed axes x, y and z in this order.
UrdfPose pose_of(const XmlNode& node);

/// Returns the pose of the element's <origin>, or no motion if there is none.
UrdfPose origin_of(const XmlNode& node);

inline UrdfPose operator*(const UrdfPose& a, const UrdfPose& b) {
  return {a.turn * b.turn, a.turn * b.shift + a.shift};
}

inline UrdfPose inverse(const UrdfPose& pose) {
  const dmat3 back = glm::transpose(pose.turn);
  return {back, -(back * pose.shift)};
}

}  // namespace taxel
