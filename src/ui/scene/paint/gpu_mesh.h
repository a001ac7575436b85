// A mesh on the graphics card, with its triangles and edges. Made once per TriMesh.
#pragma once

#include <map>
#include <memory>
#include <optional>

#include "core/mesh/tri_mesh.h"
#include "ui/gl/buffer.h"
#include "ui/scene/geometry/visible_edges.h"
#include "ui/scene/paint/segments.h"

namespace taxel::ui {

class GpuMesh {
 public:
  /// With `most_faces` > 0 a mesh of more is drawn simplified to about that.
  explicit GpuMesh(TriMeshPtr mesh, int most_faces = 0);

  [[nodiscard]] const TriMesh& mesh() const { return *mesh_; }  ///< the mesh that is drawn
  [[nodiscard]] const TriMeshPtr& shared_mesh() const { return mesh_; }
  const std::vector<MeshEdge>& edges();  ///< made when first asked for
  /// Whether it is small enough to look at each edge in each picture.
  [[nodiscard]] bool has_outlines() const { return mesh_->face_count() <= kMaxOutlined; }

  void draw() const;
  /// Without the faces of `hidden` (GL_FRONT, GL_BACK) where others of a closed body always lie before them.
  void draw_without(GLenum hidden) const;
  /// Faces from back to front as seen along `direction` (frame of the mesh); of a large mesh those that look away, then
  /// those that look towards the eye, which is the same for convex shapes.
  void draw_blended(const glm::vec3& direction);
  /// All edges as segments of that colour; made when first asked for.
  const gl::Buffer& wires(float width, std::uint32_t rgba);

 private:
  TriMeshPtr mesh_;
  bool outward_;                                                     ///< closed, faces look outwards
  static constexpr int kMaxSorted = 60'000, kMaxOutlined = 300'000;  // faces
  std::optional<std::vector<MeshEdge>> edges_;
  std::vector<glm::vec3> centroids_;
  std::vector<std::uint32_t> indices_, sorted_;
  gl::Buffer vertex_buffer_, index_buffer_, sorted_buffer_;
  gl::VertexArray vertex_array_, sorted_array_;
  std::optional<gl::Buffer> wires_;
  std::uint32_t wire_rgba_ = 0;
};

/// Keeps the meshes drawn recently; a mesh that a whole frame does not use is dropped.
class MeshCache {
 public:
  /// `most_faces` as of GpuMesh.
  explicit MeshCache(int most_faces) : most_faces_(most_faces) {}
  GpuMesh& get(const TriMeshPtr& mesh);
  void end_frame();

 private:
  struct Entry {
    std::unique_ptr<GpuMesh> mesh;
    bool used = true;
  };
  int most_faces_;
  std::map<TriMeshPtr, Entry> entries_;
};

}  // namespace taxel::ui
