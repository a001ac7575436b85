// Mesh files: OBJ, STL, PLY, OFF (formats/, in double precision, errors by line), glTF and GLB (gltf_io.h).
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/progress.h"
#include "core/mesh/tri_mesh.h"

namespace taxel {

/// A mesh as read, and what was done to it on the way.
struct LoadedMesh {
  TriMeshPtr mesh;
  std::string sha256;  ///< of the file's bytes (of a .gltf without its separate buffers)
  /// For each face the number of its triangle in the file, from 0, polygons counting as the triangles they are cut
  /// into.
  std::vector<int> file_face_of;
  std::vector<std::string> notes;  ///< "welded 12 duplicate vertices", "dropped 3 faces of zero area (first: 17)", ...
};

/// Reads a mesh by its extension (.obj .stl .ply .off .gltf .glb, any case) and multiplies by `scale`; a negative
/// product of the scale flips the winding. Vertices at the same place are welded (STL, texture seams), faces without
/// area and repeated faces dropped, polygons fanned; each is noted. Safe to call from several threads.
/// Throws Error naming the file: missing, unknown extension, broken, NaN vertex, no triangles; Cancelled through
/// `progress`, which is asked between the parts of the work and told nothing.
LoadedMesh load_mesh(const std::filesystem::path& path, const dvec3& scale = dvec3(1.0),
                     const Progress* progress = nullptr);

/// The same of the bytes of a file; `path` gives the format, names the file in messages, and its folder has the buffers
/// of a .gltf.
LoadedMesh read_mesh(std::string_view bytes, const std::filesystem::path& path, const dvec3& scale = dvec3(1.0),
                     const Progress* progress = nullptr);

/// True for the extensions that load_mesh reads.
bool is_mesh_file(const std::filesystem::path& path);

/// A mesh as the text of an OBJ file, shortest round-trip numbers: what save_mesh writes to `.obj`.
std::string obj_text(const TriMesh& mesh);

/// Writes OBJ, OFF, STL (binary) or GLB by extension, atomically; OBJ and OFF in shortest round-trip numbers, STL and
/// GLB in float. Throws Error naming the file.
void save_mesh(const std::filesystem::path& path, const TriMesh& mesh);

}  // namespace taxel
