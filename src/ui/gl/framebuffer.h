// Textures of fixed size, offscreen framebuffers of RGBA8 colour with depth, read back as rows of RGB, and the kept
// content of a window.
#pragma once

#include <array>
#include <optional>

#include "ui/gl/objects.h"
#include "ui/gl/rgb_image.h"

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
  /// Binds the texture, which must not be multisampled, to a unit for shaders.
  void bind(GLuint unit) const {
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(GL_TEXTURE_2D, id_);
  }
  void set(GLenum parameter, GLint value) const;
  /// Sets the colour beyond the edges for GL_CLAMP_TO_BORDER.
  void set_border(const std::array<float, 4>& color) const;
  [[nodiscard]] GLuint id() const { return id_; }
  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }

 private:
  GLuint id_ = 0;
  int width_, height_;
};

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

/// The content of a window, kept from frame to frame. The pixels are stored as in most windows, blue first and the top
/// row first, so that a software renderer displays them by a plain copy.
class BackBuffer {
 public:
  /// Throws Error if the driver cannot create the buffer.
  BackBuffer(int width, int height);

  /// Binds the buffer for drawing and sets its viewport. Row 0 of GL is the top row, so everything has to be drawn
  /// upside down.
  void bind() const;
  /// Copies the content, the right way up, into a framebuffer of GL of the same size. 0 is the window's framebuffer.
  void copy_to(GLuint framebuffer) const;
  [[nodiscard]] int width() const { return color_.width(); }
  [[nodiscard]] int height() const { return color_.height(); }

 private:
  Texture color_;
  FramebufferHandle target_;
};

}  // namespace taxel::gl
