#include "core/hydro/fields/tet_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <span>
#include <utility>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/base/math.h"
#include "core/base/parallel.h"
#include "core/hydro/fields/pressure_field.h"
#include "core/mesh/formats/vtk.h"
#include "core/mesh/query/closest_point.h"

namespace taxel {
namespace {

struct SortedFace {
  std::array<int, 3> sorted;
  ivec3 outward;
  int tet;
};

/// All faces of all tets, each wound to face away from its tet, equal ones side by side.
std::vector<SortedFace> sorted_faces(const TetMesh& mesh) {
  constexpr std::array<std::array<int, 3>, 4> kOutward{{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};
  const int n = static_cast<int>(mesh.vertices.size());
  std::vector<SortedFace> faces;
  for (int t = 0; t < static_cast<int>(mesh.tets.size()); ++t) {
    ivec4 tet = mesh.tets[at(t)];
    for (int i = 0; i < 4; ++i) {
      if (tet[i] < 0 || tet[i] >= n) throw Error(fmt::format("tet {} has no vertex {} (there are {})", t, tet[i], n));
    }
    const dvec3& o = mesh.vertices[at(tet[0])];
    const double volume = glm::dot(glm::cross(mesh.vertices[at(tet[1])] - o, mesh.vertices[at(tet[2])] - o),
                                   mesh.vertices[at(tet[3])] - o);
    if (!(std::abs(volume) > 0)) throw Error(fmt::format("tet {} has no volume", t));
    if (volume < 0) std::swap(tet[2], tet[3]);
    for (const auto& corners : kOutward) {
      const ivec3 face(tet[corners[0]], tet[corners[1]], tet[corners[2]]);
      std::array<int, 3> sorted{face.x, face.y, face.z};
      std::sort(sorted.begin(), sorted.end());
      faces.push_back({sorted, face, t});
    }
  }
  std::sort(faces.begin(), faces.end(), [](const SortedFace& a, const SortedFace& b) {
    return std::tie(a.sorted, a.tet) < std::tie(b.sorted, b.tet);
  });
  return faces;
}

/// The outer faces, over all vertices of the mesh.
std::vector<ivec3> outer_faces(const TetMesh& mesh) {
  if (mesh.tets.empty()) throw Error("a tetrahedral mesh needs a tet");
  const std::vector<SortedFace> faces = sorted_faces(mesh);
  std::vector<ivec3> outer;
  for (std::size_t begin = 0, end = 0; begin < faces.size(); begin = end) {
    while (end < faces.size() && faces[end].sorted == faces[begin].sorted) ++end;
    if (end - begin > 2)
      throw Error(fmt::format("tets {}, {} and {} share one face", faces[begin].tet, faces[begin + 1].tet,
                              faces[begin + 2].tet));
    if (end - begin == 1) outer.push_back(faces[begin].outward);
  }
  return outer;
}

std::vector<double> depths(const TetMesh& mesh, const std::vector<ivec3>& outer, const TriMesh& boundary) {
  std::vector<char> on_boundary(mesh.vertices.size(), 0), used(mesh.vertices.size(), 0);
  for (const ivec3& f : outer) on_boundary[at(f.x)] = on_boundary[at(f.y)] = on_boundary[at(f.z)] = 1;
  for (const ivec4& t : mesh.tets) used[at(t[0])] = used[at(t[1])] = used[at(t[2])] = used[at(t[3])] = 1;
  const MeshIndex index(std::make_shared<const TriMesh>(boundary));
  std::vector<double> depth(mesh.vertices.size(), 0.0);
  constexpr int kChunk = 64;
  parallel_chunks(static_cast<int>(depth.size()), kChunk, [&](int begin, int end) {
    for (int v = begin; v < end; ++v) {
      if (used[at(v)] && !on_boundary[at(v)]) depth[at(v)] = index.closest_point(mesh.vertices[at(v)]).distance;
    }
  });
  return depth;
}

/// Returns `faces` with new vertex numbers, without the vertices that no face uses.
TriMesh compact(const std::vector<dvec3>& vertices, std::vector<ivec3> faces) {
  std::vector<int> number(vertices.size(), -1);
  std::vector<dvec3> kept;
  for (ivec3& f : faces) {
    for (int c = 0; c < 3; ++c) {
      int& n = number[at(f[c])];
      if (n < 0) {
        n = static_cast<int>(kept.size());
        kept.push_back(vertices[at(f[c])]);
      }
      f[c] = n;
    }
  }
  return {std::move(kept), std::move(faces)};
}

}  // namespace

TriMesh boundary_of(const TetMesh& mesh) {
  return compact(mesh.vertices, outer_faces(mesh));
}

PressureFieldPtr make_tet_field(const TetMesh& mesh, double modulus, double thickness) {
  if (!(modulus > 0) || !std::isfinite(modulus))
    throw Error(fmt::format("modulus of a soft body must be positive, not {}", modulus));
  std::vector<double> pressure = mesh.pressure;
  FieldReport report;
  if (pressure.empty()) {
    const std::vector<ivec3> outer = outer_faces(mesh);
    pressure = depths(mesh, outer, compact(mesh.vertices, outer));
    const double deepest = *std::max_element(pressure.begin(), pressure.end());
    if (!(deepest > 0)) throw Error("no vertex of the tetrahedral mesh lies inside of it: it has no pressure field");
    const double scale = thickness > 0 ? thickness : deepest;
    for (double& p : pressure) p = elastic_pressure(std::min(p, scale), scale, modulus);
    report.notes.push_back(fmt::format("p = E depth/H at the vertices, H = {:.4g} m", scale));
  } else {
    report.notes.push_back("the pressures stand in the file");
  }
  return std::make_shared<const PressureField>(mesh.vertices, mesh.tets, std::move(pressure), std::move(report));
}

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
