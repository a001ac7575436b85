// Taxels where a picture has dots: a drawing or a photograph of a sensor, laid before its skin.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "core/layout/generators/place.h"
#include "core/layout/layout.h"
#include "core/mesh/query/closest_point.h"

namespace taxel {

/// Row by row from the top, 0 black to 255 white.
struct GreyImage {
  int width = 0, height = 0;
  std::vector<std::uint8_t> grey;
};

/// PNG or JPEG. What is transparent is white. Throws Error naming the file: missing, no picture
/// that can be read, or more than 100 million pixels.
GreyImage read_grey_image(const std::filesystem::path& path);

struct ImageDots {
  int threshold = 128;   ///< a pixel belongs to a dot where it is darker than this
  bool light = false;    ///< or, instead, as light or lighter
  int least_pixels = 1;  ///< smaller dots are dust
  // How the picture lies. Seen from the tip of `normal`, upright where along_row points to the right.
  double width = 0.02;       ///< of the whole picture [m]; its pixels are square
  dvec3 center{0};           ///< of the picture, outside of the skin [m]
  dvec3 along_row{1, 0, 0};  ///< any length; turned into the picture's plane
  dvec3 normal{0, 0, 1};     ///< of the picture, away from the skin; any length
  double radius = 0.005;     ///< of the receptive fields [m]
};

/// Centres of the dots in pixels, x to the right and y down from the picture's upper left corner. A dot are pixels that
/// hang together over edges or corners; its centre is their mean. In the order of their first pixels, row by row.
std::vector<dvec2> dots_of(const GreyImage& image, const ImageDots& dots);

struct DotTaxels {
  std::vector<Taxel> taxels;
  int dots = 0;  ///< in the picture
};

/// A taxel for each dot, where the ray from it against the picture's normal first meets the skin, with the smooth
/// normal there; ids in the order of dots_of. Throws Error naming the parameter, or the dot whose ray misses the skin;
/// also for a picture without dots.
DotTaxels image_dots(const GreyImage& image, const ImageDots& dots, const MeshIndex& skin,
                     Beyond beyond = Beyond::refuse);

}  // namespace taxel
