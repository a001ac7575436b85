#include "ui/scene/paint/gpu_mesh.h"

#include "ui/gl/program.h"
#include "ui/scene/geometry/render_mesh.h"

namespace taxel::ui {

GpuMesh::GpuMesh(TriMeshPtr mesh, int most_faces, const TextureCoordsPtr& texture_coords) : mesh_(std::move(mesh)) {
  if (most_faces > 0 && mesh_->face_count() > most_faces && !texture_coords) mesh_ = simplify(mesh_, most_faces);
  outward_ = mesh_->closed() && mesh_->volume() > 0;
  constexpr double kCreaseDegrees = 40;
  RenderMesh render =
      make_render_mesh(*mesh_, kCreaseDegrees, texture_coords ? *texture_coords : std::span<const glm::vec2>());
  indices_ = std::move(render.indices);
  vertex_buffer_.upload(std::span<const RenderMesh::Vertex>(render.vertices), GL_STATIC_DRAW);
  index_buffer_.upload(std::span<const std::uint32_t>(indices_), GL_STATIC_DRAW);
  for (gl::VertexArray* array : {&vertex_array_, &sorted_array_}) {
    constexpr auto stride = sizeof(RenderMesh::Vertex);
    array->attribute(0, vertex_buffer_, 3, GL_FLOAT, stride, offsetof(RenderMesh::Vertex, position));
    array->attribute(1, vertex_buffer_, 3, GL_FLOAT, stride, offsetof(RenderMesh::Vertex, normal));
  }
  if (texture_coords) {
    texture_buffer_.emplace();
    texture_buffer_->upload(std::span<const glm::vec2>(render.texture_coords), GL_STATIC_DRAW);
    for (gl::VertexArray* array : {&vertex_array_, &sorted_array_})
      array->attribute(2, *texture_buffer_, 2, GL_FLOAT, sizeof(glm::vec2), 0);
  }
  vertex_array_.elements(index_buffer_);
  sorted_array_.elements(sorted_buffer_);
  for (int f = 0; f < mesh_->face_count() && mesh_->face_count() <= kMaxSorted; ++f) {
    centroids_.emplace_back((mesh_->vertex(f, 0) + mesh_->vertex(f, 1) + mesh_->vertex(f, 2)) / 3.0);
  }
}

void GpuMesh::draw() const {
  vertex_array_.bind();
  glDrawElements(GL_TRIANGLES, index_buffer_.count(), GL_UNSIGNED_INT, nullptr);
}

void GpuMesh::draw_without(GLenum hidden) const {
  gl::enable(GL_CULL_FACE, outward_);
  glCullFace(hidden);
  draw();
  glDisable(GL_CULL_FACE);
}

const std::vector<MeshEdge>& GpuMesh::edges() {
  if (!edges_) edges_ = mesh_edges(*mesh_);
  return *edges_;
}

void GpuMesh::draw_blended(const glm::vec3& direction) {
  if (mesh_->face_count() > kMaxSorted) {
    glEnable(GL_CULL_FACE);
    for (const GLenum hidden : {GL_FRONT, GL_BACK}) {
      glCullFace(hidden);
      draw();
    }
    glDisable(GL_CULL_FACE);
    return;
  }
  order_back_to_front(centroids_, indices_, direction, sorted_);
  sorted_buffer_.upload(std::span<const std::uint32_t>(sorted_), GL_STREAM_DRAW);
  sorted_array_.bind();
  glDrawElements(GL_TRIANGLES, sorted_buffer_.count(), GL_UNSIGNED_INT, nullptr);
}

const gl::Buffer& GpuMesh::wires(float width, std::uint32_t rgba) {
  if (wires_ && wire_rgba_ == rgba) return *wires_;
  Segments lines;
  lines.reserve(edges().size());
  for (const MeshEdge& e : edges()) {
    lines.push_back(segment(mesh_->vertices()[static_cast<std::size_t>(e.a)],
                            mesh_->vertices()[static_cast<std::size_t>(e.b)], width, rgba));
  }
  wires_.emplace();
  wires_->upload(std::span<const Segment>(lines), GL_STATIC_DRAW);
  wire_rgba_ = rgba;
  return *wires_;
}

GpuMesh& MeshCache::get(const TriMeshPtr& mesh, const TextureCoordsPtr& texture_coords) {
  Entry& entry = entries_[{mesh, texture_coords}];
  if (!entry.mesh) entry.mesh = std::make_unique<GpuMesh>(mesh, most_faces_, texture_coords);
  entry.used = true;
  return *entry.mesh;
}

void MeshCache::end_frame() {
  for (auto it = entries_.begin(); it != entries_.end();) {
    it = it->second.used ? std::next(it) : entries_.erase(it);
  }
  for (auto& [mesh, entry] : entries_) entry.used = false;
}

}  // namespace taxel::ui
