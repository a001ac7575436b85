// Two-dimensional textures of fixed size.
#pragma once

#include "ui/gl/handle.h"

namespace taxel::gl {

class Texture {
 public:
  /// Storage of one level; linear filter, clamped to its edge. With `samples` > 0 multisampled. GL_BGRA, not
  /// multisampled: 8 bits a channel, in memory blue first where the driver can.
  Texture(GLenum format, int width, int height, int samples = 0);
  ~Texture() { glDeleteTextures(1, &id_); }
  Texture(const Texture&) = delete;
  Texture& operator=(const Texture&) = delete;

  void upload(GLenum format, GLenum type, const void* pixels) const;  ///< the whole, rows without padding
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
