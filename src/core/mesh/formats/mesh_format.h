// The mesh file formats that are read or written, one row each.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>

#include "core/mesh/formats/polygon_soup.h"
#include "core/mesh/tri_mesh.h"

namespace taxel {

/// A mesh file format. A new format is a new file in this folder and a row of kMeshFormats.
struct MeshFormat {
  std::string_view extension;  ///< file name extension in lower case, with its dot
  std::string_view name;       ///< name of the format as shown to the user
  /// Reads a whole file that is in memory. `file` is its path: messages name the path, and a .gltf file's buffers are
  /// read from its folder. Throws Error naming the file and the line, byte or element. Null if the format is not read.
  PolygonSoup (*read)(std::string_view bytes, const std::string& file) = nullptr;
  /// Returns the bytes of a file. Throws Error if the mesh cannot be written. Null if the format is not written.
  std::string (*write)(const TriMesh& mesh) = nullptr;
};

PolygonSoup read_obj(std::string_view bytes, const std::string& file);
PolygonSoup read_stl(std::string_view bytes, const std::string& file);
PolygonSoup read_ply(std::string_view bytes, const std::string& file);
PolygonSoup read_off(std::string_view bytes, const std::string& file);
PolygonSoup read_gltf(std::string_view bytes, const std::string& file);  ///< .gltf and .glb: the bytes tell which
PolygonSoup read_vtk(std::string_view bytes, const std::string& file);   ///< legacy files of surfaces and volumes
/// Throws Error with the remedy: VTK's XML files are not read.
PolygonSoup refuse_vtk_xml(std::string_view bytes, const std::string& file);

std::string write_obj(const TriMesh& mesh);  ///< shortest numbers that read back unchanged
std::string write_off(const TriMesh& mesh);  ///< shortest numbers that read back unchanged
std::string write_stl(const TriMesh& mesh);  ///< binary STL with coordinates of type float
std::string write_glb(const TriMesh& mesh);  ///< one mesh: positions and vertex normals (float), indices

inline constexpr std::array kMeshFormats{MeshFormat{".obj", "OBJ", read_obj, write_obj},
                                         MeshFormat{".stl", "STL", read_stl, write_stl},
                                         MeshFormat{".ply", "PLY", read_ply},
                                         MeshFormat{".off", "OFF", read_off, write_off},
                                         MeshFormat{".gltf", "glTF", read_gltf},
                                         MeshFormat{".glb", "GLB", read_gltf, write_glb},
                                         MeshFormat{".vtk", "VTK", read_vtk}};

/// Formats whose files are refused with the remedy. They are found by their extension, but not listed.
inline constexpr std::array kRefusedMeshFormats{MeshFormat{".vtp", "VTK XML surface", refuse_vtk_xml},
                                                MeshFormat{".vtu", "VTK XML grid", refuse_vtk_xml}};

inline bool can_read(const MeshFormat& format) {
  return format.read != nullptr;
}
inline bool can_write(const MeshFormat& format) {
  return format.write != nullptr;
}

/// Returns the format of a file name's extension, in any case, one that is refused too; null if no row
/// has that extension.
const MeshFormat* find_mesh_format(const std::filesystem::path& path);

/// Returns the extensions of the formats with a property, such as ".obj .stl" for extensions(can_write).
std::string extensions(bool (*has_property)(const MeshFormat&));

}  // namespace taxel
