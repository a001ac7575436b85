#include "core/mesh/mesh_io.h"

#include <fmt/format.h>

#include <array>
#include <cstring>
#include <utility>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/base/hash.h"
#include "core/mesh/formats/gltf_io.h"
#include "core/mesh/formats/polygon_soup.h"
#include "core/mesh/topology/weld.h"

namespace taxel {
namespace fs = std::filesystem;
namespace {

using Reader = PolygonSoup (*)(std::string_view, const std::string&);

PolygonSoup read_gltf_file(std::string_view bytes, const std::string& file) {
  return read_gltf(bytes, file);
}

constexpr std::array<std::pair<std::string_view, Reader>, 6> kReaders{{{".obj", read_obj},
                                                                       {".stl", read_stl},
                                                                       {".ply", read_ply},
                                                                       {".off", read_off},
                                                                       {".gltf", read_gltf_file},
                                                                       {".glb", read_gltf_file}}};

std::string lower_extension(const fs::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return extension;
}

Reader reader_for(const fs::path& path) {
  const std::string extension = lower_extension(path);
  for (const auto& [name, reader] : kReaders) {
    if (name == extension) return reader;
  }
  return nullptr;
}

[[noreturn]] void throw_unknown(const fs::path& path) {
  throw Error(path.string(), "unknown mesh format; known are .obj .stl .ply .off .gltf .glb");
}

std::string off_text(const TriMesh& mesh) {
  std::string text = fmt::format("OFF\n{} {} 0\n", mesh.vertex_count(), mesh.face_count());
  for (const dvec3& v : mesh.vertices()) text += fmt::format("{} {} {}\n", v.x, v.y, v.z);
  for (const ivec3& f : mesh.faces()) text += fmt::format("3 {} {} {}\n", f.x, f.y, f.z);
  return text;
}

std::string stl_bytes(const TriMesh& mesh) {
  std::string bytes(84, '\0');
  const std::string comment = "binary STL by Taxel Studio";
  std::copy(comment.begin(), comment.end(), bytes.begin());
  const auto count = static_cast<std::uint32_t>(mesh.face_count());
  std::memcpy(bytes.data() + 80, &count, sizeof count);
  for (int f = 0; f < mesh.face_count(); ++f) {
    const std::array<glm::vec3, 4> numbers{glm::vec3(mesh.face_normals()[static_cast<std::size_t>(f)]),
                                           glm::vec3(mesh.vertex(f, 0)), glm::vec3(mesh.vertex(f, 1)),
                                           glm::vec3(mesh.vertex(f, 2))};
    bytes.append(reinterpret_cast<const char*>(numbers.data()), sizeof numbers);
    bytes.append(2, '\0');
  }
  return bytes;
}

}  // namespace

LoadedMesh load_mesh(const fs::path& path, const dvec3& scale, const Progress* progress) {
  if (!is_mesh_file(path)) throw_unknown(path);
  return read_mesh(read_file(path), path, scale, progress);
}

LoadedMesh read_mesh(std::string_view bytes, const fs::path& path, const dvec3& scale, const Progress* progress) {
  const std::string file = path.string();
  const Reader reader = reader_for(path);
  if (reader == nullptr) throw_unknown(path);
  const auto stop_if_cancelled = [&] {
    if (progress != nullptr) progress->stop_if_cancelled();
  };
  stop_if_cancelled();
  if (bytes.empty()) throw Error(file, "is empty");
  LoadedMesh loaded;
  loaded.sha256 = sha256_hex(bytes);
  const PolygonSoup soup = reader(bytes, file);
  stop_if_cancelled();
  try {
    loaded.mesh = std::make_shared<const TriMesh>(weld(soup, scale, loaded.notes, &loaded.file_face_of));
  } catch (const Error& error) {
    throw Error(file, error.where(), error.message());
  }
  stop_if_cancelled();
  return loaded;
}

std::string obj_text(const TriMesh& mesh) {
  std::string text;
  for (const dvec3& v : mesh.vertices()) text += fmt::format("v {} {} {}\n", v.x, v.y, v.z);
  for (const ivec3& f : mesh.faces()) text += fmt::format("f {} {} {}\n", f.x + 1, f.y + 1, f.z + 1);
  return text;
}

bool is_mesh_file(const fs::path& path) {
  return reader_for(path) != nullptr;
}

void save_mesh(const fs::path& path, const TriMesh& mesh) {
  const std::string extension = lower_extension(path);
  if (extension == ".obj") return write_file_atomically(path, obj_text(mesh));
  if (extension == ".off") return write_file_atomically(path, off_text(mesh));
  if (extension == ".stl") return write_file_atomically(path, stl_bytes(mesh));
  if (extension == ".glb") return write_file_atomically(path, write_glb(mesh));
  throw Error(path.string(), "unknown mesh format to write; known are .obj .off .stl .glb");
}

}  // namespace taxel
