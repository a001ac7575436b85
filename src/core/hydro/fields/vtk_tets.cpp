#include "core/hydro/fields/vtk_tets.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <span>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/mesh/formats/vtk_cells.h"
#include "core/mesh/formats/vtk_data.h"

namespace taxel {
namespace {

constexpr int kTet = 10;

/// Returns the reason why a cell that is no tet is no part of a body, with the remedy.
std::string refusal_of(int number) {
  const VtkCellType* type = find_vtk_cell_type(number);
  const std::string text = fmt::format("is of type {}{}, a tet is of type {}: ", number,
                                       type == nullptr ? "" : fmt::format(" ({})", type->name), kTet);
  if (type != nullptr && vtk_faces(type->straight).empty()) return text + "save the tets without other cells";
  if (type != nullptr && type->straight == kTet) return text + "save the tets with straight edges, of first order";
  return text + "cut the cells into tets (Tetrahedralize in ParaView)";
}

/// Throws Error if the file is a surface, with the ways to make a body of it.
void refuse_surface(const VtkData& data, const std::string& file) {
  const auto encloses_volume = [](int number) {
    const VtkCellType* type = find_vtk_cell_type(number);
    return type == nullptr || !vtk_faces(type->straight).empty();
  };
  if (!data.poly_data && std::any_of(data.types.begin(), data.types.end(), encloses_volume)) return;
  throw Error(file,
              "is a surface, a body of tets needs an UNSTRUCTURED_GRID of tets: fill the surface with tets (Gmsh, "
              "TetGen), or give it as a shape of type \"mesh\"");
}

}  // namespace

TetMesh read_vtk_tets(std::string_view bytes, const std::string& file, const dvec3& scale) {
  VtkData data = read_vtk_data(bytes, file, VtkAttributes::pressure);
  refuse_surface(data, file);
  TetMesh mesh;
  mesh.tets.reserve(data.types.size());
  for (std::size_t c = 0; c < data.types.size(); ++c) {
    if (data.types[c] != kTet) throw Error(file, fmt::format("cell {}", c), refusal_of(data.types[c]));
    const std::span<const int> corners = data.cell(c);
    if (corners.size() != 4)
      throw Error(file, fmt::format("cell {}", c), fmt::format("has {} corners, a tet has 4", corners.size()));
    mesh.tets.emplace_back(corners[0], corners[1], corners[2], corners[3]);
  }
  mesh.vertices = std::move(data.points);
  for (dvec3& vertex : mesh.vertices) vertex *= scale;
  mesh.pressure = std::move(data.pressure);
  return mesh;
}

TetMesh load_vtk_tets(const std::filesystem::path& path, const dvec3& scale) {
  return read_vtk_tets(read_file(path), path.string(), scale);
}

std::string vtk_text(const PressureField& field) {
  std::string text = "# vtk DataFile Version 3.0\nTaxel Studio pressure field\nASCII\nDATASET UNSTRUCTURED_GRID\n";
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "POINTS {} double\n", field.vertices().size());
  for (const dvec3& v : field.vertices()) fmt::format_to(out, "{} {} {}\n", v.x, v.y, v.z);
  fmt::format_to(out, "CELLS {} {}\n", field.tets().size(), 5 * field.tets().size());
  for (const Tet& tet : field.tets()) {
    const ivec4& v = tet.vertices;
    fmt::format_to(out, "4 {} {} {} {}\n", v[0], v[1], v[2], v[3]);
  }
  fmt::format_to(out, "CELL_TYPES {}\n", field.tets().size());
  for (std::size_t t = 0; t < field.tets().size(); ++t) text += "10\n";
  fmt::format_to(out, "POINT_DATA {}\nSCALARS pressure double 1\nLOOKUP_TABLE default\n", field.vertices().size());
  for (const double p : field.vertex_pressure()) fmt::format_to(out, "{}\n", p);
  return text;
}

}  // namespace taxel
