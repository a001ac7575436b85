#include "app/studio/shell/window/png.h"

#include <string>

#include "core/base/error.h"
#include "core/base/files.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wold-style-cast"
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#define STB_IMAGE_WRITE_STATIC
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
