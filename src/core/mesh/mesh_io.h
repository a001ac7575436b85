// Reads and writes mesh files in the formats of formats/mesh_format.h.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/progress.h"
#include "core/mesh/tri_mesh.h"

namespace taxel {

/// A mesh from a file, and a record of the changes made while reading.
struct LoadedMesh {
  TriMeshPtr mesh;
  std::string sha256;  ///< hash of the file's bytes, without the separate buffers of a .gltf
  /// For each face, the index of its triangle in the file. A polygon counts as the triangles that it is cut into.
  std::vector<int> file_face_of;
  std::vector<std::string> notes;  ///< changes, such as "welded 12 duplicate vertices"
};

/// Reads a mesh in the format of its extension (any case) and multiplies its coordinates by `scale`. A negative product
/// of the three factors reverses the corners of each face. Vertices at the same place are welded (STL, texture seams),
/// faces without area and repeated faces are dropped, polygons are cut into triangles; LoadedMesh::notes lists each of
/// these changes. Safe to call from several threads. `progress`, if given, gets the fraction of the work, and is
/// checked for cancellation. Throws Error naming the file if the file is missing, has an unknown extension, is damaged,
/// has a coordinate that is not finite, or has no triangles; throws Cancelled.
LoadedMesh load_mesh(const std::filesystem::path& path, const dvec3& scale = dvec3(1.0), Progress* progress = nullptr);

/// Reads a mesh from bytes in memory, as load_mesh() does from a file, and throws the same errors. `path` gives the
/// format and is named in messages; the buffers of a .gltf are read from its folder.
LoadedMesh read_mesh(std::string_view bytes, const std::filesystem::path& path, const dvec3& scale = dvec3(1.0),
                     Progress* progress = nullptr);

/// Returns about which fraction of the work on a new document load_mesh() is, by the size of the file, from 0.1 to 0.8.
double fraction_of_loading(const std::filesystem::path& path);

/// Returns true for the extensions that load_mesh() reads.
bool is_mesh_file(const std::filesystem::path& path);

/// Writes a mesh in the format of its extension, atomically. Throws Error naming the file if the format has no writer
/// or the file cannot be written.
void save_mesh(const std::filesystem::path& path, const TriMesh& mesh);

}  // namespace taxel
