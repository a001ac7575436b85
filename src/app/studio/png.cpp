#include "app/studio/png.h"

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

void write(const std::filesystem::path& file, int width, int height, int channels,
           const std::vector<unsigned char>& pixels) {
  std::string bytes;
  const auto append = [](void* context, void* data, int size) {
    static_cast<std::string*>(context)->append(static_cast<const char*>(data), static_cast<std::size_t>(size));
  };
  if (stbi_write_png_to_func(append, &bytes, width, height, channels, pixels.data(), channels * width) == 0) {
    throw Error(file.string(), "cannot make a PNG of the picture");
  }
  write_file_atomically(file, bytes);
}

}  // namespace

void write_png(const std::filesystem::path& file, const gl::RgbImage& image) {
  write(file, image.width, image.height, 3, image.rgb);
}

void write_png(const std::filesystem::path& file, const gl::RgbaImage& image) {
  write(file, image.width, image.height, 4, image.rgba);
}

}  // namespace taxel::studio
