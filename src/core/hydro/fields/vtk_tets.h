// Reads and writes tetrahedral meshes as legacy VTK files, the format of Drake, Gmsh and PyVista.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/hydro/fields/tet_mesh.h"

namespace taxel {

/// Reads an unstructured grid whose cells are tets (type 10), ASCII or BINARY, of version 1 to 5.1. Point data of one
/// component named `pressure` are the mesh's pressures [Pa]; other data are ignored. Points are multiplied by `scale`.
/// Throws Error naming file and place if the file is of another format or damaged, has another data set or cell (a
/// surface with the ways to make a body of it), or if an index is out of range or a number is not valid or not finite.
TetMesh read_vtk_tets(std::string_view bytes, const std::string& file, const dvec3& scale = dvec3(1.0));
TetMesh load_vtk_tets(const std::filesystem::path& path, const dvec3& scale = dvec3(1.0));

/// Returns a field as the text of such a file, with its pressures. Numbers are in the shortest form that reads back
/// exactly.
std::string vtk_text(const PressureField& field);

}  // namespace taxel
