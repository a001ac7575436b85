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

}  // namespace taxel::gl
