#include "core/layout/generators/pattern.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/layout/file/taxels_csv.h"
#include "core/layout/generators/geodesic_spread.h"
#include "core/layout/generators/grid.h"
#include "core/layout/generators/onto_skin.h"
#include "core/layout/generators/ring.h"
#include "core/layout/generators/spiral.h"
#include "core/layout/sensor_presets.h"

namespace taxel {
namespace {

constexpr double kMillimetre = 1e-3;
/// Largest distance of a table's taxels from the skin, relative to the mesh's diagonal. Farther taxels are in another
/// unit, or belong to another mesh.
constexpr double kFarthestPart = 0.25;
/// Least cosine between the normals of a flat preset.
constexpr double kFlatCosine = 0.9998;

void check_length(const char* name, double value) {
  if (!(value > 0) || !std::isfinite(value))
    throw Error("", name, fmt::format("must be greater than 0, is {:g} mm", value / kMillimetre));
}

void check_count(const char* name, int value, int least = 1) {
  if (value < least || value > kMaxGeneratedTaxels)
    throw Error("", name, fmt::format("must be {} to {}, is {}", least, kMaxGeneratedTaxels, value));
}

void check_values(const Pattern& p) {
  check_length("Radius", p.radius);
  if (p.kind == PatternKind::grid) {
    check_count("Rows", p.rows);
    check_count("Columns", p.columns);
    check_length("Row pitch", p.row_pitch);
    check_length("Column pitch", p.column_pitch);
  }
  if (p.kind == PatternKind::helix) check_count("Taxels", p.count, 2);
  if (p.kind == PatternKind::helix && p.turns == 0) throw Error("", "Turns", "must not be 0");
  if (p.kind == PatternKind::ring || p.kind == PatternKind::spiral || p.kind == PatternKind::spread)
    check_count("Taxels", p.count);
  if (p.kind == PatternKind::spiral) check_length("Disc radius", p.disc_radius);
  if (p.kind == PatternKind::image) check_length("Picture width", p.width);
  if (!std::isfinite(p.turn_deg)) throw Error("", "Turn", "must be a number");
}

/// Turns a direction about a unit vector by the right-hand rule.
dvec3 turned(const dvec3& direction, const dvec3& axis, double degrees) {
  const double angle = degrees * kPi / 180, c = std::cos(angle), s = std::sin(angle);
  return c * direction + s * glm::cross(axis, direction) + (1 - c) * glm::dot(axis, direction) * axis;
}

/// Returns a height over the skin from which the skin is visible: half of the distance to the next surface above it, or
/// a height outside of the mesh.
double free_height(const PlacingFrame& frame, const MeshIndex& skin) {
  const double outside = 2 * skin.mesh().bounds().diagonal(), off_skin = 1e-6 * outside;
  const auto hit = skin.cast({frame.center + off_skin * frame.normal, frame.normal});
  return hit ? 0.5 * hit->t : outside;
}

/// The values that all kinds need.
struct Making {
  const Pattern& pattern;
  const PatternSource& source;
  const MeshIndex& skin;
  Progress* progress;

  [[nodiscard]] Beyond beyond() const { return pattern.leave_out ? Beyond::leave_out : Beyond::refuse; }
  [[nodiscard]] dvec3 along_row() const {
    return turned(source.frame.along_row, source.frame.normal, pattern.turn_deg);
  }
  [[nodiscard]] dvec3 over_skin() const {
    return source.frame.center + free_height(source.frame, skin) * source.frame.normal;
  }
  static PatternTaxels counted(std::vector<Taxel> taxels, std::size_t wanted) {
    const int left_out = static_cast<int>(wanted - taxels.size());
    return {std::move(taxels), left_out, 0};
  }

  [[nodiscard]] PatternTaxels grid() const {
    Grid grid;
    grid.rows = pattern.rows;
    grid.columns = pattern.columns;
    grid.row_pitch = pattern.row_pitch;
    grid.column_pitch = pattern.column_pitch;
    grid.radius = pattern.radius;
    grid.normal = source.frame.normal;
    grid.along_row = along_row();
    grid.center = pattern.projected ? over_skin() : source.frame.center;
    const auto wanted = static_cast<std::size_t>(grid.rows) * static_cast<std::size_t>(grid.columns);
    if (!pattern.projected) return counted(planar_grid(grid), wanted);
    return counted(curved_grid(grid, -grid.normal, skin, beyond()), wanted);
  }

