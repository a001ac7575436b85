// Taxels at the dots of an image: a drawing or a photograph of a sensor in front of its skin.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "core/layout/generators/place.h"
#include "core/layout/layout.h"
#include "core/mesh/query/closest_point.h"

namespace taxel {

/// Pixels row by row from the top, from 0 (black) to 255 (white).
struct GreyImage {
  int width = 0, height = 0;
  std::vector<std::uint8_t> grey;
};

/// Reads a PNG or JPEG file. Transparent pixels become white. Throws Error that names the file if it is missing, not
/// readable, or has more than 100 million pixels.
GreyImage read_grey_image(const std::filesystem::path& path);

struct ImageDots {
  int threshold = 128;   ///< pixels darker than this belong to dots
  bool light = false;    ///< true if all other pixels belong to dots instead
  int least_pixels = 1;  ///< smaller dots are ignored
  // Place of the image. In the view from the tip of `normal`, with along_row to the right, the image is upright.
  double width = 0.02;       ///< width of the image [m]; its pixels are square
  dvec3 center{0};           ///< centre of the image, outside of the skin [m]
  dvec3 along_row{1, 0, 0};  ///< any length; projected onto the image plane
  dvec3 normal{0, 0, 1};     ///< normal of the image, away from the skin; any length
  double radius = 0.005;     ///< radius of the receptive fields [m]
};

/// Returns the centres of the dots in pixels, x to the right and y down from the upper left corner of the image. A dot
/// is a set of pixels connected over edges or corners; its centre is their mean. Dots are in the order of their first
/// pixels, row by row. Throws Error if the image has no pixels, the threshold is
/// not from 1 to 255, or there are more than kMaxGeneratedTaxels dots.
std::vector<dvec2> dots_of(const GreyImage& image, const ImageDots& dots);

struct DotTaxels {
  std::vector<Taxel> taxels;
  int dots = 0;  ///< number of dots in the image
};

/// Returns a taxel for each dot, at the first intersection of the skin with the ray from the dot against the normal of
/// the image, with the smooth normal there. Ids are in the order of dots_of. Throws Error that names the parameter, or
/// the dot whose ray misses the skin, and for an image without dots.
DotTaxels image_dots(const GreyImage& image, const ImageDots& dots, const MeshIndex& skin,
                     Beyond beyond = Beyond::refuse);

}  // namespace taxel
