// Lines and arrows of constant width in pixels, collected by the CPU and drawn by one call.
#pragma once

#include <span>
#include <vector>

#include "core/base/math.h"
#include "ui/gl/buffer.h"
#include "ui/gl/program.h"
#include "ui/scene/color_map.h"
#include "ui/scene/marks/mark_state.h"

namespace taxel::ui {

/// A line segment, which shaders/segment.glsl reads as two texels of four words.
struct Segment {
  static constexpr double kWidest = 12.7;  ///< largest width [pixel]
  glm::vec3 a{0};
  MarkNormal normal{0, 0, 0, 10};  ///< normal; the last number is a fraction of kWidest
  glm::vec3 b{0};
  std::uint32_t rgba = 0;  ///< sRGB, straight alpha, red in the lowest byte
};
using Segments = std::vector<Segment>;

/// Builds a segment. `width` [pixel] is rounded to a tenth.
inline Segment segment(const dvec3& a, const dvec3& b, float width, std::uint32_t rgba,
                       const dvec3& normal = dvec3(0)) {
  return {glm::vec3(a), pack_normal(normal, static_cast<double>(width) / Segment::kWidest), glm::vec3(b), rgba};
}

/// Draws segments as lines (program "line") or as arrows from a to b (program "arrow").
class SegmentPass {
 public:
  /// `most` is the largest number of segments that shaders read at once, by default as many as the driver allows.
  explicit SegmentPass(const gl::ShaderReader& read, GLsizei most = gl::BufferTexture::max_texels() / 2)
      : lines_(read, "line"), arrows_(read, "arrow"), most_(most) {}
  void draw_lines(std::span<const Segment> segments, const MarkState& state);
  void draw_lines(const gl::Buffer& segments, const MarkState& state) const;
  void draw_arrows(std::span<const Segment> segments, const MarkState& state, const glm::vec4& outline,
                   float scale = 1.0f);
  /// Draws arrows. `scale` multiplies the widths.
  void draw_arrows(const gl::Buffer& segments, const MarkState& state, const glm::vec4& outline, float scale) const;

 private:
  void draw(const gl::Program& program, const gl::Buffer& segments, const MarkState& state) const;
  void draw_piece(const gl::Buffer& segments) const;
  void make_quads(GLsizei count) const;
  gl::Program lines_, arrows_;
  gl::Buffer stream_;
  mutable gl::Buffer corners_;  // indices of the quads, six for each; grows to the largest number used
  mutable gl::VertexArray quads_;
  gl::BufferTexture texture_;
  GLsizei most_;
  mutable gl::Buffer piece_;  // part of a buffer with more than most_ segments
};

}  // namespace taxel::ui
