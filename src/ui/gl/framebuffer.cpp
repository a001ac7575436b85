#include "ui/gl/framebuffer.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/error.h"
#include "ui/gl/bindings.h"

namespace taxel::gl {
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

}  // namespace taxel::gl
