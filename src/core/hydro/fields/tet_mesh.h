// A given tetrahedral mesh, the pressure field on it, and its files: legacy VTK, the format of Drake, Gmsh and PyVista.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/hydro/fields/pressure_field.h"

namespace taxel {

struct TetMesh {
  std::vector<dvec3> vertices;   ///< positions [m]
  std::vector<ivec4> tets;       ///< four vertices each, in any orientation
  std::vector<double> pressure;  ///< pressures at the vertices [Pa]; empty if the mesh has none
};
using TetMeshPtr = std::shared_ptr<const TetMesh>;

/// Returns the faces that belong to only one tet, outward, with the vertices that they use. Throws Error naming the tet
/// if an index is out of range, three tets share a face, or a tet has no volume; throws Error if there is no tet.
TriMesh boundary_of(const TetMesh& mesh);

/// Builds the field with the pressures of the mesh. Without them p = E min(depth, H)/H, where the depth is the distance
/// of a vertex to the boundary, and H is `thickness`, or the depth of the deepest vertex if `thickness` is 0 (Drake's
/// field of a mesh). Throws Error as boundary_of(), and if no vertex is inside or the modulus is not positive.
PressureFieldPtr make_tet_field(const TetMesh& mesh, double modulus, double thickness);

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
