// Owning handles of OpenGL names: the name is deleted with its handle; handles can be moved but not copied. All need a
// current context.
#pragma once

#include <epoxy/gl.h>

#include <utility>

namespace taxel::gl {

template <auto Create, auto Delete>
class Handle {
 public:
  Handle() : id_(Create()) {}
  ~Handle() {
    if (id_ != 0) Delete(id_);
  }
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, 0)) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(id_, other.id_);
    return *this;
  }
  [[nodiscard]] GLuint id() const { return id_; }

 private:
  GLuint id_;
};

namespace detail {
inline GLuint create_buffer() {
  GLuint id = 0;
  glGenBuffers(1, &id);
  return id;
}
inline void delete_buffer(GLuint id) {
  glDeleteBuffers(1, &id);
}
inline GLuint create_texture() {
  GLuint id = 0;
  glGenTextures(1, &id);
  return id;
}
inline void delete_texture(GLuint id) {
  glDeleteTextures(1, &id);
}
inline GLuint create_vertex_array() {
  GLuint id = 0;
  glGenVertexArrays(1, &id);
  return id;
}
inline void delete_vertex_array(GLuint id) {
  glDeleteVertexArrays(1, &id);
}
inline GLuint create_framebuffer() {
  GLuint id = 0;
  glGenFramebuffers(1, &id);
  return id;
}
inline void delete_framebuffer(GLuint id) {
  glDeleteFramebuffers(1, &id);
}
inline GLuint create_program() {
  return glCreateProgram();
}
inline void delete_program(GLuint id) {
  glDeleteProgram(id);
}
}  // namespace detail

using BufferHandle = Handle<detail::create_buffer, detail::delete_buffer>;
using TextureHandle = Handle<detail::create_texture, detail::delete_texture>;
using VertexArrayHandle = Handle<detail::create_vertex_array, detail::delete_vertex_array>;
using FramebufferHandle = Handle<detail::create_framebuffer, detail::delete_framebuffer>;
using ProgramHandle = Handle<detail::create_program, detail::delete_program>;

}  // namespace taxel::gl
