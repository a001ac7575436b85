// An offscreen framebuffer: RGBA8 colour with depth, read back as rows of RGB.
#pragma once

#include <optional>

#include "ui/gl/rgb_image.h"
#include "ui/gl/texture.h"

namespace taxel::gl {

class Framebuffer {
 public:
  /// If `samples` > 0, the framebuffer is multisampled, and resolve() resolves it into texture(). If `stencil` is true,
  /// it has 8 bits of stencil. Throws Error if the driver cannot create it.
  Framebuffer(int width, int height, int samples = 0, bool stencil = false);
  ~Framebuffer();
  Framebuffer(const Framebuffer&) = delete;
  Framebuffer& operator=(const Framebuffer&) = delete;

  void bind() const;           ///< binds the framebuffer for drawing and sets its viewport
  void bind_resolved() const;  ///< binds the framebuffer that read() reads, for more drawing after resolve()
  void resolve() const;        ///< must be called after drawing; does nothing without multisampling
  /// Copies the colour of a framebuffer of the same size. Neither may be multisampled.
  void copy_color(const Framebuffer& from) const;
  /// Copies the depth of a framebuffer of the same size, one sample of each pixel. Both framebuffers must have a
  /// stencil, or neither.
  void copy_depth(const Framebuffer& from) const;
  [[nodiscard]] GLuint texture() const { return color_.id(); }
  [[nodiscard]] const Texture& depth_texture() const { return depth_; }
  [[nodiscard]] int width() const { return color_.width(); }
  [[nodiscard]] int height() const { return color_.height(); }
  [[nodiscard]] int samples() const { return samples_; }
  [[nodiscard]] bool stencil() const { return stencil_; }
  [[nodiscard]] RgbImage read() const;  ///< pixels of the resolved colour
  /// Reads the pixels with straight alpha from premultiplied colours.
  [[nodiscard]] RgbaImage read_with_alpha() const;

 private:
  int samples_;
  bool stencil_;
  Texture color_;
  Texture depth_;
  std::optional<Texture> multisampled_;
  FramebufferHandle target_;                   ///< framebuffer for drawing
  std::optional<FramebufferHandle> resolved_;  ///< resolved copy of color_ if target_ is multisampled
};

/// Makes a texture the colour or the depth of a framebuffer of GL.
void attach(GLuint framebuffer, GLenum attachment, const Texture& texture);
/// Throws Error if GL cannot draw into the framebuffer.
void check_complete(GLuint framebuffer, int width, int height);

/// Reads the colour of a framebuffer of GL. 0 is the window's framebuffer.
RgbImage read_pixels(GLuint framebuffer, int width, int height);

}  // namespace taxel::gl
