// Objects of OpenGL: handles that own a name, objects that are bound for a few calls, buffers and the vertex arrays
// that read them. All need a current context.
#pragma once

#include <epoxy/gl.h>

#include <span>
#include <utility>

namespace taxel::gl {

/// Deletes its name at its end. Can be moved but not copied.
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

// Objects of OpenGL that are bound for a few calls. OpenGL 4.1 changes an object only through the place where it is
// bound; afterwards the former object is bound again.

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

class Buffer {
 public:
  /// Replaces the whole content. `usage` is GL_STATIC_DRAW (written once) or GL_STREAM_DRAW (written every frame).
  template <class T>
  void upload(std::span<const T> values, GLenum usage) {
    count_ = static_cast<GLsizei>(values.size());
    glBindBuffer(GL_COPY_WRITE_BUFFER, handle_.id());  // no draw call uses this place
    glBufferData(GL_COPY_WRITE_BUFFER, static_cast<GLsizeiptr>(values.size_bytes()), values.data(), usage);
  }
  /// Replaces the whole content by `count` elements of another buffer, each of `size` bytes, from element `first`.
  void copy(const Buffer& from, GLsizei first, GLsizei count, GLsizeiptr size) {
    count_ = count;
    glBindBuffer(GL_COPY_READ_BUFFER, from.id());
    glBindBuffer(GL_COPY_WRITE_BUFFER, handle_.id());
    glBufferData(GL_COPY_WRITE_BUFFER, count * size, nullptr, GL_STREAM_DRAW);
    glCopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, first * size, 0, count * size);
  }
  [[nodiscard]] GLuint id() const { return handle_.id(); }
  [[nodiscard]] GLsizei count() const { return count_; }  ///< number of elements of the last upload

 private:
  BufferHandle handle_;
  GLsizei count_ = 0;
};

/// A texture through which shaders read a buffer as texels of four unsigned words.
class BufferTexture {
 public:
  /// Binds the buffer to a unit for shaders (usamplerBuffer).
  void bind(const Buffer& buffer, GLuint unit) const {
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(GL_TEXTURE_BUFFER, handle_.id());
    glTexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32UI, buffer.id());
  }
  /// Returns the largest number of texels that the driver reads from one buffer.
  [[nodiscard]] static GLint max_texels() {
    GLint texels = 0;
    glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &texels);
    return texels;
  }

 private:
  TextureHandle handle_;
};

class VertexArray {
 public:
  /// Connects attribute `location` with `components` values of `type` at `offset` in each `stride` bytes of the buffer.
  /// Integer types are normalised to [0, 1] or [-1, 1].
  void attribute(GLuint location, const Buffer& buffer, GLint components, GLenum type, std::size_t stride,
                 std::size_t offset) {
    const bool normalised = type != GL_FLOAT;
    const BoundVertexArray bound(handle_.id());
    glBindBuffer(GL_ARRAY_BUFFER, buffer.id());
    glEnableVertexAttribArray(location);
    glVertexAttribPointer(location, components, type, normalised ? GL_TRUE : GL_FALSE, static_cast<GLsizei>(stride),
                          reinterpret_cast<const void*>(offset));  // OpenGL passes the offset as a pointer
  }
  void elements(const Buffer& buffer) {
    const BoundVertexArray bound(handle_.id());
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffer.id());
  }
  void bind() const { glBindVertexArray(handle_.id()); }

 private:
  VertexArrayHandle handle_;
};

}  // namespace taxel::gl
