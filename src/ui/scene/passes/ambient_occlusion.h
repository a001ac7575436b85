// Ambient occlusion: creases and corners of the bodies drawn so far get less of the ambient light.
#pragma once

#include <optional>

#include "ui/gl/buffer.h"
#include "ui/gl/framebuffer.h"
#include "ui/gl/program.h"

namespace taxel::ui {

class AmbientOcclusion {
 public:
  explicit AmbientOcclusion(const gl::ShaderReader& read);

  /// Darkens the bodies in `target` (bound), at half the resolution. The background does not change. The frame's
  /// perspective must be bound. `radius` is the distance [m] up to which bodies occlude each other.
  void draw(const gl::Framebuffer& target, double radius);

 private:
  /// A colour layer in a format that stores a distance.
  struct Layer {
    Layer(int width, int height) : texture(GL_RG32F, width, height) {
      gl::attach(target.id(), GL_COLOR_ATTACHMENT0, texture);
    }
    gl::Texture texture;
    gl::FramebufferHandle target;
  };
  void fit(const gl::Framebuffer& target);

  gl::Program occlusion_, blur_, apply_;
  gl::VertexArray empty_;
  std::optional<gl::Framebuffer> depth_;  // copy of the depth, because a bound buffer may not be read
  std::optional<Layer> rough_, smooth_;
};

}  // namespace taxel::ui
