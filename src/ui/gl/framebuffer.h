// An offscreen picture: RGBA8 colour with depth, read back as rows of RGB.
#pragma once

#include <optional>

#include "ui/gl/rgb_image.h"
#include "ui/gl/texture.h"

namespace taxel::gl {

class Framebuffer {
 public:
  /// `samples` > 0: drawn multisampled, resolved into texture() by resolve(). `stencil`: with 8 bits of it.
  /// Throws Error when the driver cannot make it.
  Framebuffer(int width, int height, int samples = 0, bool stencil = false);

  void bind() const;     ///< for drawing, with its viewport
  void resolve() const;  ///< after drawing; nothing to do without multisampling
  /// Takes over the colour of a framebuffer of the same size; neither is multisampled.
  void copy_color(const Framebuffer& from) const;
  /// Takes over the depth of a framebuffer of the same size, one sample of each pixel; both with a stencil, or neither.
  void copy_depth(const Framebuffer& from) const;
  [[nodiscard]] GLuint texture() const { return color_.id(); }
  [[nodiscard]] GLuint depth_texture() const { return depth_.id(); }
  [[nodiscard]] int width() const { return color_.width(); }
  [[nodiscard]] int height() const { return color_.height(); }
  [[nodiscard]] int samples() const { return samples_; }
  [[nodiscard]] bool stencil() const { return stencil_; }
  [[nodiscard]] RgbImage read() const;  ///< pixels of the resolved colour
  /// The same with alpha, from premultiplied colours.
  [[nodiscard]] RgbaImage read_with_alpha() const;

 private:
  int samples_;
  bool stencil_;
  Texture color_;
  Texture depth_;
  std::optional<Texture> multisampled_;
  FramebufferHandle target_;                   ///< drawn into
  std::optional<FramebufferHandle> resolved_;  ///< resolved copy of color_ if target_ is multisampled
};

/// Throws Error where GL cannot draw into the framebuffer.
void check_complete(GLuint framebuffer, int width, int height);

/// Reads the colour of a framebuffer of GL (0: the window's).
RgbImage read_pixels(GLuint framebuffer, int width, int height);

}  // namespace taxel::gl
