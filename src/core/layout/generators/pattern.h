// Patterns of taxels as a user chooses them: the kinds with their parameters, and the place on the skin.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/base/text/field_spec.h"
#include "core/base/text/words.h"
#include "core/layout/generators/image_dots.h"
#include "core/layout/layout.h"
#include "core/mesh/query/closest_point.h"

namespace taxel {

/// Axis of a ring or helix: a direction of the sensor's frame, or an axis of the mesh file.
enum class PatternAxis { distal, x, y, z };
inline constexpr Word<PatternAxis> kPatternAxisWords[] = {
    {PatternAxis::distal, "distal"}, {PatternAxis::x, "X"}, {PatternAxis::y, "Y"}, {PatternAxis::z, "Z"}};
inline std::span<const Word<PatternAxis>> words_of(PatternAxis) {
  return kPatternAxisWords;
}

/// Unit of the lengths in a table.
enum class TableUnit { m, cm, mm, in };
inline constexpr Word<TableUnit> kTableUnitWords[] = {
    {TableUnit::m, "m"}, {TableUnit::cm, "cm"}, {TableUnit::mm, "mm"}, {TableUnit::in, "in"}};
inline std::span<const Word<TableUnit>> words_of(TableUnit) {
  return kTableUnitWords;
}

namespace patterns {

/// Properties of a kind of pattern. Every kind derives from these defaults and redefines the ones that differ. A kind
/// also has `kWord`, `kHelp`, and `visit(self, v)`, which calls v(FieldSpec, value&) for each field; visit_more() does
/// the same for the fields after `turn_deg`. Counts with FieldRange::positive are 1 to kMaxGeneratedTaxels.
struct KindTraits {
  static constexpr bool kHasFrame = true;    ///< true if PlacingFrame places the pattern
  static constexpr bool kHasRadius = true;   ///< false if the taxels always have their own radii
  static constexpr bool kCanMiss = false;    ///< true if points of the pattern can be off the skin
  static constexpr bool kHasRegion = false;  ///< true if the painted region limits the pattern
  static constexpr const char* kTurnHelp =
      nullptr;                         ///< tooltip of `turn_deg`; null if the user cannot turn the pattern
  static constexpr int kMinCount = 1;  ///< least number of taxels

  template <class Self, class V>
  static void visit_more(Self& /*self*/, const V& /*v*/) {}
  bool operator==(const KindTraits&) const = default;
};

inline constexpr const char* kTurnsAboutNormal = "About the skin's normal, counter-clockwise [degrees]";
inline constexpr const char* kTurnsAboutAxis = "About the axis, from the frame to the first taxel [degrees]";
inline constexpr const char* kMaxSlope = "max_slope_deg";
inline constexpr FieldSpec kTurns{"turns", "Turns", "Times around; negative: clockwise", FieldQuantity::number};

inline constexpr FieldSpec count_field(const char* help) {
  return {"count", "Taxels", help, FieldQuantity::number, FieldRange::positive};
}

struct Grid : KindTraits {
  static constexpr std::string_view kWord = "grid";
  static constexpr const char* kHelp = "Rows and columns, on a plane or projected onto the skin";
  static constexpr bool kCanMiss = true;
  static constexpr const char* kTurnHelp = kTurnsAboutNormal;
  int rows = 3, columns = 4;
  double row_pitch = 0.005, column_pitch = 0.005;  ///< [m]
  bool projected = true;                           ///< on the skin, not in the tangent plane

