// The content of a window, kept from frame to frame. The pixels are stored as in most windows, blue first and the top
// row first, so that a software renderer displays them by a plain copy.
#pragma once

#include "ui/gl/texture.h"

namespace taxel::gl {

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
