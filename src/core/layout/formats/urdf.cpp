// Poses by xyz and rpy, and the search for the mesh of a link.

#include "core/layout/formats/urdf.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <vector>

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

namespace {

namespace fs = std::filesystem;

std::optional<LinkMesh> mesh_of_shape(const XmlNode& shape) {
  const std::optional<XmlNode> geometry = shape.child("geometry");
  const std::optional<XmlNode> mesh = geometry ? geometry->child("mesh") : std::nullopt;
  if (!mesh) return std::nullopt;
  LinkMesh found;
  found.name = mesh->text("filename");
  found.place = mesh->place("filename");
  found.scale = mesh->vector("scale", dvec3(1));
  if (found.scale.x == 0 || found.scale.y == 0 || found.scale.z == 0) mesh->fail("must not be 0", "scale");
  found.in_link = origin_of(shape);
  return found;
}

std::optional<LinkMesh> first_mesh(const XmlNode& link, const std::string& kind) {
  for (const XmlNode& shape : link.children(kind))
    if (std::optional<LinkMesh> mesh = mesh_of_shape(shape)) return mesh;
  return std::nullopt;
}

/// Returns the text after the prefix, or nothing if the text does not begin with it.
std::optional<std::string> after(const std::string& text, const std::string& prefix) {
  if (!text.starts_with(prefix)) return std::nullopt;
  return text.substr(prefix.size());
}

/// Returns the path if it is a file, otherwise an empty one.
std::string path_of_file(const fs::path& path) {
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored)) return "";
  return fs::absolute(path, ignored).lexically_normal().string();
}

}  // namespace

std::optional<LinkMesh> mesh_of_link(const XmlNode& link) {
  const std::optional<LinkMesh> visual = first_mesh(link, "visual");
  std::optional<LinkMesh> mesh = first_mesh(link, "collision");
  if (!mesh) return visual;
  mesh->has_other_visual =
      visual && (visual->name != mesh->name || visual->scale != mesh->scale ||
                 visual->in_link.turn != mesh->in_link.turn || visual->in_link.shift != mesh->in_link.shift);
  return mesh;
}

std::string find_link_mesh(const std::string& name, const std::string& urdf) {
  constexpr int kMostFolders = 12;
  if (const std::optional<std::string> path = after(name, "file://")) return path_of_file(*path);
  std::error_code ignored;
  fs::path folder = fs::absolute(urdf, ignored).parent_path();
  std::optional<std::string> in_package = after(name, "package://");
  if (!in_package) in_package = after(name, "model://");
  if (!in_package) return path_of_file(folder / name);
  const std::size_t slash = in_package->find('/');
  const std::string below = slash == std::string::npos ? *in_package : in_package->substr(slash + 1);
  for (int i = 0; i < kMostFolders; ++i, folder = folder.parent_path()) {
    for (const std::string& tried : {*in_package, below})
      if (std::string path = path_of_file(folder / tried); !path.empty()) return path;
    if (folder == folder.root_path()) break;
  }
  return "";
}

}  // namespace taxel
