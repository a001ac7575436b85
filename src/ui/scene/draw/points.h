// Round points of constant pixel size.
#pragma once

#include <array>
#include <span>

#include "core/base/math.h"
#include "ui/gl/buffer.h"
#include "ui/scene/draw/mark_state.h"

namespace taxel::ui {

struct PointMark {
  glm::vec3 position{0};
  std::array<std::int8_t, 4> normal{0, 0, 0, 127};  ///< 127ths; zero: seen from everywhere. Last: part of the size
  std::uint32_t rgba = 0;                           ///< sRGB, straight alpha, red in the lowest byte
};

PointMark point_mark(const dvec3& position, const dvec3& normal, double size, std::uint32_t rgba);

enum class Facing { all, eye, away };

struct PointStyle {
  float diameter = 4;  ///< [pixel]; of a point of size 1
  Facing facing = Facing::all;
  glm::vec4 outline{0, 0, 0, 0};
  float outline_width = 0;  ///< [pixel], inside the diameter
};

/// Points that stay on the card.
class PointBuffer {
 public:
  PointBuffer();
  void upload(std::span<const PointMark> points, GLenum usage) { buffer_.upload(points, usage); }
  void draw() const;

 private:
  gl::Buffer buffer_;
  gl::VertexArray array_;
};

class PointPass {
 public:
  explicit PointPass(const gl::ShaderReader& read) : program_(read, "point") {}
  void draw(const PointBuffer& points, const PointStyle& style, const MarkState& state) const;
  void draw(std::span<const PointMark> points, const PointStyle& style, const MarkState& state);

 private:
  gl::Program program_;
  PointBuffer stream_;
};

}  // namespace taxel::ui
