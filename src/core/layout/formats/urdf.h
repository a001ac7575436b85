// Poses of URDF, and the mesh of a link.
#pragma once

#include <optional>
#include <string>

#include "core/base/math.h"
#include "core/layout/formats/text.h"

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

struct LinkMesh {
  std::string name;               ///< name in the file: package://hand/meshes/tip.stl
  dvec3 scale{1};                 ///< factors of its coordinates
  UrdfPose in_link;               ///< x_link = in_link * x_mesh, where x_mesh is scaled
  std::string place;              ///< place for messages
  bool has_other_visual = false;  ///< true if the link also shows another mesh, or the same one in another pose
};

/// Returns the mesh with which a link collides, or else the one that it shows; nothing if it has none. Throws Error
/// naming file and line.
std::optional<LinkMesh> mesh_of_link(const XmlNode& link);

/// Returns the file of a mesh: of a relative name next to the URDF, of package://NAME/PATH in the folder NAME next to
/// the URDF or to one of the folders above it, or PATH in these folders. Empty if there is no such file.
std::string find_link_mesh(const std::string& name, const std::string& urdf);

}  // namespace taxel
