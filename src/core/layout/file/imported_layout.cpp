// The check of lengths, and values from the skin.

#include "core/layout/file/imported_layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>

#include "core/base/error.h"
#include "core/layout/sensor_frame.h"
#include "core/mesh/query/closest_point.h"
#include "core/mesh/topology/mesh_check.h"

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

namespace {

constexpr double kMaxImportedSamples = 1e5;  ///< limit for the whole skin; a million takes a minute
constexpr int kMaxCells = 100000;            ///< limit of a flat array; more mean wrong units of the pitch

/// Returns the normal of the nearest face. Smooth normals would lean outward on the faces of a box.
dvec3 normal_of_skin(const MeshIndex& skin, const dvec3& place) {
  return skin.mesh().face_normals()[static_cast<std::size_t>(skin.closest_point(place).face)];
}

/// Gives the taxels whose normal is zero that of the skin.
void take_normals(ImportedLayout& imported, const MeshIndex& skin) {
  std::size_t taken = 0;
  for (Taxel& taxel : imported.layout.taxels) {
    if (taxel.normal != dvec3(0)) continue;
    taxel.normal = normal_of_skin(skin, taxel.center);
    ++taken;
  }
  if (imported.has_normals && taken > 0)
    imported.notes.push_back(fmt::format("{} taxels have the normal 0 0 0: those of the skin are taken", taken));
}

/// Turns all normals over if all of them point into the skin: some programs list the direction of the push.
void turn_inward_normals(ImportedLayout& imported, const MeshIndex& skin) {
  constexpr double kOpposed = -0.5;  // cosine of 120 degrees
  std::vector<Taxel>& taxels = imported.layout.taxels;
  const auto is_inward = [&](const Taxel& taxel) {
    return glm::dot(glm::normalize(taxel.normal), normal_of_skin(skin, taxel.center)) < kOpposed;
  };
  if (taxels.empty() || !std::all_of(taxels.begin(), taxels.end(), is_inward)) return;
  for (Taxel& taxel : taxels) taxel.normal = dvec3(0) - taxel.normal;
  imported.notes.emplace_back("all normals point into the skin: they are turned over");
}

/// Adds a taxel where the middle of each cell, seen from above, is on the skin; row by row along y, in the order of the
/// released code.
void add_cells(ImportedLayout& imported, const MeshIndex& skin, const std::string& file) {
  const Aabb& box = skin.mesh().bounds();
  const dvec3 size = box.extent();
  const double cell = imported.cell;
  const auto count = [&](double extent) { return std::floor(extent / cell + 1e-9); };
  if (count(size.x) < 1 || count(size.y) < 1)
    throw Error(file, fmt::format("a cell of {} m is larger than the mesh, {:.4g} x {:.4g} m", cell, size.x, size.y));
  if (count(size.x) * count(size.y) > kMaxCells)
    throw Error(file, fmt::format("cells of {} m over {:.4g} x {:.4g} m are more than {}: check --scale", cell, size.x,
                                  size.y, kMaxCells));
  const int columns = static_cast<int>(count(size.x)), rows = static_cast<int>(count(size.y));
  int missed = 0;
  for (int i = 0; i < columns; ++i) {
    for (int j = 0; j < rows; ++j) {
      const dvec3 above(box.lo.x + cell * (i + 0.5), box.lo.y + cell * (j + 0.5), box.hi.z + size.z + cell);
      const std::optional<MeshHit> hit = skin.cast({above, {0, 0, -1}});
      if (!hit) {
        ++missed;
        continue;
      }
      Taxel taxel;
      taxel.id = i * rows + j;
      taxel.center = {above.x, above.y, above.z - hit->t};
      taxel.normal = skin.mesh().face_normals()[static_cast<std::size_t>(hit->face)];
      taxel.radius = 0.5 * cell;
      imported.layout.taxels.push_back(taxel);
    }
  }
  if (imported.layout.taxels.empty()) throw Error(file, "no cell of the flat array is above the skin");
  if (missed > 0)
    imported.notes.push_back(fmt::format("{} of {} cells are not above the skin: left out", missed, columns * rows));
}

/// Returns the frame of a planar array: distal along its longer side, pad along its normal. Returns nothing if the
/// taxels' normals differ from that normal.
std::optional<SensorFrame> frame_of_array(const std::vector<Taxel>& taxels) {
  if (taxels.size() < 2) return std::nullopt;
  const dvec3 n = glm::normalize(taxels.front().normal);
  Aabb box;
  for (const Taxel& taxel : taxels) {
    if (!(glm::dot(glm::normalize(taxel.normal), n) > 0.9999)) return std::nullopt;
    box.include(taxel.center);
  }
  int best = -1;
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(n[axis]) > 0.5) continue;
    if (best < 0 || box.extent()[axis] > box.extent()[best] * (1 + 1e-9)) best = axis;
  }
  dvec3 along(0);
  along[best] = 1;
  return SensorFrame{glm::normalize(along - glm::dot(along, n) * n), n};
}

/// Returns a density of at most kMaxImportedSamples samples, with one significant digit.
void limit_density(ImportedLayout& imported, double area) {
  Sampling& sampling = imported.layout.sampling;
  if (imported.has_density) return;
  const double most = kMaxImportedSamples / area;
  if (sampling.density > most) {
    const double decade = std::pow(10.0, std::floor(std::log10(most)));
    sampling.density = std::floor(most / decade) * decade;
  }
  imported.notes.push_back(
      fmt::format("the density of the samples is {:.4g} per m^2: the file gives none", sampling.density));
}

}  // namespace

double guess_scale(const ImportedLayout& imported, const TriMesh& unscaled) {
  if (imported.layout.taxels.empty()) return guess_unit(unscaled).scale;
  const MeshIndex index(std::make_shared<const TriMesh>(unscaled));
  double best = 1, least = std::numeric_limits<double>::infinity();
  for (const double scale : {1.0, 0.001, 0.01, 0.0254}) {
    double sum = 0;
    for (const Taxel& taxel : imported.layout.taxels) sum += scale * index.closest_point(taxel.center / scale).distance;
    if (sum < least * (1 - 1e-9)) {
      least = sum;
      best = scale;
    }
  }
  return best;
}

std::string take_frame_of(const TriMesh& skin, Layout& layout) {
  std::optional<SensorFrame> guess = frame_of_array(layout.taxels);
  if (!guess) guess = guess_frame(skin, layout.taxels);
  layout.frame = guess.value_or(layout.frame);
  const dvec3 &d = layout.frame.distal, &p = layout.frame.pad;
  return fmt::format(
      "the file does not say where the sensor points: distal is [{:.3g}, {:.3g}, {:.3g}], pad is "
      "[{:.3g}, {:.3g}, {:.3g}]{}",
      d.x, d.y, d.z, p.x, p.y, p.z, guess ? ", guessed from its shape" : "");
}

void put_on_skin(ImportedLayout& imported, const TriMeshPtr& skin, const std::string& file) {
  const MeshIndex index(skin);
  if (imported.cell > 0) add_cells(imported, index, file);
  check_near_skin(imported, index, file);
  take_normals(imported, index);
  if (imported.cell <= 0) turn_inward_normals(imported, index);
  if (imported.layout.taxels.empty()) return;
  if (!imported.has_frame) imported.notes.push_back(take_frame_of(*skin, imported.layout));
  limit_density(imported, skin->area());
}

}  // namespace taxel
