// Pictures by stb_image, and their dots projected onto a skin.
//
// A dot is a set of dark (or light) pixels connected over edges or corners, found by flood fill in the order of the
// first pixels; its place is the mean of its pixels. The picture is put upright in front of the skin, and a ray from
// each dot against the normal of the picture meets the skin at the taxel. Transparent pixels are white. Only PNG and
// JPEG are compiled in, because other readers of stb_image accept truncated files.
#include "core/layout/generators/image_dots.h"

#include <fmt/format.h>

#include <limits>
#include <memory>
#include <utility>

#include "core/base/error.h"
#include "core/base/files.h"

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

namespace {

const char* const kName = "image";

void check_image_dots(const GreyImage& image, const ImageDots& dots) {
  if (image.width < 1 || image.height < 1 ||
      image.grey.size() != static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height))
    throw Error(kName, "picture", fmt::format("must have pixels, is {} x {}", image.width, image.height));
  if (dots.threshold < 1 || dots.threshold > 255)
    throw Error(kName, "threshold", fmt::format("must be 1 to 255, is {}", dots.threshold));
  require_count(kName, "least_pixels", dots.least_pixels);
  require_positive(kName, "width", dots.width);
  require_positive(kName, "radius", dots.radius);
  require_finite(kName, "center", dots.center);
}

/// Returns the pixels of the dot with this first pixel and removes them from `inside`.
std::pair<dvec2, int> take_dot(const GreyImage& image, std::vector<bool>& inside, std::size_t first) {
  const auto width = static_cast<std::size_t>(image.width);
  dvec2 sum(0);
  int count = 0;
  std::vector<std::size_t> open{first};
  inside[first] = false;
  while (!open.empty()) {
    const std::size_t pixel = open.back();
    open.pop_back();
    const int x = static_cast<int>(pixel % width), y = static_cast<int>(pixel / width);
    sum += dvec2(x + 0.5, y + 0.5);
    ++count;
    for (int v = std::max(y - 1, 0); v <= std::min(y + 1, image.height - 1); ++v) {
      for (int u = std::max(x - 1, 0); u <= std::min(x + 1, image.width - 1); ++u) {
        const std::size_t next = static_cast<std::size_t>(v) * width + static_cast<std::size_t>(u);
        if (!inside[next]) continue;
        inside[next] = false;
        open.push_back(next);
      }
    }
  }
  return {sum / static_cast<double>(count), count};
}

}  // namespace

std::vector<dvec2> dots_of(const GreyImage& image, const ImageDots& dots) {
  check_image_dots(image, dots);
  std::vector<bool> inside(image.grey.size());
  for (std::size_t i = 0; i < inside.size(); ++i) inside[i] = (image.grey[i] < dots.threshold) != dots.light;
  std::vector<dvec2> centers;
  for (std::size_t i = 0; i < inside.size(); ++i) {
    if (!inside[i]) continue;
    const auto [center, pixels] = take_dot(image, inside, i);
    if (pixels < dots.least_pixels) continue;
    if (centers.size() == kMaxGeneratedTaxels)
      throw Error(kName, "picture", fmt::format("has more than {} dots", kMaxGeneratedTaxels));
    centers.push_back(center);
  }
  return centers;
}

DotTaxels image_dots(const GreyImage& image, const ImageDots& dots, const MeshIndex& skin, Beyond beyond) {
  const std::vector<dvec2> centers = dots_of(image, dots);
  const dvec3 normal = require_direction(kName, "normal", dots.normal);
  const dvec3 along = require_direction(kName, "along_row", dots.along_row);
  const dvec3 in_plane = along - glm::dot(along, normal) * normal;
  const double parallel = 1e-6;  // sine of the smallest angle that defines a direction in the plane
  if (glm::length(in_plane) < parallel) throw Error(kName, "along_row", "must not be parallel to normal");
  if (centers.empty())
    throw Error(kName, "picture",
                fmt::format("has no dot {} than {}", dots.light ? "lighter" : "darker", dots.threshold));
  const dvec3 right = glm::normalize(in_plane), up = glm::cross(normal, right);
  const double pixel = dots.width / image.width;
  DotTaxels made{{}, static_cast<int>(centers.size())};
  for (std::size_t i = 0; i < centers.size(); ++i) {
    const dvec3 start = dots.center + pixel * (centers[i].x - 0.5 * image.width) * right +
                        pixel * (0.5 * image.height - centers[i].y) * up;
    const auto at = skin_under(skin, start, -normal, beyond, kName,
                               fmt::format("dot {} at pixel ({:.5g}, {:.5g})", i, centers[i].x, centers[i].y));
    if (at) made.taxels.push_back(taxel_on(skin.mesh(), *at, static_cast<int>(i), dots.radius));
  }
  require_some(kName, made.taxels);
  return made;
}

}  // namespace taxel
