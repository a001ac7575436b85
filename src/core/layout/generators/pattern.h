// A pattern of taxels as a person asks for it: what, and where on the skin. The generators make it.
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
  spiral,  ///< a sunflower's head
  spread,  ///< evenly, by geodesic distance
  table,   ///< of a CSV file
  image,   ///< the dots of a picture
  preset   ///< of a known sensor
};

/// Where a pattern lies: a point of the skin, the skin's normal there, and the direction of rows in the tangent plane.
struct PlacingFrame {
  dvec3 center{0};
  dvec3 normal{0, 0, 1};
  dvec3 along_row{1, 0, 0};
  bool operator==(const PlacingFrame&) const = default;
};

/// About what a ring goes: a direction of the sensor's frame, or an axis of the mesh file.
enum class PatternAxis { distal, x, y, z };

/// Lengths in metres. Of each kind count the fields that its comment names, and `radius`.
struct Pattern {
  PatternKind kind = PatternKind::grid;
  double radius = 0.004;  ///< of the receptive fields; of a table and a preset only where they have none
  double turn_deg = 0;    ///< counter-clockwise about the normal; ring, helix: about the axis
  bool leave_out = true;  ///< points beside the skin; else they are refused. Grid, spiral, image, flat presets
  int count = 24;         ///< ring, helix, spiral, spread
  int rows = 3, columns = 4;
  double row_pitch = 0.005, column_pitch = 0.005;
  bool projected = true;  ///< grid: onto the skin; else in the tangent plane
  PatternAxis axis = PatternAxis::distal;
  double rise = 0.01;         ///< helix: from its first to its last taxel, along the axis
  double turns = 2;           ///< helix; negative: clockwise
  double disc_radius = 0.01;  ///< spiral
  std::uint64_t seed = 42;    ///< spread
  double unit = 1e-3;         ///< table: of its lengths [m]
  bool onto_skin = true;      ///< table: to the nearest points of the skin; else as it says
  double width = 0.02;        ///< image: of the whole picture
  int threshold = 128, least_pixels = 4;
  bool light_dots = false;
  std::string preset = "icub";
  bool operator==(const Pattern&) const = default;
};

/// What a pattern is made on and from.
struct PatternSource {
  PlacingFrame frame;
  SensorFrame sensor;                      ///< directions for rings and presets
  bool painted = false;                    ///< spread: only over `faces`
  std::vector<int> faces;                  ///< of the skin
  std::string table, table_file;           ///< text, and the name that messages have for it
  std::shared_ptr<const GreyImage> image;  ///< null: none yet
};

struct PatternTaxels {
  std::vector<Taxel> taxels;
  int left_out = 0;           ///< points that were not over the skin
  double least_distance = 0;  ///< spread: along the skin, between any two [m]; else 0
};

/// Throws Error("", parameter as the window names it, ...) for a value that makes no sense, in millimetres and degrees;
/// those of the generators, of the table's reader and of presets for the rest; Cancelled through `progress`.
PatternTaxels make_pattern(const Pattern& pattern, const PatternSource& source, const MeshIndex& skin,
                           Progress* progress = nullptr);

/// A direction in the plane at right angles to `normal`, along which rows run at first: the sensor's width, distal x
/// pad, laid into the plane; distal where they are parallel.
dvec3 row_direction(const SensorFrame& sensor, const dvec3& normal);

}  // namespace taxel
