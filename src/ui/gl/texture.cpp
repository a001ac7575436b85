#include "ui/gl/texture.h"

#include "ui/gl/bindings.h"

namespace taxel::gl {
namespace {

/// The order and type of pixels that could be given with a format. None are given, but OpenGL wants them to match.
struct PixelOrder {
  GLenum channels, type;
};

PixelOrder order_for(GLenum format) {
  switch (format) {
    case GL_R8:
      return {GL_RED, GL_UNSIGNED_BYTE};
    case GL_RG32F:
      return {GL_RG, GL_FLOAT};
    case GL_DEPTH_COMPONENT32F:
      return {GL_DEPTH_COMPONENT, GL_FLOAT};
    case GL_DEPTH32F_STENCIL8:
      return {GL_DEPTH_STENCIL, GL_FLOAT_32_UNSIGNED_INT_24_8_REV};
    case GL_BGRA:
      return {GL_BGRA, GL_UNSIGNED_BYTE};
    default:
      return {GL_RGBA, GL_UNSIGNED_BYTE};
  }
}

}  // namespace

Texture::Texture(GLenum format, int width, int height, int samples) : width_(width), height_(height) {
  glGenTextures(1, &id_);
  if (samples > 0) {
    const BoundMultisampledTexture bound(id_);
    glTexImage2DMultisample(GL_TEXTURE_2D_MULTISAMPLE, samples, format, width, height, GL_TRUE);
    return;
  }
  const BoundTexture bound(id_);
  const PixelOrder order = order_for(format);
  // With a sized format the driver chooses the order of the channels; with a base format, Mesa uses the given order.
  const GLenum stored = format == GL_BGRA ? GL_RGBA : format;
  glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(stored), width, height, 0, order.channels, order.type, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

void Texture::set(GLenum parameter, GLint value) const {
  const BoundTexture bound(id_);
  glTexParameteri(GL_TEXTURE_2D, parameter, value);
}

void Texture::set_border(const std::array<float, 4>& color) const {
  const BoundTexture bound(id_);
  glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, color.data());
}

void Texture::upload(GLenum format, GLenum type, const void* pixels) const {
  const BoundTexture bound(id_);
  GLint alignment = 4;
  glGetIntegerv(GL_UNPACK_ALIGNMENT, &alignment);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width_, height_, format, type, pixels);
  glPixelStorei(GL_UNPACK_ALIGNMENT, alignment);
}

}  // namespace taxel::gl
