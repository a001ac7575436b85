#include "ui/gl/image_texture.h"

#include <cstddef>

namespace taxel::gl {
namespace {

GLenum order_of(int channels) {
  switch (channels) {
    case 1:
      return GL_RED;
    case 2:
      return GL_RG;
    case 3:
      return GL_RGB;
    default:
      return GL_RGBA;
  }
}

/// Returns the stored format: sRGB is converted to linear light before the filter.
GLint format_of(int channels, bool linear) {
  if (channels >= 3) return linear ? GL_SRGB8_ALPHA8 : GL_RGBA8;
  return channels == 1 ? GL_R8 : GL_RG8;
}

}  // namespace

ImageTexture::ImageTexture(Kind kind, int width, int height, int channels, std::span<const std::uint8_t> pixels,
                           bool linear)
    : target_(kind == Kind::cube ? GL_TEXTURE_CUBE_MAP : GL_TEXTURE_2D) {
  glGenTextures(1, &id_);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(target_, id_);
  GLint alignment = 4;
  glGetIntegerv(GL_UNPACK_ALIGNMENT, &alignment);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  const GLenum order = order_of(channels);
  const GLint format = format_of(channels, linear);
  if (kind == Kind::cube) {
    const auto face = static_cast<std::size_t>(width) * static_cast<std::size_t>(width * channels);
    for (unsigned i = 0; i < 6; ++i)
      glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + i, 0, format, width, width, 0, order, GL_UNSIGNED_BYTE,
                   pixels.subspan(i * face, face).data());
  } else {
    glTexImage2D(GL_TEXTURE_2D, 0, format, width, height, 0, order, GL_UNSIGNED_BYTE, pixels.data());
  }
  glPixelStorei(GL_UNPACK_ALIGNMENT, alignment);
  if (channels == 1) {  // grey
    glTexParameteri(target_, GL_TEXTURE_SWIZZLE_G, GL_RED);
    glTexParameteri(target_, GL_TEXTURE_SWIZZLE_B, GL_RED);
  }
  // A mean of two levels would take a software renderer twice the time.
  glTexParameteri(target_, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
  glTexParameteri(target_, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  const GLint wrap = kind == Kind::cube ? GL_CLAMP_TO_EDGE : GL_REPEAT;
  for (const GLenum side : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T}) glTexParameteri(target_, side, wrap);
  glGenerateMipmap(target_);
  glBindTexture(target_, 0);
}

void ImageTexture::bind(GLuint unit) const {
  glActiveTexture(GL_TEXTURE0 + unit);
  glBindTexture(target_, id_);
}

}  // namespace taxel::gl
