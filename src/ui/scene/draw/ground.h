// Behind and below everything: background, grid, and the soft shadow of what stands on it.
#pragma once

#include <functional>

#include "ui/gl/framebuffer.h"
#include "ui/gl/program.h"
#include "ui/gl/buffer.h"
#include "ui/scene/camera.h"
#include "ui/scene/draw/frame_uniforms.h"
#include "ui/scene/draw/look.h"
#include "ui/scene/draw/segments.h"

namespace taxel::ui {

/// The plane z = 0 of `X_WP`; a scene's own plane is filled and hides what lies below, else only the grid is drawn.
struct Ground {
  Pose X_WP;
  bool filled = false;
};

class GroundPass {
 public:
  explicit GroundPass(const gl::ShaderReader& read);

  /// Draws the shadow of whatever `draw_casters(program)` draws with the given program (uniform world_from_mesh) into
  /// the shadow texture. `box_W` bounds the casters. Leaves another framebuffer and frame bound.
  void make_shadow(const Ground& ground, const Aabb& box_W, const std::function<void(const gl::Program&)>& draw_casters);
  void draw_background(const Look& look) const;
  void draw(const Ground& ground, const Camera& camera, const Look& look, bool grid, SegmentPass& segments) const;
  void draw_shadow(const Ground& ground, const Look& look) const;

 private:
  void blur(const gl::Texture& from, GLuint to, const glm::vec2& direction) const;

  gl::Program background_, ground_, shadow_, blur_, shade_;
  gl::Texture map_, blurred_;
  gl::FramebufferHandle map_target_, blurred_target_;
  gl::Buffer frame_;
  gl::VertexArray empty_;
  glm::vec4 shadow_box_{0};
};

/// Spacing of the finer grid lines: the power of ten below a tenth of the distance. [m]
double grid_cell(double camera_distance);

}  // namespace taxel::ui
