// Images in memory, in the layout that PNG writers use.
#pragma once

#include <vector>

namespace taxel::gl {

/// An image without alpha: top row first, 3 bytes per pixel (sRGB), no padding.
struct RgbImage {
  int width = 0, height = 0;
  std::vector<unsigned char> rgb;
  bool operator==(const RgbImage&) const = default;
};

/// An image with alpha: top row first, 4 bytes per pixel (sRGB, straight alpha), no padding.
struct RgbaImage {
  int width = 0, height = 0;
  std::vector<unsigned char> rgba;
  bool operator==(const RgbaImage&) const = default;
};

}  // namespace taxel::gl
