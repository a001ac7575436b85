// A mesh on the graphics card with what is drawn of it: triangles, edges. Made once per TriMesh.
#pragma once

#include <map>
#include <memory>
#include <optional>

#include "core/mesh/tri_mesh.h"
#include "ui/gl/buffer.h"
#include "ui/scene/draw/segments.h"
#include "ui/scene/geometry/mesh_edges.h"

namespace taxel::ui {

class GpuMesh {
 public:
  explicit GpuMesh(TriMeshPtr mesh);

  [[nodiscard]] const TriMesh& mesh() const { return *mesh_; }
  [[nodiscard]] const std::vector<MeshEdge>& edges() const { return edges_; }

  void draw() const;
  /// Faces from back to front as seen along `direction` (frame of the mesh).
  void draw_sorted(const glm::vec3& direction);
  /// All edges as segments of that colour; made when first asked for.
  const gl::Buffer& wires(float width, std::uint32_t rgba);

 private:
  TriMeshPtr mesh_;
  std::vector<MeshEdge> edges_;
  std::vector<glm::vec3> centroids_;
  std::vector<std::uint32_t> indices_, sorted_;
  gl::Buffer vertex_buffer_, index_buffer_, sorted_buffer_;
  gl::VertexArray vertex_array_, sorted_array_;
  std::optional<gl::Buffer> wires_;
  std::uint32_t wire_rgba_ = 0;
};

/// Keeps what was drawn lately; what a whole picture did not use is dropped.
class MeshCache {
 public:
  GpuMesh& get(const TriMeshPtr& mesh);
  void end_frame();

 private:
  struct Entry {
    std::unique_ptr<GpuMesh> mesh;
    bool used = true;
  };
  std::map<const TriMesh*, Entry> entries_;  // each entry holds its TriMesh, so no address is reused
};

}  // namespace taxel::ui
