// Objects of OpenGL that are bound for a few calls. OpenGL 4.1 changes an object only through the place where it is
// bound; afterwards the former object is bound again.
#pragma once

#include <epoxy/gl.h>

namespace taxel::gl {

/// Binds an object of OpenGL by `Bind(id)`, until the end of the scope. The driver reports the bound object as `Name`.
template <GLenum Name, auto Bind>
class Bound {
 public:
  explicit Bound(GLuint id) {
    glGetIntegerv(Name, &before_);
    Bind(id);
  }
  ~Bound() { Bind(static_cast<GLuint>(before_)); }
  Bound(const Bound&) = delete;
  Bound& operator=(const Bound&) = delete;

 private:
  GLint before_ = 0;
};

namespace detail {
inline void bind_read(GLuint id) {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, id);
}
inline void bind_draw(GLuint id) {
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, id);
}
inline void bind_texture(GLuint id) {
  glBindTexture(GL_TEXTURE_2D, id);
}
inline void bind_multisampled(GLuint id) {
  glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, id);
}
inline void bind_vertex_array(GLuint id) {
  glBindVertexArray(id);
}
}  // namespace detail

using BoundReadFramebuffer = Bound<GL_READ_FRAMEBUFFER_BINDING, detail::bind_read>;
using BoundDrawFramebuffer = Bound<GL_DRAW_FRAMEBUFFER_BINDING, detail::bind_draw>;
using BoundTexture = Bound<GL_TEXTURE_BINDING_2D, detail::bind_texture>;
using BoundMultisampledTexture = Bound<GL_TEXTURE_BINDING_2D_MULTISAMPLE, detail::bind_multisampled>;
using BoundVertexArray = Bound<GL_VERTEX_ARRAY_BINDING, detail::bind_vertex_array>;

}  // namespace taxel::gl
