#include "core/mesh/geodesic/unfolded_mesh.h"

#include "core/base/index.h"
#include "core/base/parallel.h"

namespace taxel {
UnfoldedMesh::UnfoldedMesh(TriMeshPtr mesh)
    : mesh_(std::move(mesh)), edges_(3 * mesh_->faces().size()), angles_(edges_.size()) {
  lay_flat();
  measure_fans();
  ends_.resize(edges_.size());
  for (int h = 0; h < edge_count(); ++h)
    ends_[at(h)] = {edges_[at(next_edge(h))].apex_fan, edges_[at(previous_edge(h))].apex_fan};
}

void UnfoldedMesh::lay_flat() {
  parallel_chunks(edge_count(), 768, [&](int begin, int end) {
    for (int h = begin; h < end; ++h) {
      const dvec3 &a = mesh_->vertex(h / 3, h % 3), &b = mesh_->vertex(h / 3, (h + 1) % 3),
                  &c = mesh_->vertex(h / 3, (h + 2) % 3);
      FlatEdge& e = edges_[at(h)];
      e.twin = mesh_->topology().twin(h);
      e.length = glm::distance(a, b);
      const double twice_area = glm::length(glm::cross(b - a, c - a));
      e.apex = dvec2(glm::dot(c - a, b - a), twice_area) / e.length;
      e.to_apex = glm::normalize(e.apex);
      e.from_apex = glm::normalize(dvec2(e.length, 0) - e.apex);
      angles_[at(h)].y = std::atan2(twice_area, glm::dot(a - c, b - c));
    }
  });
}

void UnfoldedMesh::measure_fans() {
  VertexFans fans = mesh_->topology().vertex_fans();
  fans_.reserve(at(fans.count()));
  for (int f = 0; f < fans.count(); ++f) {
    const std::span<const int> corners = fans.corners_of(f);
    Fan fan{0.0, mesh_->topology().twin(corners[0]) >= 0, fans.first[at(f)], static_cast<int>(corners.size())};
    for (const int corner : corners) {
      const std::size_t opposite = at(next_edge(corner));
      edges_[opposite].apex_fan = f;
      angles_[opposite].x = fan.angle;
      fan.angle += angles_[opposite].y;
    }
    fans_.push_back(fan);
  }
  corners_ = std::move(fans.corners);
}

dvec2 UnfoldedMesh::flat(int halfedge, const dvec3& p) const {
  const dvec3 &a = mesh_->vertex(halfedge / 3, halfedge % 3), &b = mesh_->vertex(halfedge / 3, (halfedge + 1) % 3);
  const dvec3& n = mesh_->face_normals()[at(halfedge / 3)];
  const dvec3 along = (b - a) / edge(halfedge).length;
  return {glm::dot(p - a, along), glm::dot(p - a, glm::cross(n, along))};
}

}  // namespace taxel
