#include "ui/gl/texture.h"

namespace taxel::gl {

Texture::Texture(GLenum format, int width, int height, int samples) : width_(width), height_(height) {
  glCreateTextures(samples > 0 ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D, 1, &id_);
  if (samples > 0) {
    glTextureStorage2DMultisample(id_, samples, format, width, height, GL_TRUE);
    return;
  }
  if (format == GL_BGRA) {
    store_blue_first();
  } else {
    glTextureStorage2D(id_, 1, format, width, height);
  }
  glTextureParameteri(id_, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTextureParameteri(id_, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTextureParameteri(id_, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTextureParameteri(id_, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

/// Allocates the texture with a base format. With a sized format the driver chooses the order of the channels; with a
/// base format, Mesa uses the order of the given pixels.
void Texture::store_blue_first() const {
  GLint bound = 0;
  glGetIntegerv(GL_TEXTURE_BINDING_2D, &bound);
  glBindTexture(GL_TEXTURE_2D, id_);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, width_, height_, 0, GL_BGRA, GL_UNSIGNED_BYTE, nullptr);
  glBindTexture(GL_TEXTURE_2D, static_cast<GLuint>(bound));
  glTextureParameteri(id_, GL_TEXTURE_MAX_LEVEL, 0);
}

void Texture::upload(GLenum format, GLenum type, const void* pixels) const {
  GLint alignment = 4;
  glGetIntegerv(GL_UNPACK_ALIGNMENT, &alignment);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTextureSubImage2D(id_, 0, 0, 0, width_, height_, format, type, pixels);
  glPixelStorei(GL_UNPACK_ALIGNMENT, alignment);
}

}  // namespace taxel::gl
