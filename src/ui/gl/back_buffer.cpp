#include "ui/gl/back_buffer.h"

#include "ui/gl/bindings.h"
#include "ui/gl/framebuffer.h"

namespace taxel::gl {

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
