// Buffers and the vertex arrays that read them.
#pragma once

#include <span>

#include "ui/gl/handle.h"

namespace taxel::gl {

class Buffer {
 public:
  /// Replaces the whole content. `usage` is GL_STATIC_DRAW (written once) or GL_STREAM_DRAW (written every frame).
  template <class T>
  void upload(std::span<const T> values, GLenum usage) {
    count_ = static_cast<GLsizei>(values.size());
    glNamedBufferData(handle_.id(), static_cast<GLsizeiptr>(values.size_bytes()), values.data(), usage);
  }
  [[nodiscard]] GLuint id() const { return handle_.id(); }
  [[nodiscard]] GLsizei count() const { return count_; }  ///< number of elements of the last upload

 private:
  BufferHandle handle_;
  GLsizei count_ = 0;
};

class VertexArray {
 public:
  /// Connects attribute `location` with `components` values of `type` at `offset` in each `stride` bytes of the buffer.
  /// Integer types are normalised to [0, 1] or [-1, 1].
  void attribute(GLuint location, const Buffer& buffer, GLint components, GLenum type, std::size_t stride,
                 std::size_t offset) {
    const bool normalised = type != GL_FLOAT;
    glEnableVertexArrayAttrib(handle_.id(), location);
    glVertexArrayAttribFormat(handle_.id(), location, components, type, normalised, 0);
    glVertexArrayAttribBinding(handle_.id(), location, location);
    glVertexArrayVertexBuffer(handle_.id(), location, buffer.id(), static_cast<GLintptr>(offset),
                              static_cast<GLsizei>(stride));
  }
  void elements(const Buffer& buffer) { glVertexArrayElementBuffer(handle_.id(), buffer.id()); }
  void bind() const { glBindVertexArray(handle_.id()); }

 private:
  VertexArrayHandle handle_;
};

}  // namespace taxel::gl
