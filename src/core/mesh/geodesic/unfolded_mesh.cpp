#include "core/mesh/geodesic/unfolded_mesh.h"

#include "core/base/index.h"
#include "core/base/parallel.h"
#include "core/mesh/topology/edge_sides.h"

namespace taxel {
UnfoldedMesh::UnfoldedMesh(TriMeshPtr mesh)
    : mesh_(std::move(mesh)), edges_(3 * mesh_->faces().size()), angles_(edges_.size()) {
  lay_flat();
  join_twins();
  walk_fans();
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
      e.length = glm::distance(a, b);
      const double twice_area = glm::length(glm::cross(b - a, c - a));
      e.apex = dvec2(glm::dot(c - a, b - a), twice_area) / e.length;
      e.to_apex = glm::normalize(e.apex);
      e.from_apex = glm::normalize(dvec2(e.length, 0) - e.apex);
      angles_[at(h)].y = std::atan2(twice_area, glm::dot(a - c, b - c));
    }
  });
}

void UnfoldedMesh::join_twins() {
  const std::vector<EdgeSide> all_sides = edge_sides(*mesh_);
  for_each_edge(all_sides, [&](std::span<const EdgeSide> sides) {
    if (sides.size() != 2 || sides[0].forward == sides[1].forward) return;
    const int h = 3 * sides[0].face + sides[0].corner, g = 3 * sides[1].face + sides[1].corner;
    edges_[at(h)].twin = g;
    edges_[at(g)].twin = h;
  });
}

void UnfoldedMesh::walk_fans() {
  corners_.reserve(edges_.size());
  for (int h = 0; h < edge_count(); ++h) {
    if (edges_[at(next_edge(h))].apex_fan >= 0) continue;
    Fan fan{0.0, true, static_cast<int>(corners_.size()), 0};
    // Clockwise to the boundary, if there is one: across the half-edge that leaves the vertex, then the one after it.
    int begin = h;
    do {
      const int across = edges_[at(begin)].twin;
      fan.closed = across >= 0;
      if (fan.closed) begin = next_edge(across);
    } while (fan.closed && begin != h);
    // Counter-clockwise: across the half-edge that ends at the vertex.
    int corner = begin;
    do {
      const std::size_t opposite = at(next_edge(corner));
      edges_[opposite].apex_fan = fan_count();
      angles_[opposite].x = fan.angle;
      fan.angle += angles_[opposite].y;
      corners_.push_back(corner);
      corner = edges_[at(previous_edge(corner))].twin;
    } while (corner >= 0 && corner != begin);
    fan.count = static_cast<int>(corners_.size()) - fan.first;
    fans_.push_back(fan);
  }
}

dvec2 UnfoldedMesh::flat(int halfedge, const dvec3& p) const {
  const dvec3 &a = mesh_->vertex(halfedge / 3, halfedge % 3), &b = mesh_->vertex(halfedge / 3, (halfedge + 1) % 3);
  const dvec3& n = mesh_->face_normals()[at(halfedge / 3)];
  const dvec3 along = (b - a) / edge(halfedge).length;
  return {glm::dot(p - a, along), glm::dot(p - a, glm::cross(n, along))};
}

}  // namespace taxel
