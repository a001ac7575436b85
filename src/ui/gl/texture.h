// Two-dimensional textures of fixed size.
#pragma once

#include <array>

#include "ui/gl/handle.h"

namespace taxel::gl {

class Texture {
 public:
  /// Allocates one level, with a linear filter and clamped to its edge; multisampled if `samples` > 0. GL_BGRA, which
  /// cannot be multisampled, has 8 bits per channel, with blue first in memory if the driver supports it.
  Texture(GLenum format, int width, int height, int samples = 0);
  ~Texture() { glDeleteTextures(1, &id_); }
  Texture(const Texture&) = delete;
  Texture& operator=(const Texture&) = delete;

  void upload(GLenum format, GLenum type, const void* pixels) const;  ///< replaces the image; rows without padding
  /// Binds the texture, which must not be multisampled, to a unit for shaders.
  void bind(GLuint unit) const {
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(GL_TEXTURE_2D, id_);
  }
  void set(GLenum parameter, GLint value) const;
  /// Sets the colour beyond the edges for GL_CLAMP_TO_BORDER.
  void set_border(const std::array<float, 4>& color) const;
  [[nodiscard]] GLuint id() const { return id_; }
  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }

 private:
  GLuint id_ = 0;
  int width_, height_;
};

}  // namespace taxel::gl
