#include "ui/gl/framebuffer.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/error.h"
#include "ui/gl/objects.h"

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

namespace {

/// Reads rows of pixels in `format`, top row first.
std::vector<unsigned char> read_rows(GLuint framebuffer, int width, int height, GLenum format, std::size_t channels) {
  const auto row = static_cast<std::size_t>(width) * channels;
  std::vector<unsigned char> bytes(row * static_cast<std::size_t>(height));
  const BoundReadFramebuffer bound(framebuffer);
  GLint alignment = 4;
  glGetIntegerv(GL_PACK_ALIGNMENT, &alignment);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width, height, format, GL_UNSIGNED_BYTE, bytes.data());
  glPixelStorei(GL_PACK_ALIGNMENT, alignment);
  for (int top = 0, bottom = height - 1; top < bottom; ++top, --bottom) {  // GL's first row is the lowest
    const auto a = bytes.begin() + static_cast<std::ptrdiff_t>(row) * top;
    std::swap_ranges(a, a + static_cast<std::ptrdiff_t>(row),
                     bytes.begin() + static_cast<std::ptrdiff_t>(row) * bottom);
  }
  return bytes;
}

/// Copies the whole of a framebuffer of GL into another one of the same size.
void copy(GLuint from, GLuint to, int width, int height, GLbitfield what) {
  const BoundReadFramebuffer source(from);
  const BoundDrawFramebuffer target(to);
  glBlitFramebuffer(0, 0, width, height, 0, 0, width, height, what, GL_NEAREST);
}

}  // namespace

void attach(GLuint framebuffer, GLenum attachment, const Texture& texture) {
  const BoundDrawFramebuffer bound(framebuffer);
  glFramebufferTexture(GL_DRAW_FRAMEBUFFER, attachment, texture.id(), 0);
}

void check_complete(GLuint framebuffer, int width, int height) {
  const BoundDrawFramebuffer bound(framebuffer);
  const GLenum status = glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER);
  if (status == GL_FRAMEBUFFER_COMPLETE) return;
  throw Error(
      fmt::format("OpenGL cannot draw into a picture of {} x {} pixels (status 0x{:x})", width, height, status));
}

Framebuffer::Framebuffer(int width, int height, int samples, bool stencil)
    : samples_(samples),
      stencil_(stencil),
      color_(GL_RGBA8, width, height),
      depth_(stencil ? GL_DEPTH32F_STENCIL8 : GL_DEPTH_COMPONENT32F, width, height, samples) {
  if (samples > 0) {
    multisampled_.emplace(GL_RGBA8, width, height, samples);
    resolved_.emplace();
    attach(resolved_->id(), GL_COLOR_ATTACHMENT0, color_);
    check_complete(resolved_->id(), width, height);
  }
  attach(target_.id(), GL_COLOR_ATTACHMENT0, multisampled_ ? *multisampled_ : color_);
  attach(target_.id(), stencil ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT, depth_);
  check_complete(target_.id(), width, height);
}

// Inlined into its callers, this makes g++ 14 warn of handles without a value, though an optional holds none of those.
Framebuffer::~Framebuffer() = default;

void Framebuffer::bind() const {
  glBindFramebuffer(GL_FRAMEBUFFER, target_.id());
  glViewport(0, 0, width(), height());
}

void Framebuffer::bind_resolved() const {
  glBindFramebuffer(GL_FRAMEBUFFER, resolved_ ? resolved_->id() : target_.id());
  glViewport(0, 0, width(), height());
}

void Framebuffer::resolve() const {
  if (!resolved_) return;
  copy(target_.id(), resolved_->id(), width(), height(), GL_COLOR_BUFFER_BIT);
}

void Framebuffer::copy_color(const Framebuffer& from) const {
  copy(from.target_.id(), target_.id(), width(), height(), GL_COLOR_BUFFER_BIT);
}

void Framebuffer::copy_depth(const Framebuffer& from) const {
  copy(from.target_.id(), target_.id(), width(), height(), GL_DEPTH_BUFFER_BIT);
}

RgbImage Framebuffer::read() const {
  return read_pixels(resolved_ ? resolved_->id() : target_.id(), width(), height());
}

RgbaImage Framebuffer::read_with_alpha() const {
  const GLuint from = resolved_ ? resolved_->id() : target_.id();
  RgbaImage image{width(), height(), read_rows(from, width(), height(), GL_RGBA, 4)};
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    const int alpha = image.rgba[i + 3];
    for (std::size_t k = i; k < i + 3 && alpha > 0; ++k) {
      image.rgba[k] = static_cast<unsigned char>(std::min(255, (255 * image.rgba[k] + alpha / 2) / alpha));
    }
  }
  return image;
}

RgbImage read_pixels(GLuint framebuffer, int width, int height) {
  return {width, height, read_rows(framebuffer, width, height, GL_RGB, 3)};
}

BackBuffer::BackBuffer(int width, int height) : color_(GL_BGRA, width, height) {
  attach(target_.id(), GL_COLOR_ATTACHMENT0, color_);
  check_complete(target_.id(), width, height);
}

void BackBuffer::bind() const {
  glBindFramebuffer(GL_FRAMEBUFFER, target_.id());
  glViewport(0, 0, width(), height());
}

void BackBuffer::copy_to(GLuint framebuffer) const {
  const BoundReadFramebuffer from(target_.id());
  const BoundDrawFramebuffer to(framebuffer);
  glBlitFramebuffer(0, 0, width(), height(), 0, height(), width(), 0, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

}  // namespace taxel::gl
