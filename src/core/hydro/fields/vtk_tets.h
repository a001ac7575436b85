// Tetrahedral meshes as legacy VTK files, ASCII: what Drake, Gmsh and PyVista write and read.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/hydro/fields/tet_mesh.h"

namespace taxel {

/// Reads an unstructured grid whose cells are tets (type 10); point data of one component named `pressure` become the
/// mesh's pressures [Pa], other data are passed over. Points are multiplied by `scale`. Throws Error naming file and
/// line: not such a file, binary, another data set or cell, an index out of range, a number that is none or not finite,
/// cut off.
TetMesh read_vtk_tets(std::string_view text, const std::string& file, const dvec3& scale = dvec3(1.0));
TetMesh load_vtk_tets(const std::filesystem::path& path, const dvec3& scale = dvec3(1.0));

/// A field as such a file, with its pressures; shortest numbers that read back exactly.
std::string vtk_text(const PressureField& field);

}  // namespace taxel
