// Draws round points of constant size in pixels.
#pragma once

#include <array>
#include <limits>
#include <span>

#include "core/base/math.h"
#include "ui/gl/buffer.h"
#include "ui/scene/marks/mark_state.h"

namespace taxel::ui {

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
