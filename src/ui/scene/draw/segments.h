// Lines and arrows of constant pixel width, gathered on the processor and drawn in one go.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "core/base/math.h"
#include "ui/gl/buffer.h"
#include "ui/gl/program.h"
#include "ui/scene/draw/mark_state.h"

namespace taxel::ui {

/// As `Segment` in shaders/segment.glsl (std430).
struct Segment {
  glm::vec3 a{0};
  float width = 1;  ///< [pixel]
  glm::vec3 b{0};
  std::uint32_t rgba = 0;  ///< sRGB, straight alpha, red in the lowest byte
};
using Segments = std::vector<Segment>;

/// sRGB 0..1 with alpha as four bytes.
std::uint32_t pack(const glm::vec4& rgba);
inline std::uint32_t pack(const glm::vec3& rgb) {
  return pack(glm::vec4(rgb, 1));
}

inline Segment segment(const dvec3& a, const dvec3& b, float width, std::uint32_t rgba) {
  return {glm::vec3(a), width, glm::vec3(b), rgba};
}

/// Draws segments as lines (program "line") or as arrows from a to b (program "arrow").
class SegmentPass {
 public:
  explicit SegmentPass(const gl::ShaderReader& read) : lines_(read, "line"), arrows_(read, "arrow") {}
  void draw_lines(std::span<const Segment> segments, const MarkState& state);
  void draw_lines(const gl::Buffer& segments, const MarkState& state) const;
  void draw_arrows(std::span<const Segment> segments, const MarkState& state, const glm::vec4& outline);

 private:
  void draw(const gl::Program& program, const gl::Buffer& segments, const MarkState& state) const;
  gl::Program lines_, arrows_;
  gl::Buffer stream_;
  gl::VertexArray empty_;
};

}  // namespace taxel::ui
