#include "ui/scene/picture.h"

#include <filesystem>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wold-style-cast"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb_image_write.h>
#pragma GCC diagnostic pop

namespace taxel::test {

gl::OffscreenContext& context() {
  static gl::OffscreenContext instance;
  return instance;
}

void write_picture(const std::string& name, const gl::RgbImage& image) {
  const auto folder = std::filesystem::path(TAXEL_BINARY_DIR) / "pictures";
  std::filesystem::create_directories(folder);
  stbi_write_png((folder / (name + ".png")).c_str(), image.width, image.height, 3, image.rgb.data(), 3 * image.width);
}

std::array<int, 3> pixel_at(const gl::RgbImage& image, const dvec2& position) {
  const auto x = static_cast<std::size_t>(std::floor(position.x)), y = static_cast<std::size_t>(std::floor(position.y));
  const std::size_t at = 3 * (y * static_cast<std::size_t>(image.width) + x);
  return {image.rgb.at(at), image.rgb.at(at + 1), image.rgb.at(at + 2)};
}

}  // namespace taxel::test