  [[nodiscard]] PatternTaxels around() const {
    AroundAxis around;
    around.count = pattern.count;
    around.radius = pattern.radius;
    around.axis = glm::normalize(axis());
    around.origin = skin.mesh().bounds().center();
    const dvec3 arm = source.frame.center - around.origin;
    const double height = glm::dot(arm, around.axis);
    dvec3 first = arm - height * around.axis;
    if (!(glm::length(first) > kFlatArm * skin.mesh().bounds().diagonal())) first = any_perpendicular(around.axis);
    around.first = turned(glm::normalize(first), around.axis, pattern.turn_deg);
    if (pattern.kind == PatternKind::ring) return {ring(around, height, skin), 0, 0};
    const double half = 0.5 * pattern.rise;
    return {helix(around, height - half, height + half, pattern.turns, skin), 0, 0};
  }

  [[nodiscard]] dvec3 axis() const {
    switch (pattern.axis) {
      case PatternAxis::x:
        return {1, 0, 0};
      case PatternAxis::y:
        return {0, 1, 0};
      case PatternAxis::z:
        return {0, 0, 1};
      case PatternAxis::distal:
        break;
    }
    return source.sensor.distal;
  }

  [[nodiscard]] PatternTaxels spiral() const {
    Spiral spiral;
    spiral.count = pattern.count;
    spiral.center = over_skin();
    spiral.direction = -source.frame.normal;
    spiral.disc_radius = pattern.disc_radius;
    spiral.radius = pattern.radius;
    return counted(sunflower(spiral, skin, beyond()), static_cast<std::size_t>(pattern.count));
  }

  [[nodiscard]] PatternTaxels spread() const {
    if (source.painted && source.faces.empty())
      throw Error("", "Region", "none of the painted faces is on the skin: paint it again");
    Spread spread;
    spread.count = pattern.count;
    spread.faces = source.faces;
    spread.seed = pattern.seed;
    spread.radius = pattern.radius;
    SpreadTaxels made = geodesic_spread(spread, skin, progress);
    return {std::move(made.taxels), 0, made.least_distance};
  }

  [[nodiscard]] PatternTaxels table() const {
    if (source.table_file.empty()) throw Error("choose a CSV file with columns x, y and z");
    CsvTaxels read = parse_taxels_csv(source.table, source.table_file, pattern.unit);
    if (read.taxels.size() > static_cast<std::size_t>(kMaxGeneratedTaxels))
      throw Error(source.table_file, fmt::format("holds {} taxels, at most {} can be made at once", read.taxels.size(),
                                                 kMaxGeneratedTaxels));
    if (!read.radii)
      for (Taxel& taxel : read.taxels) taxel.radius = pattern.radius;
    if (!pattern.onto_skin && !read.normals)
      throw Error(source.table_file, "has no normals: bring its taxels onto the skin");
    if (!pattern.onto_skin) return {std::move(read.taxels), 0, 0};
    const double farthest = kFarthestPart * skin.mesh().bounds().diagonal();
    return {taxel::onto_skin(std::move(read.taxels), skin, farthest), 0, 0};
  }

  [[nodiscard]] PatternTaxels image() const {
    if (!source.image) throw Error("choose a PNG or JPEG picture with dots");
    ImageDots dots;
    dots.threshold = pattern.threshold;
    dots.light = pattern.light_dots;
    dots.least_pixels = pattern.least_pixels;
    dots.width = pattern.width;
    dots.center = over_skin();
    dots.along_row = along_row();
    dots.normal = source.frame.normal;
    dots.radius = pattern.radius;
    DotTaxels made = image_dots(*source.image, dots, skin, beyond());
    return counted(std::move(made.taxels), static_cast<std::size_t>(made.dots));
  }

