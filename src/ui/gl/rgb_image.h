// A picture in memory, as PNG writers want it.
#pragma once

#include <vector>

namespace taxel::gl {

/// Top row first, 3 bytes a pixel (sRGB), no padding.
struct RgbImage {
  int width = 0, height = 0;
  std::vector<unsigned char> rgb;
  bool operator==(const RgbImage&) const = default;
};

/// Top row first, 4 bytes a pixel (sRGB, straight alpha), no padding.
struct RgbaImage {
  int width = 0, height = 0;
  std::vector<unsigned char> rgba;
  bool operator==(const RgbaImage&) const = default;
};

}  // namespace taxel::gl
