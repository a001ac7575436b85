#include "core/hydro/fields/tet_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "core/base/error.h"
#include "core/base/index.h"
#include "core/base/parallel.h"
#include "core/hydro/elastic_pressure.h"
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

}  // namespace taxel
