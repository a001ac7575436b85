#include "core/layout/formats/urdf/link_mesh.h"

#include <filesystem>
#include <vector>

namespace taxel {
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
