#include "ui/scene/draw/points.h"

namespace taxel::ui {

PointMark point_mark(const dvec3& position, const dvec3& normal, double size, std::uint32_t rgba) {
  PointMark mark{glm::vec3(position), {}, rgba};
  for (int i = 0; i < 3; ++i)
    mark.normal[static_cast<std::size_t>(i)] = static_cast<std::int8_t>(std::lround(127 * normal[i]));
  mark.normal[3] = static_cast<std::int8_t>(std::lround(127 * std::clamp(size, 0.0, 1.0)));
  return mark;
}

PointBuffer::PointBuffer() {
  array_.attribute(0, buffer_, 3, GL_FLOAT, sizeof(PointMark), offsetof(PointMark, position));
  array_.attribute(1, buffer_, 4, GL_BYTE, sizeof(PointMark), offsetof(PointMark, normal));
  array_.attribute(2, buffer_, 4, GL_UNSIGNED_BYTE, sizeof(PointMark), offsetof(PointMark, rgba));
}

void PointBuffer::draw() const {
  if (buffer_.count() == 0) return;
  array_.bind();
  glDrawArrays(GL_POINTS, 0, buffer_.count());
}

void PointPass::draw(const PointBuffer& points, const PointStyle& style, const MarkState& state) const {
  set_mark_state(program_, state);
  program_.set("diameter", style.diameter);
  program_.set("facing", style.facing == Facing::all ? 0.0f : style.facing == Facing::eye ? 1.0f : -1.0f);
  program_.set("outline", style.outline);
  program_.set("outline_width", style.outline_width);
  program_.use();
  points.draw();
}

void PointPass::draw(std::span<const PointMark> points, const PointStyle& style, const MarkState& state) {
  stream_.upload(points, GL_STREAM_DRAW);
  draw(stream_, style, state);
}

}  // namespace taxel::ui
