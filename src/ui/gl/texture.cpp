#include "ui/gl/texture.h"

namespace taxel::gl {

Texture::Texture(GLenum format, int width, int height, int samples) : width_(width), height_(height) {
  glCreateTextures(samples > 0 ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D, 1, &id_);
  if (samples > 0) {
    glTextureStorage2DMultisample(id_, samples, format, width, height, GL_TRUE);
    return;
  }
  glTextureStorage2D(id_, 1, format, width, height);
  glTextureParameteri(id_, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTextureParameteri(id_, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTextureParameteri(id_, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTextureParameteri(id_, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

void Texture::upload(GLenum format, GLenum type, const void* pixels) const {
  GLint alignment = 4;
  glGetIntegerv(GL_UNPACK_ALIGNMENT, &alignment);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTextureSubImage2D(id_, 0, 0, 0, width_, height_, format, type, pixels);
  glPixelStorei(GL_UNPACK_ALIGNMENT, alignment);
}

}  // namespace taxel::gl
