#include "ui/scene/draw/points.h"

namespace taxel::ui {

PointMark point_mark(const dvec3& position, const dvec3& normal, double size, std::uint32_t rgba) {
  return {glm::vec3(position), pack_normal(normal, size), rgba};
}

PointBuffer::PointBuffer() {
  array_.attribute(0, buffer_, 3, GL_FLOAT, sizeof(PointMark), offsetof(PointMark, position));
  array_.attribute(1, buffer_, 4, GL_BYTE, sizeof(PointMark), offsetof(PointMark, normal));
  array_.attribute(2, buffer_, 4, GL_UNSIGNED_BYTE, sizeof(PointMark), offsetof(PointMark, rgba));
}

void PointBuffer::draw(int most) const {
  if (buffer_.count() == 0) return;
  array_.bind();
  glDrawArrays(GL_POINTS, 0, std::min(most, buffer_.count()));
}

void PointPass::draw(const PointBuffer& points, const PointStyle& style, const MarkState& state, int most) const {
  set_mark_state(program_, state);
  program_.set("diameter", style.diameter);
  program_.set("outline", style.outline);
  program_.set("outline_width", style.outline_width);
  program_.use();
  points.draw(most);
}

void PointPass::draw(std::span<const PointMark> points, const PointStyle& style, const MarkState& state) {
  stream_.upload(points, GL_STREAM_DRAW);
  draw(stream_, style, state);
}

}  // namespace taxel::ui
