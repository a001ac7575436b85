#include "ui/scene/paint/points.h"

namespace taxel::ui {

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
