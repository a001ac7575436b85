// Shadow of the key light: a depth map seen from the light, rebuilt only if bodies move.
#pragma once

#include <functional>

#include "ui/gl/program.h"
#include "ui/gl/texture.h"
#include "ui/scene/passes/frame_uniforms.h"

namespace taxel::ui {

class KeyShadow {
 public:
  /// `texels` along each side.
  KeyShadow(const gl::ShaderReader& read, int texels);

  /// Draws the map of whatever `draw_casters(program)` draws with the given
  /// program (uniform world_from_mesh). It shows what lies in `shown_W`;
  /// `casters_W` bounds all that casts. `light`: towards it. Leaves another
  /// framebuffer and frame bound.
  void make(const Aabb& shown_W, const Aabb& casters_W, const glm::vec3& light,
            const std::function<void(const gl::Program&)>& draw_casters);
  /// For programs with key_shadow.glsl.
  void use(const gl::Program& program, GLuint unit) const;

 private:
  gl::Program depth_;
  gl::Texture map_;
  gl::FramebufferHandle target_;
  gl::Buffer frame_;
  glm::mat4 map_from_world_{1};
  float texel_ = 0;  // [m]; 0: nothing casts
};

}  // namespace taxel::ui
