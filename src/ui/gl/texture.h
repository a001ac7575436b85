// Two-dimensional textures of fixed size.
#pragma once

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
  void bind(GLuint unit) const { glBindTextureUnit(unit, id_); }
  [[nodiscard]] GLuint id() const { return id_; }
  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }

 private:
  void store_blue_first() const;

  GLuint id_ = 0;
  int width_, height_;
};

}  // namespace taxel::gl
