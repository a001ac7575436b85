// Draws triangles on a skin in flat colours, visible from their front side.
#pragma once

#include <span>

#include "ui/gl/buffer.h"
#include "ui/scene/geometry/skin_paint.h"
#include "ui/scene/marks/mark_state.h"

namespace taxel::ui {

/// Triangles in GPU memory.
class PaintBuffer {
 public:
  PaintBuffer();
  void upload(std::span<const PaintVertex> triangles) { buffer_.upload(triangles, GL_STATIC_DRAW); }
  void draw() const;

 private:
  gl::Buffer buffer_;
  gl::VertexArray array_;
};

class PaintPass {
 public:
  explicit PaintPass(const gl::ShaderReader& read) : program_(read, "paint") {}
  void draw(const PaintBuffer& triangles, const MarkState& state) const;

 private:
  gl::Program program_;
};

}  // namespace taxel::ui
