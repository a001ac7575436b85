// Draws triangles on a skin in flat colours, visible from one side.
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
  void upload(std::span<const PaintVertex> triangles, GLenum usage = GL_STATIC_DRAW) {
    buffer_.upload(triangles, usage);
  }
  void draw() const;

 private:
  gl::Buffer buffer_;
  gl::VertexArray array_;
};

/// The side of triangles that is drawn.
enum class Side { front, back };

class PaintPass {
 public:
  explicit PaintPass(const gl::ShaderReader& read) : program_(read, "paint") {}
  void draw(const PaintBuffer& triangles, const MarkState& state, Side side = Side::front) const;
  void draw(std::span<const PaintVertex> triangles, const MarkState& state, Side side);

 private:
  gl::Program program_;
  PaintBuffer stream_;
};

}  // namespace taxel::ui
