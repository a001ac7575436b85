// The description of a value that a user edits: its key in files, its label, and its unit. The alternatives of a
// std::variant, for menus of kinds.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace taxel {

/// The quantity of a field. It decides in which unit a window displays the value; files hold SI values and degrees.
enum class FieldQuantity {
  number,
  length,
  speed,
  inverse_speed,
  angle,
  angular_speed,
  mass,
  duration,
  interval,
  density,
  pressure,
  pressure_per_length,
  file,
  list
};

/// The values that a field accepts.
enum class FieldRange { positive, not_negative, any };

struct FieldSpec {
  const char* key;    ///< name in files
  const char* label;  ///< name in windows, without the unit
  const char* help;   ///< one sentence for a tooltip
  FieldQuantity quantity;
  FieldRange range = FieldRange::any;
};

/// The unit that windows use for a quantity: 10^decimal SI units, or degrees.
struct DisplayUnit {
  const char* symbol = "";  ///< text behind the label; empty without unit
  const char* typed = "";   ///< name that core/base/text/expression.h reads
  int decimal = 0;
};

constexpr DisplayUnit display_unit(FieldQuantity quantity) {
  switch (quantity) {
    case FieldQuantity::length:
      return {"mm", "mm", -3};
    case FieldQuantity::speed:
      return {"mm/s", "mm/s", -3};
    case FieldQuantity::angle:
      return {"\u00b0", "deg", 0};
    case FieldQuantity::angular_speed:
      return {"\u00b0/s", "deg", 0};
    case FieldQuantity::mass:
      return {"g", "g", -3};
    case FieldQuantity::duration:
      return {"s", "", 0};
    case FieldQuantity::interval:
      return {"ms", "ms", -3};
    case FieldQuantity::density:
      return {"1/mm\u00b2", "1/mm^2", 6};
    case FieldQuantity::inverse_speed:
      return {"s/m", "s/m", 0};
    case FieldQuantity::pressure:
      return {"kPa", "kPa", 3};
    case FieldQuantity::pressure_per_length:
      return {"kPa/mm", "kPa/mm", 6};
    default:
      return {};
  }
}

/// Returns the label with its unit in brackets: "Depth (mm)".
inline std::string label_with_unit(const FieldSpec& field) {
  const std::string symbol = display_unit(field.quantity).symbol;
  return symbol.empty() ? field.label : field.label + (" (" + symbol + ")");
}

/// Returns one value of each alternative with default values, in the order of the variant, whose types are the kinds of
/// a thing: shapes, scenarios, patterns.
template <class Variant>
std::vector<Variant> each_alternative() {
  return []<std::size_t... I>(std::index_sequence<I...>) {
    return std::vector<Variant>{Variant(std::in_place_index<I>)...};
  }
  (std::make_index_sequence<std::variant_size_v<Variant>>());
}

}  // namespace taxel
