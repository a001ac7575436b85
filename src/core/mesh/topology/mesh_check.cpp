// The problems of edges, shells, intersections and size; directions of faces; and findings in words.

#include "core/mesh/topology/mesh_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/math.h"
#include "core/base/text/message.h"
#include "core/mesh/query/bvh.h"
#include "core/mesh/query/disjoint_sets.h"
#include "core/mesh/query/winding_number.h"
#include "core/mesh/tri_mesh.h"

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

namespace {

bool contains(const Aabb& outer, const Aabb& inner) {
  return glm::all(glm::lessThanEqual(outer.lo, inner.lo)) && glm::all(glm::lessThanEqual(inner.hi, outer.hi));
}

/// The shells of a mesh with their faces and boxes.
class ShellTree {
 public:
  explicit ShellTree(const TriMesh& mesh) : mesh_(mesh), faces_(at(mesh.shell_count())), boxes_(faces_.size()) {
    for (int f = 0; f < mesh.face_count(); ++f) {
      const std::size_t shell = at(mesh.shell_of_face()[at(f)]);
      faces_[shell].push_back(f);
      for (int c = 0; c < 3; ++c) boxes_[shell].include(mesh.vertex(f, c));
    }
    bvh_.build(boxes_);
  }

  [[nodiscard]] bool is_enclosed(int shell) const {
    const Aabb& box = boxes_[at(shell)];
    const std::vector<dvec3> probes = probe_points(shell);
    bool enclosed = false;
    bvh_.visit([&](const Aabb& outer) { return !enclosed && contains(outer, box); },
               [&](int other) {
                 if (!enclosed && other != shell && contains(boxes_[at(other)], box))
                   enclosed = winds_around(other, probes);
               });
    return enclosed;
  }

 private:
  [[nodiscard]] bool winds_around(int shell, const std::vector<dvec3>& probes) const {
    double mean = 0;
    for (const dvec3& p : probes) mean += std::abs(winding_number(shell, p)) / static_cast<double>(probes.size());
    return mean > 0.5;
  }

  /// Returns the winding number of `shell` around p: 1 or -1 inside a closed shell, 0 outside.
  [[nodiscard]] double winding_number(int shell, const dvec3& p) const {
    double sum = 0;
    for (const int f : faces_[at(shell)])
      sum += solid_angle(mesh_.vertex(f, 0) - p, mesh_.vertex(f, 1) - p, mesh_.vertex(f, 2) - p);
    return sum / (4.0 * kPi);
  }

  /// Returns the centres of some faces of a shell, spread over its list of faces.
  [[nodiscard]] std::vector<dvec3> probe_points(int shell) const {
    constexpr std::size_t kProbes = 8;
    const std::vector<int>& faces = faces_[at(shell)];
    const std::size_t count = std::min(kProbes, faces.size());
    std::vector<dvec3> points;
    for (std::size_t i = 0; i < count; ++i) {
      const int f = faces[i * faces.size() / count];
      points.push_back((mesh_.vertex(f, 0) + mesh_.vertex(f, 1) + mesh_.vertex(f, 2)) / 3.0);
    }
    return points;
  }

  const TriMesh& mesh_;
  std::vector<std::vector<int>> faces_;  // per shell
  std::vector<Aabb> boxes_;              // per shell
  Bvh bvh_;                              // over boxes_
};

/// Returns 1 for each shell inside another shell (shell_is_enclosed()), and 0 for the others.
std::vector<char> enclosed_shells(const TriMesh& mesh) {
  std::vector<char> enclosed(at(mesh.shell_count()), 0);
  if (mesh.shell_count() < 2) return enclosed;
  const ShellTree shells(mesh);
  for (int s = 0; s < mesh.shell_count(); ++s) enclosed[at(s)] = shells.is_enclosed(s) ? 1 : 0;
  return enclosed;
}

/// A face across an edge of two faces.
struct Link {
  int face = -1;
  bool is_alike = true;  ///< true if both faces wind alike
};

/// The links of each face, in the order of edges.
std::vector<std::vector<Link>> find_links(const TriMesh& mesh) {
  std::vector<std::vector<Link>> result(at(mesh.face_count()));
  const EdgeTopology& edges = mesh.topology();
  edges.for_each_edge([&](std::span<const int> edge) {
    if (edge.size() != 2) return;
    const int f = edge[0] / 3, g = edge[1] / 3;
    const bool is_alike = edges.kind(edge) == EdgeKind::inner;
    result[at(f)].push_back({g, is_alike});
    result[at(g)].push_back({f, is_alike});
  });
  return result;
}

/// Signed volume of each shell [m^3] (divergence theorem; the apex is a vertex of the shell).
std::vector<double> shell_volumes(const TriMesh& mesh) {
  std::vector<double> volumes(at(mesh.shell_count()), 0);
  std::vector<int> first(volumes.size(), -1);
  for (int f = 0; f < mesh.face_count(); ++f) {
    const std::size_t shell = at(mesh.shell_of_face()[at(f)]);
    if (first[shell] < 0) first[shell] = f;
    const dvec3& apex = mesh.vertex(first[shell], 0);
    const dvec3 a = mesh.vertex(f, 0) - apex, b = mesh.vertex(f, 1) - apex, c = mesh.vertex(f, 2) - apex;
    volumes[shell] += glm::dot(a, glm::cross(b, c)) / 6.0;
  }
  return volumes;
}

}  // namespace

