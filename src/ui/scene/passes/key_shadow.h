// Shadow of the key light: a depth map seen from the light, rebuilt only if bodies move.
#pragma once

#include <functional>

#include "ui/gl/program.h"
#include "ui/gl/texture.h"
#include "ui/scene/passes/frame_uniforms.h"

namespace taxel::ui {

class KeyShadow {
 public:
  /// The map has `texels` texels along each side.
  KeyShadow(const gl::ShaderReader& read, int texels);

  /// Draws the map of the bodies that `draw_casters(program)` draws with the given program (uniform world_from_mesh).
  /// `shown_W` is the box that the map covers, `casters_W` bounds all casters, and `light` is the direction towards the
  /// light. Leaves another framebuffer and frame bound.
  void make(const Aabb& shown_W, const Aabb& casters_W, const glm::vec3& light,
            const std::function<void(const gl::Program&)>& draw_casters);
  /// Binds the map for a program that includes key_shadow.glsl.
  void use(const gl::Program& program, GLuint unit) const;

 private:
  gl::Program depth_;
  gl::Texture map_;
  gl::FramebufferHandle target_;
  gl::Buffer frame_;
  glm::mat4 map_from_world_{1};
  float offset_ = 0;  // distance above a surface at which its light is looked up [m]; 0 if there are no casters
};

}  // namespace taxel::ui
