// What a window shows, kept from picture to picture. Its pixels lie in memory as those of most windows do, blue first
// and the top row first, so that a software renderer shows it by a mere copy.
#pragma once

#include "ui/gl/texture.h"

namespace taxel::gl {

class BackBuffer {
 public:
  /// Throws Error when the driver cannot make it.
  BackBuffer(int width, int height);

  /// For drawing, with its viewport. Row 0 of GL is the top row: what is drawn has to be upside down.
  void bind() const;
  /// Copies all into a framebuffer of GL (0: the window's) of the same size, the right way up.
  void copy_to(GLuint framebuffer) const;
  [[nodiscard]] int width() const { return color_.width(); }
  [[nodiscard]] int height() const { return color_.height(); }

 private:
  Texture color_;
  FramebufferHandle target_;
};

}  // namespace taxel::gl