  template <class Self, class V>
  static void visit(Self& self, const V& v) {
    v(FieldSpec{"rows", "Rows", "Rows follow one another across the direction of rows", FieldQuantity::number,
                FieldRange::positive},
      self.rows);
    v(FieldSpec{"columns", "Columns", "Taxels in a row", FieldQuantity::number, FieldRange::positive}, self.columns);
    v(FieldSpec{"row_pitch", "Row pitch", "From row to row [mm]", FieldQuantity::length, FieldRange::positive},
      self.row_pitch);
    v(FieldSpec{"column_pitch", "Column pitch", "From column to column [mm]", FieldQuantity::length,
                FieldRange::positive},
      self.column_pitch);
  }
  template <class Self, class V>
  static void visit_more(Self& self, const V& v) {
    v(FieldSpec{"projected", "Onto the skin",
                "Straight down onto the skin, with its normals; else a plane that touches it at the frame",
                FieldQuantity::number},
      self.projected);
  }
  bool operator==(const Grid&) const = default;
};

/// A triangular lattice over all of the skin that faces the frame's normal, or over its painted faces.
struct Hexagonal : KindTraits {
  static constexpr std::string_view kWord = "hexagonal";
  static constexpr const char* kHelp = "A lattice of equal triangles over the side of the skin that faces the frame";
  static constexpr bool kHasRegion = true;
  static constexpr const char* kTurnHelp = kTurnsAboutNormal;
  double pitch = 0.004;       ///< distance between neighbours in the tangent plane [m]
  double max_slope_deg = 60;  ///< largest angle between the skin's normal and the frame's

  template <class Self, class V>
  static void visit(Self& self, const V& v) {
    v(FieldSpec{"pitch", "Pitch", "From taxel to taxel, seen along the frame's normal [mm]", FieldQuantity::length,
                FieldRange::positive},
      self.pitch);
    v(FieldSpec{kMaxSlope, "Largest slope", "Skin that is turned farther away gets no taxel [degrees, up to 90]",
                FieldQuantity::angle, FieldRange::positive},
      self.max_slope_deg);
  }
  bool operator==(const Hexagonal&) const = default;
};

/// A kind that places a number of taxels around an axis.
struct Around : KindTraits {
  static constexpr const char* kTurnHelp = kTurnsAboutAxis;
  int count = 24;
  PatternAxis axis = PatternAxis::distal;

  template <class Self, class V>
  static void visit(Self& self, const V& v) {
    v(count_field("Their number"), self.count);
    v(FieldSpec{"axis", "Axis", "The ring goes round it: where the finger points, or an axis of the mesh file",
                FieldQuantity::number},
      self.axis);
  }
  bool operator==(const Around&) const = default;
};

struct Ring : Around {
  static constexpr std::string_view kWord = "ring";
  static constexpr const char* kHelp = "At equal angles around an axis, at the height of the frame";
  bool operator==(const Ring&) const = default;
};

struct Helix : Around {
  static constexpr std::string_view kWord = "helix";
  static constexpr const char* kHelp = "Around an axis and along it";
  static constexpr int kMinCount = 2;
  double rise = 0.01;  ///< height from the first to the last taxel [m]
  double turns = 2;    ///< number of turns, not 0; negative for clockwise turns

  template <class Self, class V>
  static void visit(Self& self, const V& v) {
    Around::visit(self, v);
    v(FieldSpec{"rise", "Rise", "Along the axis, from the first taxel to the last [mm]", FieldQuantity::length},
      self.rise);
    v(kTurns, self.turns);
  }
  bool operator==(const Helix&) const = default;
};

/// The spiral of a sunflower's seeds.
struct Spiral : KindTraits {
  static constexpr std::string_view kWord = "spiral";
  static constexpr const char* kHelp = "The spiral of a sunflower's head: equal area each";
  static constexpr bool kCanMiss = true;
  int count = 24;
  double disc_radius = 0.01;  ///< radius of the disc [m]

  template <class Self, class V>
  static void visit(Self& self, const V& v) {
    v(count_field("Their number; equal area each (Vogel 1979)"), self.count);
    v(FieldSpec{"disc_radius", "Disc radius", "Of the disc that is projected onto the skin [mm]", FieldQuantity::length,
                FieldRange::positive},
      self.disc_radius);
  }
  bool operator==(const Spiral&) const = default;
};

/// An even spread by geodesic distance.
struct Spread : KindTraits {
  static constexpr std::string_view kWord = "spread";
  static constexpr const char* kHelp = "N taxels as far apart along the skin as can be, over the painted region";
  static constexpr bool kHasFrame = false, kHasRegion = true;
  int count = 24;
  std::uint64_t seed = 42;  ///< seed of the candidates

