#include "core/mesh/mesh_io.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/base/parallel.h"
#include "core/mesh/formats/mesh_format.h"
#include "core/mesh/formats/polygon_soup.h"

namespace taxel {
namespace fs = std::filesystem;
namespace {

const MeshFormat& format_to_read(const fs::path& path) {
  const MeshFormat* format = find_mesh_format(path);
  if (format == nullptr || !can_read(*format))
    throw Error(path.string(), "unknown mesh format; known are " + extensions(can_read));
  return *format;
}

// Fractions of the time of load_mesh() after which its parts end, for an STL file of 2 million triangles.
constexpr double kRead = 0.05, kParsed = 0.35;

void check(Progress* progress, double fraction) {
  if (progress != nullptr) progress->check(fraction);
}

/// Reads the triangles and, on another core, the hash of the bytes.
PolygonSoup read_soup(std::string_view bytes, const MeshFormat& format, const std::string& file, LoadedMesh& loaded,
                      Progress* progress) {
  if (progress != nullptr) progress->set_step("Reading triangles");
  check(progress, kRead);
  if (bytes.empty()) throw Error(file, "is empty");
  PolygonSoup soup;
  parallel_all([&] { soup = format.read(bytes, file); }, [&] { loaded.sha256 = sha256_hex(bytes); });
  check(progress, kParsed);
  return soup;
}

void weld_soup(PolygonSoup soup, const std::string& file, const dvec3& scale, LoadedMesh& loaded, Progress* progress) {
  if (progress != nullptr) progress->set_step("Welding vertices");
  for (const std::string& note : soup.notes) loaded.notes.push_back(note);
  try {
    loaded.mesh = std::make_shared<const TriMesh>(weld(std::move(soup), scale, loaded.notes, &loaded.file_face_of));
  } catch (const Error& error) {
    throw Error(file, error.where(), error.message());
  }
  check(progress, 1);
}

}  // namespace

LoadedMesh load_mesh(const fs::path& path, const dvec3& scale, Progress* progress) {
  const MeshFormat& format = format_to_read(path);  // a file of an unknown format is not opened
  LoadedMesh loaded;
  // The file's bytes are freed before the faces are welded, which takes the most memory.
  PolygonSoup soup = read_soup(read_file(path), format, path.string(), loaded, progress);
  weld_soup(std::move(soup), path.string(), scale, loaded, progress);
  return loaded;
}

LoadedMesh read_mesh(std::string_view bytes, const fs::path& path, const dvec3& scale, Progress* progress) {
  const MeshFormat& format = format_to_read(path);
  LoadedMesh loaded;
  weld_soup(read_soup(bytes, format, path.string(), loaded, progress), path.string(), scale, loaded, progress);
  return loaded;
}

double fraction_of_loading(const fs::path& path) {
  constexpr double kLarge = 50e6;  // bytes of a file that takes about as long to read as to inspect and compile
  std::error_code failed;
  const std::uintmax_t bytes = fs::file_size(path, failed);
  return failed ? 0.1 : std::clamp(0.5 * static_cast<double>(bytes) / kLarge, 0.1, 0.8);
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
