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
  make_quads(std::min(segments.count(), most_));
  set_mark_state(program, state);
  program.use();
  quads_.bind();
  if (segments.count() <= most_) return draw_piece(segments);
  for (GLsizei first = 0; first < segments.count(); first += most_) {
    piece_.copy(segments, first, std::min(most_, segments.count() - first), sizeof(Segment));
    draw_piece(piece_);
  }
}

void SegmentPass::draw_piece(const gl::Buffer& segments) const {
  texture_.bind(segments, 0);
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
