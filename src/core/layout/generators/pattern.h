// Patterns of taxels as a user chooses them: the kind, its parameters, and the place on the skin.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/layout/generators/image_dots.h"
#include "core/layout/generators/pattern_kinds.h"
#include "core/layout/layout.h"
#include "core/mesh/query/closest_point.h"

namespace taxel {

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

/// Calls v(FieldSpec, value&) for each field that the pattern uses, in the order of the panel. Values are counts,
/// numbers, switches, PatternAxis, TableUnit and the name of a preset.
template <class P, class V>
requires std::is_same_v<std::remove_const_t<P>, Pattern>
void visit_fields(P& pattern, const V& v) {
  const auto visit = [&](auto& kind) {
    using Kind = std::remove_cvref_t<decltype(kind)>;
    Kind::visit(kind, v);
    if constexpr (Kind::kTurnHelp != nullptr)
      v(FieldSpec{"turn_deg", "Turn", Kind::kTurnHelp, FieldQuantity::angle}, pattern.turn_deg);
    Kind::visit_more(kind, v);
    if constexpr (Kind::kHasRadius)
      v(FieldSpec{"radius", "Radius", "Of the receptive fields [mm]; a table's own radii go before",
                  FieldQuantity::length, FieldRange::positive},
        pattern.radius);
    if constexpr (Kind::kCanMiss)
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

/// Makes the taxels of a pattern. Throws PatternFieldError for a value out of range; the errors of the generators, of
/// the table's reader and of presets; and Cancelled through `progress`.
PatternTaxels make_pattern(const Pattern& pattern, const PatternSource& source, const MeshIndex& skin,
                           Progress* progress = nullptr);

/// Returns the default direction of rows in the plane at right angles to `normal`: the projection of the sensor's width
/// (distal x pad), or of distal if the width is parallel to the normal.
dvec3 row_direction(const SensorFrame& sensor, const dvec3& normal);

}  // namespace taxel
