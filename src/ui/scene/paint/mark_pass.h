// Lines, arrows and round points of constant size in pixels, collected by the CPU and drawn by one call, and the state
// that all marks share when they are drawn.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/base/math.h"
#include "ui/gl/objects.h"
#include "ui/gl/program.h"
#include "ui/scene/color_map.h"

namespace taxel::ui {

/// A unit normal in 127ths, or zero if the mark is visible from everywhere; and one more number, 0 to 1 in 127ths.
using MarkNormal = std::array<std::int8_t, 4>;

inline MarkNormal pack_normal(const dvec3& normal, double last) {
  const auto part = [](double x) { return static_cast<std::int8_t>(std::lround(127 * x)); };
  return {part(normal.x), part(normal.y), part(normal.z), part(std::clamp(last, 0.0, 1.0))};
}

/// The marks with a normal that are drawn: all, those that face the eye, or those that face away.
enum class Facing { all, eye, away };

/// How a batch of marks is drawn.
struct MarkState {
  glm::mat4 world_from_model{1};
  float toward_eye = 0;  ///< moves marks towards the eye by this fraction of their depth
  bool depth_test = true;
  bool hidden = false;  ///< draws only marks that are hidden by something nearer
  bool depth_write = false;
  float dim = 1;  ///< factor of alpha
  Facing facing = Facing::all;
  bool clipped = false;  ///< clips by the frame's plane
};

/// Sets whether the frame's plane clips the following draw calls.
inline void set_clipped(bool clipped) {
  (clipped ? glEnable : glDisable)(GL_CLIP_DISTANCE0);
}

/// Sends the uniforms that the shaders of all marks share, and sets depth and blending.
inline void set_mark_state(const gl::Program& program, const MarkState& state) {
  program.set("world_from_model", state.world_from_model);
  program.set("toward_eye", state.toward_eye);
  program.set("dim", state.dim);
  program.set("facing", state.facing == Facing::all ? 0.0f : state.facing == Facing::eye ? 1.0f : -1.0f);
  program.set("clipped", state.clipped ? 1.0f : 0.0f);
  set_clipped(state.clipped);
  const GLenum test = state.hidden ? GL_GREATER : GL_LEQUAL;
  gl::apply({.depth = state.depth_test ? test : GL_ALWAYS, .depth_write = state.depth_write, .blend = true});
}

/// Returns the largest fraction of marks, spread evenly over a surface with a distance of `spacing` [pixel] on the
/// screen, that can be drawn with a distance of at least `least` [pixel].
inline double part_apart(double spacing, double least) {
  return std::min(1.0, spacing * spacing / (least * least));
}

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

/// One point. Points with a normal are only visible from its side.
struct PointMark {
  glm::vec3 position{0};
  MarkNormal normal{0, 0, 0, 127};  ///< normal; the last number is a fraction of the size
  std::uint32_t rgba = 0;           ///< sRGB, straight alpha, red in the lowest byte
};

PointMark point_mark(const dvec3& position, const dvec3& normal, double size, std::uint32_t rgba);

/// Style of all points of a draw.
struct PointStyle {
  float diameter = 4;  ///< diameter of a point of size 1 [pixel]
  glm::vec4 outline{0, 0, 0, 0};
  float outline_width = 0;  ///< width of the outline, inside the diameter [pixel]
};

/// Points in GPU memory.
class PointBuffer {
 public:
  PointBuffer();
  void upload(std::span<const PointMark> points, GLenum usage) { buffer_.upload(points, usage); }
  /// Draws the first `most` points.
  void draw(int most = std::numeric_limits<int>::max()) const;

 private:
  gl::Buffer buffer_;
  gl::VertexArray array_;
};

/// Very many points on a surface, each visible from one side. Points that look away are not sent to the GPU.
class SurfacePoints {
 public:
  SurfacePoints();
  void upload(std::vector<PointMark> points);
  /// Draws those of the first `most` points that face the eye (frame of the points), in their order. For points that
  /// are seen at a grazing angle the shader decides.
  void draw(const dvec3& eye, int most);

 private:
  std::vector<PointMark> points_;
  std::vector<std::uint32_t> facing_;
  gl::Buffer buffer_, indices_;
  gl::VertexArray array_;
};

/// Draws points with the shader program "point".
class PointPass {
 public:
  explicit PointPass(const gl::ShaderReader& read) : program_(read, "point") {}
  void draw(const PointBuffer& points, const PointStyle& style, const MarkState& state,
            int most = std::numeric_limits<int>::max()) const;
  void draw(std::span<const PointMark> points, const PointStyle& style, const MarkState& state);
  void draw(SurfacePoints& points, const PointStyle& style, const MarkState& state, const dvec3& eye_W, int most) const;

 private:
  void set(const PointStyle& style, const MarkState& state) const;
  gl::Program program_;
  PointBuffer stream_;
};

}  // namespace taxel::ui
