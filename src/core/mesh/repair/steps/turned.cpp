// Faces without area: their longest edge is flipped, so that the apex splits the face across.
//
//        x             x
//      /   \         / | \      The face a b c is flat, c lies on the edge a b. Flipped, the edge c x splits a b x.
//     a--c--b       a--c--b
#include <queue>

#include "core/mesh/repair/steps.h"
#include "core/mesh/repair/topology.h"

namespace taxel {
namespace {

using Mesh = Topology::Mesh;

dvec3 point(const Mesh& mesh, OpenMesh::VertexHandle v) {
  const auto& p = mesh.point(v);
  return {p[0], p[1], p[2]};
}

/// The longest half-edge of a face.
OpenMesh::SmartHalfedgeHandle longest_side(const Mesh& mesh, OpenMesh::FaceHandle face) {
  OpenMesh::SmartHalfedgeHandle longest;
  double most = -1;
  for (const OpenMesh::SmartHalfedgeHandle h : mesh.fh_range(face)) {
    const double length = glm::distance(point(mesh, h.from()), point(mesh, h.to()));
    if (length > most) {
      most = length;
      longest = h;
    }
  }
  return longest;
}

bool is_flat_face(const Mesh& mesh, OpenMesh::FaceHandle face) {
  const OpenMesh::SmartHalfedgeHandle h = OpenMesh::make_smart(face, mesh).halfedge();
  return is_flat(point(mesh, h.from()), point(mesh, h.to()), point(mesh, h.next().to()));
}

/// Flat faces by the length of their longest edge, the longest first. Across such an edge every other flat face has
/// its apex between the ends, so that both faces get shorter and the flips come to an end.
class FlatFaces {
 public:
  FlatFaces(Draft& draft, RepairStep& step)
      : draft_(draft), step_(step), topology_(make_topology(draft, twin_pairs(draft.edges()))) {
    for (int f = 0; f < draft.face_count(); ++f) add(OpenMesh::FaceHandle(f));
  }

  void turn_all() {
    std::vector<char> removed(draft_.faces.size(), 0);
    // Rounding may break the proof above: then the flips end here, and the remaining flat faces are removed.
    for (std::size_t budget = 64 * (1 + queue_.size()); !queue_.empty(); --budget) {
      const int face = queue_.top().second;
      queue_.pop();
      if (!is_flat_face(topology_.mesh, OpenMesh::FaceHandle(face))) continue;
      if (budget == 0 || !turn(OpenMesh::FaceHandle(face))) removed[at(face)] = 1;
      if (budget == 0) break;
    }
    while (!queue_.empty()) {
      const int face = queue_.top().second;
      queue_.pop();
      if (is_flat_face(topology_.mesh, OpenMesh::FaceHandle(face))) removed[at(face)] = 1;
    }
    write_back();
    remove_faces(draft_, removed);
  }

 private:
  void add(OpenMesh::FaceHandle face) {
    if (!is_flat_face(topology_.mesh, face)) return;
    const auto h = longest_side(topology_.mesh, face);
    const double length = glm::distance(point(topology_.mesh, h.from()), point(topology_.mesh, h.to()));
    queue_.emplace(static_cast<float>(length), face.idx());
  }

  /// Returns false if there is no face across, or the flipped edge exists already.
  bool turn(OpenMesh::FaceHandle face) {
    Mesh& mesh = topology_.mesh;
    const OpenMesh::SmartHalfedgeHandle side = longest_side(mesh, face);
    add_place(step_, point(mesh, side.next().to()));
    ++step_.faces;
    if (side.opp().is_boundary() || !mesh.is_flip_ok(side.edge())) return false;
    const OpenMesh::FaceHandle across = side.opp().face();
    const int from = draft_.loaded[at(across.idx())];
    if (draft_.loaded[at(face.idx())] < 0) draft_.loaded[at(face.idx())] = from;
    mesh.flip(side.edge());
    add(face);
    add(across);
    return true;
  }

  void write_back() {
    for (int f = 0; f < draft_.face_count(); ++f) {
      int c = 0;
      ivec3 face(0);
      for (const OpenMesh::VertexHandle v : topology_.mesh.fv_range(OpenMesh::FaceHandle(f)))
        face[c++] = topology_.vertex_of[at(v.idx())];
      if (face != draft_.faces[at(f)] && !is_rotated(face, draft_.faces[at(f)])) draft_.faces[at(f)] = face;
    }
  }
  static bool is_rotated(const ivec3& f, const ivec3& g) {
    return f == ivec3(g.y, g.z, g.x) || f == ivec3(g.z, g.x, g.y);
  }

  Draft& draft_;
  RepairStep& step_;
  Topology topology_;
  std::priority_queue<std::pair<float, int>> queue_;  ///< single precision: equal lengths are equal in every unit
};

}  // namespace

RepairStep turn_flat_faces(Draft& draft) {
  RepairStep step = start_step("repair_turned");
  bool any = false;
  for (int f = 0; f < draft.face_count() && !any; ++f)
    any = is_flat(draft.corner(f, 0), draft.corner(f, 1), draft.corner(f, 2));
  if (any) FlatFaces(draft, step).turn_all();
  return step;
}

}  // namespace taxel
