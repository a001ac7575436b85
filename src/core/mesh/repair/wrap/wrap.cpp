#include "core/mesh/repair/wrap/wrap.h"

#include "core/mesh/repair/steps/shells.h"
#include "core/mesh/repair/steps/solid.h"
#include "core/mesh/repair/topology.h"

namespace taxel {
namespace {

/// Faces of positive area among some faces.
std::vector<int> faces_with_area(const Draft& draft, const std::vector<int>& faces) {
  std::vector<int> found;
  for (const int f : faces)
    if (draft.area(f) > 0) found.push_back(f);
  return found;
}

/// Marching tetrahedra (Doi, Koide 1991) on a body-centred cubic lattice, whose surface is a manifold always.
manifold::Manifold polygonise(const WrapField& field, double edge, const Progress* progress) {
  const Aabb& box = field.bounds();
  const auto value = [&](manifold::vec3 p) {
    if (progress != nullptr) progress->stop_if_cancelled();
    return -field({p.x, p.y, p.z});
  };
  return manifold::Manifold::LevelSet(value, {{box.lo.x, box.lo.y, box.lo.z}, {box.hi.x, box.hi.y, box.hi.z}}, edge, 0,
                                      -1, false);
}

/// The outer shells of a level set: its largest one, and others that are not much smaller than a few edges. Inner ones
/// are cavities that nothing outside reaches.
Draft outer_shells(const manifold::Manifold& level_set, double edge) {
  constexpr double kMinEdges = 4;
  Draft draft;
  append_wrapped(draft, level_set);
  const FaceShells shells = find_shells(draft);
  std::vector<double> volumes;
  for (const std::vector<int>& shell : shells.faces) volumes.push_back(volume_of(draft, shell));
  if (volumes.empty()) return draft;
  const double least = std::min(std::pow(kMinEdges * edge, 3), *std::max_element(volumes.begin(), volumes.end()));
  std::vector<char> removed(draft.faces.size(), 0);
  for (int f = 0; f < draft.face_count(); ++f) removed[at(f)] = volumes[at(shells.of_face[at(f)])] < least ? 1 : 0;
  remove_faces(draft, removed);
  drop_unused_points(draft);
  return draft;
}

/// Moves each point to the closest point of the faces if that is nearer than half an edge and turns no face at the
/// point by more than 60 degrees.
void snap_to_faces(Draft& draft, const MeshIndex& faces, double edge) {
  constexpr double kLeastCosine = 0.5;
  const Topology topology = make_topology(draft, twin_pairs(draft.edges()));
  std::vector<dvec3> normals;
  for (int f = 0; f < draft.face_count(); ++f) normals.push_back(glm::normalize(draft.area_normal(f)));
  for (const OpenMesh::SmartVertexHandle v : topology.mesh.vertices()) {
    dvec3& point = draft.points[at(topology.vertex_of[at(v.idx())])];
    const SurfacePoint nearest = faces.closest_point(point, 0.5 * edge);
    if (nearest.face < 0) continue;
    const dvec3 before = point;
    point = nearest.position;
    for (const OpenMesh::FaceHandle f : topology.mesh.vf_range(v)) {
      const dvec3 normal = draft.area_normal(f.idx());
      const double length = glm::length(normal);
      if (length > 0 && glm::dot(normal, normals[at(f.idx())]) >= kLeastCosine * length) continue;
      point = before;
      break;
    }
  }
}

/// Fewer faces within `tolerance`. A mesh whose faces the simplification would lead through each other is simplified
/// less.
manifold::Manifold simplify(const Draft& wrapped, double tolerance) {
  std::vector<int> all(wrapped.faces.size());
  for (std::size_t f = 0; f < all.size(); ++f) all[f] = static_cast<int>(f);
  const manifold::Manifold solid = make_solid(wrapped, all, SolidFaces::mergeable);
  for (const double part : {1.0, 0.5, 0.25, 0.1}) {
    manifold::Manifold simple = solid.Simplify(part * tolerance);
    Draft draft;
    append_wrapped(draft, simple);
    if (!draft.faces.empty() && !cuts_through_itself(draft)) return simple;
  }
  return solid;
}

}  // namespace

void wrap_faces(Draft& result, const Draft& source, const std::vector<int>& faces, WrapKind kind,
                const RepairLimits& limits, const Progress* progress) {
  const std::vector<int> sound = faces_with_area(source, faces);
  if (sound.empty()) return;
  const WrapField field(source, sound, kind, limits);
  const Draft lattice = outer_shells(polygonise(field, limits.edge, progress), limits.edge);
  if (lattice.faces.empty()) return;
  Draft wrapped = lattice;
  snap_to_faces(wrapped, field.faces(), limits.edge);
  append_wrapped(result, simplify(cuts_through_itself(wrapped) ? lattice : wrapped, limits.tolerance));
}

}  // namespace taxel
