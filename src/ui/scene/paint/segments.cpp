#include "ui/scene/paint/segments.h"

namespace taxel::ui {

void SegmentPass::make_quads(GLsizei count) const {
  if (6 * count <= corners_.count()) return;
  std::vector<std::uint32_t> indices;
  const auto quads = static_cast<std::uint32_t>(std::max(count, corners_.count() / 3));  // at least twice as many
  indices.reserve(std::size_t{6} * quads);
  for (std::uint32_t q = 0; q < quads; ++q) {
    for (const std::uint32_t corner : {0u, 1u, 2u, 2u, 1u, 3u}) indices.push_back(4 * q + corner);
  }
  corners_.upload(std::span<const std::uint32_t>(indices), GL_STATIC_DRAW);
  quads_.elements(corners_);
}

void SegmentPass::draw(const gl::Program& program, const gl::Buffer& segments, const MarkState& state) const {
  if (segments.count() == 0) return;
  make_quads(segments.count());
  set_mark_state(program, state);
  program.use();
  quads_.bind();
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, segments.id());
  glDrawElements(GL_TRIANGLES, 6 * segments.count(), GL_UNSIGNED_INT, nullptr);
}

void SegmentPass::draw_lines(std::span<const Segment> segments, const MarkState& state) {
  stream_.upload(segments, GL_STREAM_DRAW);
  draw(lines_, stream_, state);
}

void SegmentPass::draw_lines(const gl::Buffer& segments, const MarkState& state) const {
  draw(lines_, segments, state);
}

void SegmentPass::draw_arrows(std::span<const Segment> segments, const MarkState& state, const glm::vec4& outline,
                              float scale) {
  stream_.upload(segments, GL_STREAM_DRAW);
  draw_arrows(stream_, state, outline, scale);
}

void SegmentPass::draw_arrows(const gl::Buffer& segments, const MarkState& state, const glm::vec4& outline,
                              float scale) const {
  arrows_.set("outline", outline);
  arrows_.set("width_scale", scale);
  draw(arrows_, segments, state);
}

}  // namespace taxel::ui
