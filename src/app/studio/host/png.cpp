#include "app/studio/host/png.h"

#include <zlib.h>

#include <cstdlib>
#include <memory>
#include <string>

#include "core/base/error.h"
#include "core/base/files.h"

namespace {

/// Compresses the rows of a PNG for stb_image_write, whose own compression takes three times as long and gives a file
/// that is an eighth larger.
unsigned char* compress_rows(unsigned char* rows, int size, int* compressed_size, int /*quality*/) {
  constexpr int kLevel = 3;  // a picture of the window is 11 % larger than at level 6
  uLongf room = compressBound(static_cast<uLong>(size));
  std::unique_ptr<unsigned char, decltype(&std::free)> bytes(static_cast<unsigned char*>(std::malloc(room)), std::free);
  if (!bytes || compress2(bytes.get(), &room, rows, static_cast<uLong>(size), kLevel) != Z_OK) return nullptr;
  *compressed_size = static_cast<int>(room);
  return bytes.release();
}

}  // namespace

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wold-style-cast"
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#define STB_IMAGE_WRITE_STATIC
#define STBIW_ZLIB_COMPRESS compress_rows
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb_image_write.h>
#pragma GCC diagnostic pop

namespace taxel::studio {

namespace {

std::string bytes_of(int width, int height, int channels, const std::vector<unsigned char>& pixels) {
  std::string bytes;
  const auto append = [](void* context, void* data, int size) {
    static_cast<std::string*>(context)->append(static_cast<const char*>(data), static_cast<std::size_t>(size));
  };
  if (stbi_write_png_to_func(append, &bytes, width, height, channels, pixels.data(), channels * width) == 0) {
    throw Error("cannot make a PNG of the picture");
  }
  return bytes;
}

}  // namespace

std::string png_bytes(const gl::RgbImage& image) {
  return bytes_of(image.width, image.height, 3, image.rgb);
}

std::string png_bytes(const gl::RgbaImage& image) {
  return bytes_of(image.width, image.height, 4, image.rgba);
}

void write_png(const std::filesystem::path& file, const gl::RgbImage& image) {
  write_file_atomically(file, png_bytes(image));
}

void write_png(const std::filesystem::path& file, const gl::RgbaImage& image) {
  write_file_atomically(file, png_bytes(image));
}

}  // namespace taxel::studio
