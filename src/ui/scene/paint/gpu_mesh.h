// A mesh in GPU memory, with its triangles and edges. Built once for each TriMesh.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "core/mesh/tri_mesh.h"
#include "core/run/scene_look.h"
#include "ui/gl/objects.h"
#include "ui/scene/geometry/render_mesh.h"
#include "ui/scene/paint/mark_pass.h"

namespace taxel::ui {

class GpuMesh {
 public:
  /// If `most_faces` > 0, a mesh with more faces is simplified to about this number for drawing, unless it has a
  /// texture. `texture_coords` has as many faces as the mesh, or is null.
  explicit GpuMesh(TriMeshPtr mesh, int most_faces = 0, const TextureCoordsPtr& texture_coords = nullptr);

  [[nodiscard]] const TriMesh& mesh() const { return *mesh_; }  ///< the mesh that is drawn
  [[nodiscard]] const TriMeshPtr& shared_mesh() const { return mesh_; }
  [[nodiscard]] bool has_texture() const { return texture_buffer_.has_value(); }  ///< has places in a texture
  const std::vector<MeshEdge>& edges();                                           ///< edges, computed at the first call
  /// Returns true if the mesh is small enough to test each edge in each frame.
  [[nodiscard]] bool has_outlines() const { return mesh_->face_count() <= kMaxOutlined; }

  void draw() const;
  /// Draws the mesh. If the body is closed, the faces of the side `hidden` (GL_FRONT, GL_BACK) are left out, because
  /// other faces always hide them.
  void draw_without(GLenum hidden) const;
  /// Draws the faces from back to front as seen along `direction` (frame of the mesh). A large mesh is drawn in two
  /// groups, first the faces that look away, then those that look towards the eye; for convex shapes the result is the
  /// same.
  void draw_blended(const glm::vec3& direction);
  /// Returns all edges as segments of one colour. They are built at the first call.
  const gl::Buffer& wires(float width, std::uint32_t rgba);

 private:
  TriMeshPtr mesh_;
  bool outward_;                                                     ///< true for a closed mesh with outward faces
  static constexpr int kMaxSorted = 60'000, kMaxOutlined = 300'000;  // largest numbers of faces
  std::optional<std::vector<MeshEdge>> edges_;
  std::vector<glm::vec3> centroids_;
  std::vector<std::uint32_t> indices_, sorted_;
  gl::Buffer vertex_buffer_, index_buffer_, sorted_buffer_;
  gl::VertexArray vertex_array_, sorted_array_;
  std::optional<gl::Buffer> wires_, texture_buffer_;
  std::uint32_t wire_rgba_ = 0;
};

/// A cache of the recently drawn meshes. A mesh that is not used for a whole frame is dropped.
class MeshCache {
 public:
  /// `most_faces` is the limit of GpuMesh.
  explicit MeshCache(int most_faces) : most_faces_(most_faces) {}
  GpuMesh& get(const TriMeshPtr& mesh, const TextureCoordsPtr& texture_coords = nullptr);
  void end_frame();

 private:
  struct Entry {
    std::unique_ptr<GpuMesh> mesh;
    bool used = true;
  };
  int most_faces_;
  std::map<std::pair<TriMeshPtr, TextureCoordsPtr>, Entry> entries_;
};

}  // namespace taxel::ui
