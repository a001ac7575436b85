// Patterns of taxels as a user chooses them: the kind, its parameters, and the place on the skin.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/layout/generators/image_dots.h"
#include "core/layout/layout.h"
#include "core/mesh/query/closest_point.h"

namespace taxel {

enum class PatternKind {
  grid,
  ring,
  helix,
  spiral,  ///< spiral of a sunflower's seeds
  spread,  ///< even spread by geodesic distance
  table,   ///< taxels of a CSV file
  image,   ///< dots of an image
  preset   ///< taxels of a known sensor
};

/// Place of a pattern: a point of the skin, the skin's normal there, and the direction of rows in the tangent plane.
struct PlacingFrame {
  dvec3 center{0};
  dvec3 normal{0, 0, 1};
  dvec3 along_row{1, 0, 0};
  bool operator==(const PlacingFrame&) const = default;
};

/// Axis of a ring or helix: a direction of the sensor's frame, or an axis of the mesh file.
enum class PatternAxis { distal, x, y, z };

/// A kind of pattern and its parameters; lengths are in metres. A kind uses `radius` and the fields that name the kind.
struct Pattern {
  PatternKind kind = PatternKind::grid;
  double radius = 0.004;  ///< radius of receptive fields; a table or preset can have its own
  double turn_deg = 0;    ///< counter-clockwise turn about the normal; ring, helix: the axis
  /// True if points that are not over the skin get no taxel, false if they are an error. Grid, spiral, image, preset.
  bool leave_out = true;
  int count = 24;  ///< number of taxels: ring, helix, spiral, spread
  int rows = 3, columns = 4;
  double row_pitch = 0.005, column_pitch = 0.005;
  bool projected = true;  ///< grid: on the skin, not in the tangent plane
  PatternAxis axis = PatternAxis::distal;
  double rise = 0.01;         ///< helix: height from the first to the last taxel
  double turns = 2;           ///< helix: number of turns; negative for clockwise turns
  double disc_radius = 0.01;  ///< spiral: radius of its disc
  std::uint64_t seed = 42;    ///< spread: seed of the candidates
  double unit = 1e-3;         ///< table: unit of its lengths [m]
  bool onto_skin = true;      ///< table: at the nearest points of the skin
  double width = 0.02;        ///< image: width of the image
  int threshold = 128, least_pixels = 4;
  bool light_dots = false;
  std::string preset = "icub";
  bool operator==(const Pattern&) const = default;
};

/// The values besides the parameters from which a pattern is made.
struct PatternSource {
  PlacingFrame frame;
  SensorFrame sensor;                      ///< directions for rings and presets
  bool painted = false;                    ///< spread: true if only over `faces`
  std::vector<int> faces;                  ///< painted faces of the skin
  std::string table, table_file;           ///< text, and name for messages
  std::shared_ptr<const GreyImage> image;  ///< image, or null
};

struct PatternTaxels {
  std::vector<Taxel> taxels;
  int left_out = 0;           ///< number of points that were not over the skin
  double least_distance = 0;  ///< spread: least distance along the skin [m]; otherwise 0
};

/// Makes the taxels of a pattern. Throws Error("", parameter as the window names it, ...) for a value out of range, in
/// millimetres and degrees; the errors of the generators, of the table's reader and of presets; and Cancelled through
/// `progress`.
PatternTaxels make_pattern(const Pattern& pattern, const PatternSource& source, const MeshIndex& skin,
                           Progress* progress = nullptr);

/// Returns the default direction of rows in the plane at right angles to `normal`: the projection of the sensor's width
/// (distal x pad), or of distal if the width is parallel to the normal.
dvec3 row_direction(const SensorFrame& sensor, const dvec3& normal);

}  // namespace taxel
