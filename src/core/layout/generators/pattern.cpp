#include "core/layout/generators/pattern.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/layout/file/taxels_csv.h"
#include "core/layout/generators/arrays.h"
#include "core/layout/generators/geodesic_spread.h"
#include "core/layout/generators/place.h"
#include "core/layout/sensor_presets.h"

namespace taxel {
namespace {

/// Largest distance of a table's taxels from the skin, relative to the mesh's diagonal. Farther taxels are in another
/// unit, or belong to another mesh.
constexpr double kFarthestPart = 0.25;
/// Least cosine between the normals of a flat preset.
constexpr double kFlatCosine = 0.9998;

void check_field(const FieldSpec& field, double value, int /*min_count*/) {
  if (field.range == FieldRange::positive && (!(value > 0) || !std::isfinite(value)))
    throw PatternFieldError(field, "must be greater than 0", value);
  if (field.quantity == FieldQuantity::angle && !std::isfinite(value))
    throw PatternFieldError(field, "must be a number");
  if (field.key == std::string_view(patterns::kMaxSlope) && value > 90)
    throw PatternFieldError(field, "must be at most 90", value);
  if (field.key == std::string_view(patterns::kTurns.key) && value == 0)
    throw PatternFieldError(field, "must not be 0");
}
void check_field(const FieldSpec& field, int value, int min_count) {
  if (field.range == FieldRange::positive && (value < min_count || value > kMaxGeneratedTaxels))
    throw PatternFieldError(field, fmt::format("must be {} to {}", min_count, kMaxGeneratedTaxels), value);
}
template <class Choice>
void check_field(const FieldSpec& /*field*/, const Choice& /*value*/, int /*min_count*/) {}

void check_values(const Pattern& pattern) {
  const int min_count = std::visit([](const auto& kind) { return kind.kMinCount; }, pattern.shape);
  visit_fields(pattern, [&](const FieldSpec& field, const auto& value) { check_field(field, value, min_count); });
}

double metres(TableUnit unit) {
  constexpr double kMetres[] = {1.0, 0.01, 1e-3, 0.0254};
  return kMetres[static_cast<int>(unit)];
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

/// The taxels of each kind, from the values that all kinds need.
struct PatternBuild {
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
  void require_painted_faces() const {
    if (source.painted && source.faces.empty())
      throw PatternFieldError({"faces", "Region", "", FieldQuantity::list},
                              "none of the painted faces is on the skin: paint it again");
  }
  static PatternTaxels counted(std::vector<Taxel> taxels, std::size_t wanted) {
    const int left_out = static_cast<int>(wanted - taxels.size());
    return {std::move(taxels), left_out, 0};
  }

  [[nodiscard]] PatternTaxels make(const patterns::Grid& kind) const {
    Grid grid;
    grid.rows = kind.rows;
    grid.columns = kind.columns;
    grid.row_pitch = kind.row_pitch;
    grid.column_pitch = kind.column_pitch;
    grid.radius = pattern.radius;
    grid.normal = source.frame.normal;
    grid.along_row = along_row();
    grid.center = kind.projected ? over_skin() : source.frame.center;
    const auto wanted = static_cast<std::size_t>(grid.rows) * static_cast<std::size_t>(grid.columns);
    if (!kind.projected) return counted(planar_grid(grid), wanted);
    return counted(curved_grid(grid, -grid.normal, skin, beyond()), wanted);
  }

  [[nodiscard]] PatternTaxels make(const patterns::Hexagonal& kind) const {
    HexagonalCover cover;
    cover.pitch = kind.pitch;
    cover.max_slope_deg = kind.max_slope_deg;
    cover.radius = pattern.radius;
    cover.center = source.frame.center;
    cover.along_row = along_row();
    cover.normal = source.frame.normal;
    require_painted_faces();
    if (source.painted) cover.faces = source.faces;
    std::sort(cover.faces.begin(), cover.faces.end());
    return {hexagonal_cover(cover, skin), 0, 0};
  }

  [[nodiscard]] PatternTaxels make(const patterns::Ring& kind) const {
    const auto [around, height] = around_axis(kind);
    return {ring(around, height, skin), 0, 0};
  }

  [[nodiscard]] PatternTaxels make(const patterns::Helix& kind) const {
    const auto [around, height] = around_axis(kind);
    const double half = 0.5 * kind.rise;
    return {helix(around, height - half, height + half, kind.turns, skin), 0, 0};
  }

  /// Returns the axis, and the height of the frame along it.
  [[nodiscard]] std::pair<AroundAxis, double> around_axis(const patterns::Around& kind) const {
    AroundAxis around;
    around.count = kind.count;
    around.radius = pattern.radius;
    around.axis = glm::normalize(direction(kind.axis));
    around.origin = skin.mesh().bounds().center();
    const dvec3 arm = source.frame.center - around.origin;
    const double height = glm::dot(arm, around.axis);
    dvec3 first = arm - height * around.axis;
    if (!(glm::length(first) > kFlatArm * skin.mesh().bounds().diagonal())) first = any_perpendicular(around.axis);
    around.first = turned(glm::normalize(first), around.axis, pattern.turn_deg);
    return {around, height};
  }

  [[nodiscard]] dvec3 direction(PatternAxis axis) const {
    switch (axis) {
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

  [[nodiscard]] PatternTaxels make(const patterns::Spiral& kind) const {
    Spiral spiral;
    spiral.count = kind.count;
    spiral.center = over_skin();
    spiral.direction = -source.frame.normal;
    spiral.disc_radius = kind.disc_radius;
    spiral.radius = pattern.radius;
    return counted(sunflower(spiral, skin, beyond()), static_cast<std::size_t>(kind.count));
  }

  [[nodiscard]] PatternTaxels make(const patterns::Spread& kind) const {
    require_painted_faces();
    Spread spread;
    spread.count = kind.count;
    spread.faces = source.faces;
    spread.seed = kind.seed;
    spread.radius = pattern.radius;
    SpreadTaxels made = geodesic_spread(spread, skin, progress);
    return {std::move(made.taxels), 0, made.least_distance};
  }

  [[nodiscard]] PatternTaxels make(const patterns::Table& kind) const {
    if (source.table_file.empty()) throw Error("choose a CSV file with columns x, y and z");
    CsvTaxels read = parse_taxels_csv(source.table, source.table_file, metres(kind.unit));
    if (read.taxels.size() > static_cast<std::size_t>(kMaxGeneratedTaxels))
      throw Error(source.table_file, fmt::format("holds {} taxels, at most {} can be made at once", read.taxels.size(),
                                                 kMaxGeneratedTaxels));
    if (!read.radii)
      for (Taxel& taxel : read.taxels) taxel.radius = pattern.radius;
    if (!kind.onto_skin && !read.normals)
      throw Error(source.table_file, "has no normals: bring its taxels onto the skin");
    if (!kind.onto_skin) return {std::move(read.taxels), 0, 0};
    const double farthest = kFarthestPart * skin.mesh().bounds().diagonal();
    return {taxel::onto_skin(std::move(read.taxels), skin, farthest), 0, 0};
  }

  [[nodiscard]] PatternTaxels make(const patterns::Image& kind) const {
    if (!source.image) throw Error("choose a PNG or JPEG picture with dots");
    ImageDots dots;
    dots.threshold = kind.threshold;
    dots.light = kind.light_dots;
    dots.least_pixels = kind.least_pixels;
    dots.width = kind.width;
    dots.center = over_skin();
    dots.along_row = along_row();
    dots.normal = source.frame.normal;
    dots.radius = pattern.radius;
    DotTaxels made = image_dots(*source.image, dots, skin, beyond());
    return counted(std::move(made.taxels), static_cast<std::size_t>(made.dots));
  }

  [[nodiscard]] PatternTaxels make(const patterns::Preset& kind) const {
    SensorPreset preset = make_sensor_preset(kind.name);
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

PatternFieldError::PatternFieldError(const FieldSpec& spec, const std::string& broken_rule,
                                     std::optional<double> wrong_value)
    : Error("", spec.key, wrong_value ? fmt::format("{}, is {}", broken_rule, *wrong_value) : broken_rule),
      field(spec),
      rule(broken_rule),
      value(wrong_value) {}

void copy_shared_values(const PatternShape& from, PatternShape& to) {
  const auto visit = [](auto& shape, const auto& v) {
    std::visit(
        [&](auto& kind) {
          kind.visit(kind, v);
          kind.visit_more(kind, v);
        },
        shape);
  };
  visit(from, [&](const FieldSpec& field, const auto& value) {
    visit(to, [&](const FieldSpec& other, auto& copy) {
      if constexpr (std::is_same_v<decltype(copy), std::remove_cvref_t<decltype(value)>&>)
        if (std::string_view(field.key) == other.key) copy = value;
    });
  });
}

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
  const PatternBuild build{pattern, source, skin, progress};
  return std::visit([&](const auto& kind) { return build.make(kind); }, pattern.shape);
}

}  // namespace taxel
