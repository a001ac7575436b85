// Buffers and the vertex arrays that read them.
#pragma once

#include <span>

#include "ui/gl/bindings.h"
#include "ui/gl/handle.h"

namespace taxel::gl {

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