bool shell_is_enclosed(const TriMesh& mesh, int shell) {
  return mesh.shell_count() > 1 && ShellTree(mesh).is_enclosed(shell);
}

std::vector<int> outer_shells(const TriMesh& mesh) {
  const std::vector<char> enclosed = enclosed_shells(mesh);
  std::vector<int> outer;
  for (int s = 0; s < mesh.shell_count(); ++s)
    if (enclosed[at(s)] == 0) outer.push_back(s);
  return outer;
}

TriMesh oriented(const TriMesh& mesh) {
  const std::vector<std::vector<Link>> neighbours = find_links(mesh);
  std::vector<int> turned(at(mesh.face_count()), -1);  // -1 until reached
  std::vector<ivec3> faces = mesh.faces();
  std::vector<int> queue;
  for (int seed = 0; seed < mesh.face_count(); ++seed) {
    if (turned[at(seed)] >= 0) continue;
    queue.assign(1, seed);
    turned[at(seed)] = 0;
    for (std::size_t i = 0; i < queue.size(); ++i) {
      for (const Link& link : neighbours[at(queue[i])]) {
        if (turned[at(link.face)] >= 0) continue;
        turned[at(link.face)] = link.is_alike ? turned[at(queue[i])] : 1 - turned[at(queue[i])];
        queue.push_back(link.face);
      }
    }
  }
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (turned[f] == 1) std::swap(faces[f].y, faces[f].z);
  }
  TriMesh alike(mesh.vertices(), std::move(faces));
  if (!alike.closed()) return alike;
  // A closed shell encloses a positive volume, a cavity a negative one.
  std::vector<char> flip(at(alike.shell_count()), 0);
  const std::vector<double> volumes = shell_volumes(alike);
  const std::vector<char> enclosed = enclosed_shells(alike);
  for (std::size_t s = 0; s < flip.size(); ++s) flip[s] = (volumes[s] < 0) != (enclosed[s] != 0) ? 1 : 0;
  faces = alike.faces();
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (flip[at(alike.shell_of_face()[f])] != 0) std::swap(faces[f].y, faces[f].z);
  }
  return {mesh.vertices(), std::move(faces)};
}

namespace {

constexpr std::array<std::pair<std::string_view, std::string_view>, 9> kMeanings{{
    {"mesh_open",
     "The surface has no inside there. A repair closes it when the mesh is used (Inspector > Mesh); the file does not "
     "change."},
    {"mesh_nonmanifold",
     "Inside and outside are not defined there. A repair removes loose faces, and separates parts that touch."},
    {"mesh_winding",
     "Inside and outside are exchanged there. A repair reverses the faces, or wraps the mesh if that is not possible."},
    {"mesh_inverted",
     "Samples and the normals of placed taxels point into the body, so readings would be 0. Reverse the faces."},
    {"mesh_cavity", "Its wall cannot be touched: it has no samples, and rays from the skin end halfway to it."},
    {"mesh_shells",
     "Each shell is a separate skin: samples are on all of them, and distances along the surface do not cross from one "
     "shell to another."},
    {"mesh_self_intersection",
     "Skin inside other parts has samples but cannot be touched, and pressures near it are too high."},
    {"mesh_units", "Radii and densities are in metres: with the wrong unit no receptive field fits the mesh."},
    {"mesh_repaired", "Done while reading; the file does not change."},
}};

std::string meaning_of(std::string_view code) {
  const auto* const found =
      std::find_if(kMeanings.begin(), kMeanings.end(), [&](const auto& entry) { return entry.first == code; });
  return found == kMeanings.end() ? std::string() : std::string(found->second);
}

MeshFindings report_of(const Problems& problems, const std::vector<std::string>& notes) {
  MeshFindings findings;
  for (const Problem& problem : problems)
    findings.push_back({problem.severity, problem.code, problem.message, meaning_of(problem.code)});
  std::stable_sort(findings.begin(), findings.end(),
                   [](const MeshFinding& a, const MeshFinding& b) { return a.severity > b.severity; });
  const std::string_view repaired = "mesh_repaired";
  for (const std::string& note : notes)
    findings.push_back({Severity::note, std::string(repaired), note, meaning_of(repaired)});
  return findings;
}

}  // namespace

MeshFindings mesh_report(const TriMesh& mesh, const std::vector<std::string>& notes) {
  return report_of(check_mesh(mesh, ""), notes);
}

MeshFindings mesh_report(const MeshIndex& index, const std::vector<std::string>& notes) {
  return report_of(check_mesh(index, ""), notes);
}

std::string count_findings(const MeshFindings& findings) {
  std::string text;
  for (const Severity severity : {Severity::error, Severity::warning, Severity::note}) {
    const auto count = std::count_if(findings.begin(), findings.end(),
                                     [&](const MeshFinding& finding) { return finding.severity == severity; });
    if (count > 0)
      text += fmt::format("{}{} {}{}", text.empty() ? "" : ", ", count, to_string(severity), count == 1 ? "" : "s");
  }
  return text;
}

}  // namespace taxel