  template <class Self, class V>
  static void visit(Self& self, const V& v) {
    v(count_field("Each as far from the others along the skin as it can be (Gonzalez 1985)"), self.count);
    v(FieldSpec{"seed", "Seed", "Another one, another spread", FieldQuantity::number}, self.seed);
  }
  bool operator==(const Spread&) const = default;
};

/// Taxels of a CSV file.
struct Table : KindTraits {
  static constexpr std::string_view kWord = "table";
  static constexpr const char* kHelp = "Points of a CSV file";
  static constexpr bool kHasFrame = false;
  TableUnit unit = TableUnit::mm;
  bool onto_skin = true;  ///< at the nearest points of the skin

  template <class Self, class V>
  static void visit(Self& self, const V& v) {
    v(FieldSpec{"unit", "Unit", "Of the lengths in the table", FieldQuantity::number}, self.unit);
    v(FieldSpec{"onto_skin", "Onto the skin",
                "To the nearest points of the skin, with its normals; else as the table says", FieldQuantity::number},
      self.onto_skin);
  }
  bool operator==(const Table&) const = default;
};

/// The dots of an image.
struct Image : KindTraits {
  static constexpr std::string_view kWord = "image";
  static constexpr const char* kHelp = "The dots of a picture that lies over the skin";
  static constexpr bool kCanMiss = true;
  static constexpr const char* kTurnHelp = kTurnsAboutNormal;
  double width = 0.02;  ///< width of the image [m]
  int threshold = 128, least_pixels = 4;
  bool light_dots = false;

  template <class Self, class V>
  static void visit(Self& self, const V& v) {
    v(FieldSpec{"width", "Picture width", "Of the whole picture where it lies over the skin [mm]",
                FieldQuantity::length, FieldRange::positive},
      self.width);
  }
  template <class Self, class V>
  static void visit_more(Self& self, const V& v) {
    v(FieldSpec{"threshold", "Threshold", "A pixel is of a dot where it is darker than this, 1 to 255",
                FieldQuantity::number},
      self.threshold);
    v(FieldSpec{"least_pixels", "Least pixels", "Smaller dots are dust", FieldQuantity::number}, self.least_pixels);
    v(FieldSpec{"light_dots", "Light dots", "Dots are lighter than their ground", FieldQuantity::number},
      self.light_dots);
  }
  bool operator==(const Image&) const = default;
};

/// Taxels of a known sensor.
struct Preset : KindTraits {
  static constexpr std::string_view kWord = "preset";
  static constexpr const char* kHelp = "Taxels of a known sensor";
  static constexpr bool kCanMiss = true, kHasRadius = false;
  std::string name = "icub";

  template <class Self, class V>
  static void visit(Self& self, const V& v) {
    v(FieldSpec{"preset", "Preset", "Name of a known sensor, as taxel presets lists it", FieldQuantity::number},
      self.name);
  }
  bool operator==(const Preset&) const = default;
};

}  // namespace patterns

/// To add a kind of pattern, add its struct above, its alternative here, and its overload of PatternBuild::make() in
/// pattern.cpp.
using PatternShape =
    std::variant<patterns::Grid, patterns::Hexagonal, patterns::Ring, patterns::Helix, patterns::Spiral,
                 patterns::Spread, patterns::Table, patterns::Image, patterns::Preset>;

/// Copies the values that both kinds have under the same key.
void copy_shared_values(const PatternShape& from, PatternShape& to);

/// Place of a pattern: a point of the skin, the skin's normal there, and the direction of rows in the tangent plane.
struct PlacingFrame {
  dvec3 center{0};
  dvec3 normal{0, 0, 1};
  dvec3 along_row{1, 0, 0};
  bool operator==(const PlacingFrame&) const = default;
};

/// A pattern as the user sets it: its kind with its own values, and the values that several kinds use.
struct Pattern {
  double radius = 0.004;    ///< radius of receptive fields [m]; a table or preset can have its own
  double turn_deg = 0;      ///< counter-clockwise turn about the normal; ring, helix: the axis
  bool leave_out = true;    ///< true if points off the skin get no taxel, false if they are an error
  PatternShape shape = {};  ///< the kind and its values

