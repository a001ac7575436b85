// Images that shaders read with smooth minification: flat ones that repeat, and the six faces of a cube.
#pragma once

#include <epoxy/gl.h>

#include <cstdint>
#include <span>

namespace taxel::gl {

/// An image of 8 bits per channel with all its smaller levels.
class ImageTexture {
 public:
  enum class Kind { flat, cube };

  /// Uploads rows of `channels` (1 to 4) values. The faces of a cube are `width` pixels wide and high, one below
  /// another, in OpenGL's order. If `linear`, shaders read the sRGB values as linear light; only images with 3 or 4
  /// channels are converted.
  ImageTexture(Kind kind, int width, int height, int channels, std::span<const std::uint8_t> pixels, bool linear);
  ~ImageTexture() { glDeleteTextures(1, &id_); }
  ImageTexture(const ImageTexture&) = delete;
  ImageTexture& operator=(const ImageTexture&) = delete;

  void bind(GLuint unit) const;

 private:
  GLenum target_;
  GLuint id_ = 0;
};

}  // namespace taxel::gl