  [[nodiscard]] PatternTaxels preset() const {
    SensorPreset preset = make_sensor_preset(pattern.preset);
    const std::vector<Taxel>& taxels = preset.layout.taxels;
    const bool flat = std::all_of(taxels.begin(), taxels.end(), [&](const Taxel& taxel) {
      return glm::dot(taxel.normal, taxels.front().normal) > kFlatCosine;
    });
    return flat ? laid_on(preset) : aligned(std::move(preset));
  }

  /// Projects a flat sensor onto the skin at the frame, with its width along the rows.
  [[nodiscard]] PatternTaxels laid_on(const SensorPreset& preset) const {
    const std::vector<Taxel>& from = preset.layout.taxels;
    const dvec3 n = from.front().normal, u = row_direction(preset.layout.frame, n), v = glm::cross(n, u);
    const dvec3 right = along_row(), up = glm::cross(source.frame.normal, right), start = over_skin();
    Aabb box;
    for (const Taxel& taxel : from) box.include(taxel.center);
    std::vector<Taxel> taxels;
    for (const Taxel& taxel : from) {
      const dvec3 d = taxel.center - box.center();
      const dvec3 over = start + glm::dot(d, u) * right + glm::dot(d, v) * up;
      const auto at =
          skin_under(skin, over, -source.frame.normal, beyond(), preset.name, fmt::format("taxel {}", taxel.id));
      if (!at) continue;
      taxels.push_back(taxel_on(skin.mesh(), *at, taxel.id, taxel.radius));
      taxels.back().name = taxel.name;
    }
    require_some(preset.name, taxels);
    return counted(std::move(taxels), from.size());
  }

  /// Aligns tips, directions and middles of the meshes of a curved sensor and of the skin, and then moves the taxels to
  /// the nearest points of the skin.
  [[nodiscard]] PatternTaxels aligned(SensorPreset preset) const {
    const dmat3 from = axes_of(preset.layout.frame), to = axes_of(source.sensor);
    const dvec3 from_tip = tip_of(*preset.mesh, from), to_tip = tip_of(skin.mesh(), to);
    for (Taxel& taxel : preset.layout.taxels)
      taxel.center = to * (glm::transpose(from) * taxel.center - from_tip + to_tip);
    return {taxel::onto_skin(std::move(preset.layout.taxels), skin), 0, 0};
  }

  /// Returns distal, pad and their cross product as columns.
  static dmat3 axes_of(const SensorFrame& frame) {
    const dvec3 distal = glm::normalize(frame.distal), side = glm::normalize(glm::cross(distal, frame.pad));
    return {distal, glm::cross(side, distal), side};
  }
  /// Returns the end of the mesh along distal, and its middle across, in these axes.
  static dvec3 tip_of(const TriMesh& mesh, const dmat3& axes) {
    Aabb box;
    for (const dvec3& p : mesh.vertices()) box.include(glm::transpose(axes) * p);
    return {box.hi.x, box.center().y, box.center().z};
  }

  static constexpr double kFlatArm = 1e-9;  // relative to the diagonal: the frame is on the axis
};

}  // namespace

dvec3 row_direction(const SensorFrame& sensor, const dvec3& normal) {
  const double least_sine = 0.1;
  const auto in_plane = [&](const dvec3& v) { return v - glm::dot(v, normal) * normal; };
  dvec3 along = in_plane(glm::normalize(glm::cross(sensor.distal, sensor.pad)));
  if (!(glm::length(along) > least_sine)) along = in_plane(glm::normalize(sensor.distal));
  return glm::length(along) > least_sine ? glm::normalize(along) : any_perpendicular(normal);
}

PatternTaxels make_pattern(const Pattern& pattern, const PatternSource& source, const MeshIndex& skin,
                           Progress* progress) {
  check_values(pattern);
  const Making making{pattern, source, skin, progress};
  switch (pattern.kind) {
    case PatternKind::grid:
      return making.grid();
    case PatternKind::ring:
    case PatternKind::helix:
      return making.around();
    case PatternKind::spiral:
      return making.spiral();
    case PatternKind::spread:
      return making.spread();
    case PatternKind::table:
      return making.table();
    case PatternKind::image:
      return making.image();
    case PatternKind::preset:
      return making.preset();
  }
  return {};
}

}  // namespace taxel