  template <class Kind>
  [[nodiscard]] bool is() const {
    return std::holds_alternative<Kind>(shape);
  }
  bool operator==(const Pattern&) const = default;
};

/// Returns true if the painted region limits the pattern.
[[nodiscard]] inline bool has_region(const Pattern& pattern) {
  return std::visit([](const auto& kind) { return std::remove_cvref_t<decltype(kind)>::kHasRegion; }, pattern.shape);
}

/// Calls v(FieldSpec, value&) for each field that the pattern uses, in the order of the panel. Values are counts,
/// numbers, switches, PatternAxis, TableUnit and the name of a preset.
template <class P, class V>
requires std::is_same_v<std::remove_const_t<P>, Pattern>
void visit_fields(P& pattern, const V& v) {
  const auto visit = [&](auto& kind) {
    using Own = std::remove_cvref_t<decltype(kind)>;
    Own::visit(kind, v);
    if constexpr (Own::kTurnHelp != nullptr)
      v(FieldSpec{"turn_deg", "Turn", Own::kTurnHelp, FieldQuantity::angle}, pattern.turn_deg);
    Own::visit_more(kind, v);
    if constexpr (Own::kHasRadius)
      v(FieldSpec{"radius", "Radius", "Of the receptive fields [mm]; a table's own radii go before",
                  FieldQuantity::length, FieldRange::positive},
        pattern.radius);
    if constexpr (Own::kCanMiss)
      v(FieldSpec{"leave_out", "Skip what misses",
                  "Points that are not over the skin are left out; else they are an error", FieldQuantity::number},
        pattern.leave_out);
  };
  std::visit(visit, pattern.shape);
}

/// A value of a field breaks a rule. what() names the key and the value in SI units; a window can name the label and
/// the displayed unit instead.
struct PatternFieldError : Error {
  PatternFieldError(const FieldSpec& spec, const std::string& broken_rule, std::optional<double> wrong_value = {});
  FieldSpec field;
  std::string rule;             ///< such as "must be greater than 0"
  std::optional<double> value;  ///< the value in SI units; empty if the rule says enough
};

/// The values besides the parameters from which a pattern is made.
struct PatternSource {
  PlacingFrame frame;
  SensorFrame sensor;                      ///< directions for rings and presets
  bool painted = false;                    ///< true if a kind with kHasRegion covers only `faces`
  std::vector<int> faces;                  ///< painted faces of the skin
  std::string table, table_file;           ///< text, and name for messages
  std::shared_ptr<const GreyImage> image;  ///< image, or null
};

struct PatternTaxels {
  std::vector<Taxel> taxels;
  int left_out = 0;           ///< number of points that were not over the skin
  double least_distance = 0;  ///< spread: least distance along the skin [m]; otherwise 0
};

/// Makes the taxels of a pattern. Throws PatternFieldError for a value out of range; the errors of the generators, of
/// the table's reader and of presets; and Cancelled through `progress`.
PatternTaxels make_pattern(const Pattern& pattern, const PatternSource& source, const MeshIndex& skin,
                           Progress* progress = nullptr);

/// Returns the default direction of rows in the plane at right angles to `normal`: the projection of the sensor's width
/// (distal x pad), or of distal if the width is parallel to the normal.
dvec3 row_direction(const SensorFrame& sensor, const dvec3& normal);

}  // namespace taxel
