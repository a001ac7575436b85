// A small blurred image of bodies seen from above, used for soft shadows.
#pragma once

#include "ui/gl/framebuffer.h"
#include "ui/gl/program.h"
#include "ui/scene/passes/frame_uniforms.h"

namespace taxel::ui {

class TopView {
 public:
  explicit TopView(const gl::ShaderReader& read);

  /// Clears the image to `empty`, and sets up the view along -z of P, with a margin around `box_W`, for the following
  /// draws. Returns false if there is nothing to draw. The caller must bind its target and frame again.
  bool begin(const Pose& X_WP, const Aabb& box_W, float empty);
  void blur() const;

  void bind(GLuint unit) const { map_.bind(unit); }
  [[nodiscard]] const glm::vec4& box() const { return box_; }     ///< lower corner and size in P [m]; size 0 if empty
  [[nodiscard]] const Aabb& casters() const { return casters_; }  ///< box of the casters in P [m]

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

/// Returns the bounding box, in an inner frame, of a box.
Aabb box_in(const Pose& X_PW, const Aabb& box_W);

}  // namespace taxel::ui
