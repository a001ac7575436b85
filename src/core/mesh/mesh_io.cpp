#include "core/mesh/mesh_io.h"

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/base/hash.h"
#include "core/mesh/formats/mesh_format.h"
#include "core/mesh/topology/weld.h"

namespace taxel {
namespace fs = std::filesystem;
namespace {

const MeshFormat& format_to_read(const fs::path& path) {
  const MeshFormat* format = find_mesh_format(path);
  if (format == nullptr || !can_read(*format))
    throw Error(path.string(), "unknown mesh format; known are " + extensions(can_read));
  return *format;
}

}  // namespace

LoadedMesh load_mesh(const fs::path& path, const dvec3& scale, const Progress* progress) {
  (void)format_to_read(path);  // a file of an unknown format is not opened
  return read_mesh(read_file(path), path, scale, progress);
}

LoadedMesh read_mesh(std::string_view bytes, const fs::path& path, const dvec3& scale, const Progress* progress) {
  const std::string file = path.string();
  const MeshFormat& format = format_to_read(path);
  const auto stop_if_cancelled = [&] {
    if (progress != nullptr) progress->stop_if_cancelled();
  };
  stop_if_cancelled();
  if (bytes.empty()) throw Error(file, "is empty");
  LoadedMesh loaded;
  loaded.sha256 = sha256_hex(bytes);
  const PolygonSoup soup = format.read(bytes, file);
  stop_if_cancelled();
  try {
    loaded.mesh = std::make_shared<const TriMesh>(weld(soup, scale, loaded.notes, &loaded.file_face_of));
  } catch (const Error& error) {
    throw Error(file, error.where(), error.message());
  }
  stop_if_cancelled();
  return loaded;
}

bool is_mesh_file(const fs::path& path) {
  const MeshFormat* format = find_mesh_format(path);
  return format != nullptr && can_read(*format);
}

void save_mesh(const fs::path& path, const TriMesh& mesh) {
  const MeshFormat* format = find_mesh_format(path);
  if (format == nullptr || !can_write(*format))
    throw Error(path.string(), "unknown mesh format to write; known are " + extensions(can_write));
  write_file_atomically(path, format->write(mesh));
}

}  // namespace taxel
