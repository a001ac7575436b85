// glTF 2.0 and GLB, by tinygltf.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/mesh/formats/polygon_soup.h"
#include "core/mesh/tri_mesh.h"

namespace taxel {

/// All triangles (lists, strips, fans) of all meshes of the file's scene, each moved by its node's transform. Images,
/// points and lines are passed over. Buffers beside the file are read from its folder.
/// Throws Error naming the file: broken, an accessor out of range, compressed or sparse positions.
PolygonSoup read_gltf(std::string_view bytes, const std::filesystem::path& path);

/// The bytes of a GLB with one mesh: positions (float), vertex normals and indices.
std::string write_glb(const TriMesh& mesh);

}  // namespace taxel
