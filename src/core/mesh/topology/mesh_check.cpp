#include "core/mesh/topology/mesh_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "core/base/index.h"
#include "core/base/text/number_text.h"
#include "core/mesh/query/disjoint_sets.h"

namespace taxel {
namespace {

std::string middle_text(const TriMesh& mesh, std::span<const int> edge) {
  const int a = mesh.topology().low(edge[0]), b = mesh.topology().high(edge[0]);
  return place_in_mm(0.5 * (mesh.vertices()[at(a)] + mesh.vertices()[at(b)]));
}

const char* plural(std::size_t count) {
  return count == 1 ? "" : "s";
}

/// Open edges that are connected make one hole.
std::string holes_text(const TriMesh& mesh, const std::vector<std::span<const int>>& open) {
  const EdgeTopology& edges = mesh.topology();
  DisjointSets rims(at(mesh.vertex_count()));
  for (const auto& edge : open) rims.unite(edges.from(edge[0]), edges.to(edge[0]));
  std::set<int> holes;
  for (const auto& edge : open) holes.insert(rims.find(edges.from(edge[0])));
  return fmt::format("{} hole{}", holes.size(), plural(holes.size()));
}

void add_edge_problems(const TriMesh& mesh, const std::string& file, Problems& problems) {
  const EdgeTopology& edges = mesh.topology();
  const auto open = edges.edges_of(EdgeKind::boundary);
  if (!open.empty()) {
    problems.push_back({file, "", Severity::warning, "mesh_open",
                        fmt::format("{} open edge{} around {}, the first at {}", open.size(), plural(open.size()),
                                    holes_text(mesh, open), middle_text(mesh, open[0])),
                        "close the mesh: without an inside it has no pressure field"});
  }
  const auto bad = edges.edges_of(EdgeKind::nonmanifold);
  if (!bad.empty()) {
    problems.push_back({file, "", Severity::error, "mesh_nonmanifold",
                        fmt::format("{} edge{} with more than two faces, the first at {} ({} faces)", bad.size(),
                                    plural(bad.size()), middle_text(mesh, bad[0]), bad[0].size()),
                        "remove the inner faces there"});
  }
  const auto turned = edges.edges_of(EdgeKind::misoriented);
  if (!turned.empty()) {
    problems.push_back(
        {file, "", Severity::error, "mesh_winding",
         fmt::format("{} edge{} between faces that wind differently, the first at {} (faces {} and {})", turned.size(),
                     plural(turned.size()), middle_text(mesh, turned[0]), turned[0][0] / 3, turned[0][1] / 3),
         "orient the faces alike"});
  }
}

void check_shells(const TriMesh& mesh, const std::string& file, Problems& problems) {
  const std::vector<int> outer = outer_shells(mesh);
  if (mesh.closed() && mesh.volume() < 0) {
    problems.push_back({file, "", Severity::warning, "mesh_inverted",
                        fmt::format("the volume is negative ({:.6g} m^3): the normals point inward", mesh.volume()),
                        "flip the winding of its faces"});
  }
  std::vector<int> faces(at(mesh.shell_count()), 0);
  for (const int s : mesh.shell_of_face()) ++faces[at(s)];
  for (int s = 0; s < mesh.shell_count(); ++s) {
    if (std::binary_search(outer.begin(), outer.end(), s)) continue;
    problems.push_back({file, "", Severity::note, "mesh_cavity",
                        fmt::format("shell {} of {} ({} faces) is a closed cavity inside another shell", s,
                                    mesh.shell_count(), faces[at(s)]),
                        "nothing to do: no sample lies on it"});
  }
  if (outer.size() > 1) {
    problems.push_back({file, "", Severity::note, "mesh_shells", fmt::format("{} separate shells", outer.size()), ""});
  }
}

Problems all_problems(const TriMesh& mesh, const SelfIntersections& cuts, const std::string& file) {
  Problems problems;
  add_edge_problems(mesh, file, problems);
  check_shells(mesh, file, problems);
  for (Problem& p : check_cuts_and_size(mesh, cuts, file)) problems.push_back(std::move(p));
  return problems;
}

}  // namespace

Problems check_mesh(const TriMesh& mesh, const std::string& file) {
  return all_problems(mesh, find_self_intersections(mesh), file);
}

Problems check_mesh(const MeshIndex& index, const std::string& file) {
  return all_problems(index.mesh(), find_self_intersections(index.mesh(), index.tree()), file);
}

Problems check_cuts_and_size(const TriMesh& mesh, const SelfIntersections& cuts, const std::string& file) {
  Problems problems;
  if (cuts.pairs > 0) {
    constexpr double kFew = 1e-3;  // fraction of the faces
    const Severity severity = cuts.pairs > kFew * mesh.face_count() ? Severity::warning : Severity::note;
    problems.push_back(
        {file, "", severity, "mesh_self_intersection",
         fmt::format("{} pair{} of faces cut through each other, the first at {} (faces {} and {})", cuts.pairs,
                     plural(at(cuts.pairs)), place_in_mm(cuts.place), cuts.face_a, cuts.face_b),
         "unite the parts that overlap: nothing was repaired"});
  }
  const UnitGuess guess = guess_unit(mesh);
  if (guess.scale != 1) {
    const dvec3 size = mesh.bounds().extent();
    problems.push_back({file, "", Severity::warning, "mesh_units",
                        fmt::format("the mesh is {:.6g} x {:.6g} x {:.6g} m large: its unit is probably {}", size.x,
                                    size.y, size.z, guess.unit),
                        fmt::format("set the scale to {}", guess.scale)});
  }
  return problems;
}

Problems check_edges(const TriMesh& mesh, const std::string& file) {
  Problems problems;
  add_edge_problems(mesh, file, problems);
  return problems;
}

std::string openings(const TriMesh& mesh) {
  std::string text;
  for (const Problem& p : check_edges(mesh, "")) text += (text.empty() ? "" : "; ") + p.message;
  return text;
}

UnitGuess guess_unit(const TriMesh& mesh) {
  const dvec3 size = mesh.bounds().extent();
  return std::max({size.x, size.y, size.z}) > 1.0 ? UnitGuess{"mm", 0.001} : UnitGuess{"m", 1.0};
}

TriMesh flipped(const TriMesh& mesh) {
  std::vector<ivec3> faces = mesh.faces();
  for (ivec3& f : faces) std::swap(f.y, f.z);
  return {mesh.vertices(), std::move(faces)};
}

}  // namespace taxel
