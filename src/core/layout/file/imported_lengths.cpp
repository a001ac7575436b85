#include "core/layout/file/imported_lengths.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/base/error.h"

namespace taxel {
namespace {

constexpr double kMinSize = 0.001, kMaxSize = 1;  ///< sizes of sensors [m]
constexpr double kFarthestTaxel = 10;             ///< largest distance of a taxel from the origin of its frame [m]

/// A unit in which files have lengths without a word.
struct LengthUnit {
  const char* word;
  double length;  ///< [m]
};
constexpr LengthUnit kLengthUnits[] = {{"mm", 0.001}, {"cm", 0.01}, {"in", 0.0254}};

double largest_extent(const Aabb& box) {
  const dvec3 extent = box.extent();
  return std::max({extent.x, extent.y, extent.z});
}

/// Returns the remedy for a file whose lengths are in a unit other than m.
std::string remedy(const LengthUnit& unit) {
  return fmt::format("give --unit {0}, or name the unit in the heads of the columns of a table, \"x [{0}]\"",
                     unit.word);
}

/// Returns the median distance of the taxels from the skin if their coordinates are multiplied by `unit`.
double distance_in(const ImportedLayout& imported, const MeshIndex& skin, double unit) {
  std::vector<double> distances;
  for (const Taxel& taxel : imported.layout.taxels)
    distances.push_back(skin.closest_point(unit * taxel.center).distance);
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  return *middle;
}

void check_normals(const ImportedLayout& imported, const std::string& file) {
  constexpr double kMaxError = 0.05;
  for (const Taxel& taxel : imported.layout.taxels) {
    const double length = glm::length(taxel.normal);
    if (length != 0 && !(std::abs(length - 1) <= kMaxError))
      throw Error(
          file, fmt::format("taxel {}", taxel.id),
          fmt::format("the normal must have length 1, has {:.4g}: are its columns scaled or other values?", length));
  }
}

}  // namespace

void apply_unit(ImportedLayout& imported, double unit, const std::string& file) {
  if (imported.has_units) throw Error(file, "names its unit itself: leave --unit out");
  for (Taxel& taxel : imported.layout.taxels) {
    taxel.center *= unit;
    taxel.radius *= unit;
    for (Subtaxel& subtaxel : taxel.subtaxels) {
      subtaxel.center *= unit;
      subtaxel.radius *= unit;
    }
  }
  for (const std::size_t i : imported.missing_radii) imported.layout.taxels[i].radius = Taxel().radius;
}

void check_lengths(const ImportedLayout& imported, const std::string& file) {
  check_normals(imported, file);
  Aabb box;
  double size = 0;
  for (const Taxel& taxel : imported.layout.taxels) {
    box.include(taxel.center);
    if (glm::length(taxel.center) > kFarthestTaxel) size = std::max(size, glm::length(taxel.center));
    if (imported.has_radii()) size = std::max(size, taxel.radius);
  }
  if (imported.layout.taxels.empty() || imported.has_units) return;
  size = std::max(size, largest_extent(box));
  if (size <= kMaxSize) return;
  const auto unit = std::find_if(std::begin(kLengthUnits), std::end(kLengthUnits),
                                 [&](const LengthUnit& one) { return size * one.length <= kMaxSize; });
  throw Error(file, fmt::format("lengths are up to {:.4g} m, but a sensor is at most {} m large{}", size, kMaxSize,
                                unit == std::end(kLengthUnits)
                                    ? std::string(": which unit are they in?")
                                    : fmt::format(": they seem to be in {}; {}", unit->word, remedy(*unit))));
}

void check_near_skin(const ImportedLayout& imported, const MeshIndex& skin, const std::string& file) {
  constexpr double kMaxDistance = 0.25;  // of the skin's size
  const double size = largest_extent(skin.mesh().bounds());
  if (!(size >= kMinSize && size <= kMaxSize))
    throw Error(file, fmt::format("the mesh is {:.4g} m large, but a sensor is {} m to {} m large: give its unit by "
                                  "--scale (0.001 for mm)",
                                  size, kMinSize, kMaxSize));
  if (imported.layout.taxels.empty()) return;
  const double distance = distance_in(imported, skin, 1);
  if (distance <= kMaxDistance * size) return;
  const auto unit = std::find_if(std::begin(kLengthUnits), std::end(kLengthUnits), [&](const LengthUnit& one) {
    return distance_in(imported, skin, one.length) <= kMaxDistance * size;
  });
  throw Error(file, fmt::format("half of the taxels are {:.4g} m or more from the mesh, which is {:.4g} m large: {}",
                                distance, size,
                                unit == std::end(kLengthUnits)
                                    ? std::string("is it the mesh of these taxels, in their frame and unit (--scale)?")
                                    : fmt::format("in {} they are on it; {}", unit->word, remedy(*unit))));
}

}  // namespace taxel
