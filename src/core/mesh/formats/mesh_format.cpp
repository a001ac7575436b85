#include "core/mesh/formats/mesh_format.h"

namespace taxel {

const MeshFormat* find_mesh_format(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  for (const MeshFormat& format : kMeshFormats) {
    if (format.extension == extension) return &format;
  }
  for (const MeshFormat& format : kRefusedMeshFormats) {
    if (format.extension == extension) return &format;
  }
  return nullptr;
}

std::string extensions(bool (*has_property)(const MeshFormat&)) {
  std::string list;
  for (const MeshFormat& format : kMeshFormats) {
    if (!has_property(format)) continue;
    if (!list.empty()) list += ' ';
    list += format.extension;
  }
  return list;
}

}  // namespace taxel
