#include "ui/scene/paint/mark_pass.h"

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

PointMark point_mark(const dvec3& position, const dvec3& normal, double size, std::uint32_t rgba) {
  return {glm::vec3(position), pack_normal(normal, size), rgba};
}

namespace {

void read_marks(gl::VertexArray& array, const gl::Buffer& buffer) {
  array.attribute(0, buffer, 3, GL_FLOAT, sizeof(PointMark), offsetof(PointMark, position));
  array.attribute(1, buffer, 4, GL_BYTE, sizeof(PointMark), offsetof(PointMark, normal));
  array.attribute(2, buffer, 4, GL_UNSIGNED_BYTE, sizeof(PointMark), offsetof(PointMark, rgba));
}

/// Returns false only if point.vert also drops the point, whatever its rounding errors.
bool may_face(const PointMark& mark, const glm::vec3& eye) {
  const glm::vec3 normal(mark.normal[0], mark.normal[1], mark.normal[2]), toward = eye - mark.position;
  return glm::dot(normal, toward) >= -1e-4f * 127 * glm::length(toward);
}

}  // namespace

PointBuffer::PointBuffer() {
  read_marks(array_, buffer_);
}

void PointBuffer::draw(int most) const {
  if (buffer_.count() == 0) return;
  array_.bind();
  glDrawArrays(GL_POINTS, 0, std::min(most, buffer_.count()));
}

SurfacePoints::SurfacePoints() {
  read_marks(array_, buffer_);
  array_.elements(indices_);
}

void SurfacePoints::upload(std::vector<PointMark> points) {
  points_ = std::move(points);
  buffer_.upload(std::span<const PointMark>(points_), GL_STATIC_DRAW);
}

void SurfacePoints::draw(const dvec3& eye, int most) {
  const glm::vec3 from(eye);
  const std::size_t count = std::min(points_.size(), static_cast<std::size_t>(std::max(most, 0)));
  facing_.clear();
  for (std::size_t i = 0; i < count; ++i) {
    if (may_face(points_[i], from)) facing_.push_back(static_cast<std::uint32_t>(i));
  }
  if (facing_.empty()) return;
  indices_.upload(std::span<const std::uint32_t>(facing_), GL_STREAM_DRAW);
  array_.bind();
  glDrawElements(GL_POINTS, indices_.count(), GL_UNSIGNED_INT, nullptr);
}

void PointPass::set(const PointStyle& style, const MarkState& state) const {
  set_mark_state(program_, state);
  program_.set("diameter", style.diameter);
  program_.set("outline", style.outline);
  program_.set("outline_width", style.outline_width);
  program_.use();
}

void PointPass::draw(const PointBuffer& points, const PointStyle& style, const MarkState& state, int most) const {
  set(style, state);
  points.draw(most);
}

void PointPass::draw(SurfacePoints& points, const PointStyle& style, const MarkState& state, const dvec3& eye_W,
                     int most) const {
  set(style, state);
  points.draw(dvec3(glm::inverse(glm::dmat4(state.world_from_model)) * glm::dvec4(eye_W, 1)), most);
}

void PointPass::draw(std::span<const PointMark> points, const PointStyle& style, const MarkState& state) {
  stream_.upload(points, GL_STREAM_DRAW);
  draw(stream_, style, state);
}

}  // namespace taxel::ui
