// The colour map of pressures and readings, in the window and in charts.
#pragma once

#include <cstdint>

namespace taxel {

/// A colour of three bytes, as a texture's row holds them.
struct Rgb8 {
  std::uint8_t r = 0, g = 0, b = 0;
};

/// The colours of the lowest to the highest value, sRGB.
extern const Rgb8 kViridis[256];

}  // namespace taxel
