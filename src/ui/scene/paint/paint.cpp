#include "ui/scene/paint/paint.h"

namespace taxel::ui {

PaintBuffer::PaintBuffer() {
  array_.attribute(0, buffer_, 3, GL_FLOAT, sizeof(PaintVertex), offsetof(PaintVertex, position));
  array_.attribute(1, buffer_, 4, GL_UNSIGNED_BYTE, sizeof(PaintVertex), offsetof(PaintVertex, rgba));
}

void PaintBuffer::draw() const {
  if (buffer_.count() == 0) return;
  array_.bind();
  glDrawArrays(GL_TRIANGLES, 0, buffer_.count());
}

void PaintPass::draw(std::span<const PaintVertex> triangles, const MarkState& state, Side side) {
  stream_.upload(triangles, GL_STREAM_DRAW);
  draw(stream_, state, side);
}

void PaintPass::draw(const PaintBuffer& triangles, const MarkState& state, Side side) const {
  set_mark_state(program_, state);
  program_.use();
  glEnable(GL_CULL_FACE);
  glCullFace(side == Side::front ? GL_BACK : GL_FRONT);
  triangles.draw();
  glDisable(GL_CULL_FACE);
}

}  // namespace taxel::ui
