// Reads images by stb_image. Only PNG and JPEG, because its other readers accept truncated files.
#include "core/base/files.h"
#include "core/layout/generators/image_dots.h"

#include <fmt/format.h>

#include <limits>
#include <memory>

#include "core/base/error.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wold-style-cast"
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wunused-but-set-variable"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#pragma GCC diagnostic ignored "-Wsign-compare"
#define STBI_NO_STDIO
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#include <stb_image.h>
#pragma GCC diagnostic pop

namespace taxel {

GreyImage read_grey_image(const std::filesystem::path& path) {
  const std::string bytes = read_file(path);
  if (bytes.size() > std::numeric_limits<int>::max()) throw Error(path.string(), "is too large for a picture");
  const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
  const int size = static_cast<int>(bytes.size()), grey_and_alpha = 2;
  int width = 0, height = 0, channels = 0;
  const auto refuse = [&] {
    throw Error(path.string(), fmt::format("is no picture that can be read: {}", stbi_failure_reason()));
  };
  if (stbi_info_from_memory(data, size, &width, &height, &channels) == 0) refuse();
  const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height), most = 100'000'000;
  if (pixels > most) throw Error(path.string(), fmt::format("has {} x {} pixels, more than {}", width, height, most));
  const std::unique_ptr<stbi_uc, void (*)(void*)> decoded(
      stbi_load_from_memory(data, size, &width, &height, &channels, grey_and_alpha), stbi_image_free);
  if (!decoded) refuse();
  GreyImage image{width, height, std::vector<std::uint8_t>(pixels)};
  for (std::size_t i = 0; i < pixels; ++i) {
    const int grey = decoded.get()[2 * i], alpha = decoded.get()[2 * i + 1];
    image.grey[i] = static_cast<std::uint8_t>((grey * alpha + 255 * (255 - alpha) + 127) / 255);
  }
  return image;
}

}  // namespace taxel
