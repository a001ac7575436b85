// A small picture of something seen from above, blurred: what soft shadows are made of.
#pragma once

#include "ui/gl/framebuffer.h"
#include "ui/gl/program.h"
#include "ui/scene/passes/frame_uniforms.h"

namespace taxel::ui {

class TopView {
 public:
  explicit TopView(const gl::ShaderReader& read);

  /// Clears to `empty` and makes all that follows be drawn as seen along -z of P, a margin around `box_W`.
  /// False when there is nothing to see. Leaves other targets and frames to be bound again by the caller.
  bool begin(const Pose& X_WP, const Aabb& box_W, float empty);
  void blur() const;

  void bind(GLuint unit) const { map_.bind(unit); }
  [[nodiscard]] const glm::vec4& box() const { return box_; }     ///< low corner and size in P [m]; size 0: nothing
  [[nodiscard]] const Aabb& casters() const { return casters_; }  ///< in P [m]

 private:
  void blur(const gl::Texture& from, GLuint to, const glm::vec2& step) const;

  gl::Program blur_;
  gl::Texture map_, blurred_;
  gl::FramebufferHandle map_target_, blurred_target_;
  gl::Buffer frame_;
  gl::VertexArray empty_;
  glm::vec4 box_{0};
  Aabb casters_;
};

/// The box of a box in an inner frame.
Aabb box_in(const Pose& X_PW, const Aabb& box_W);

}  // namespace taxel::ui
