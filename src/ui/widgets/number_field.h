// Fields for what is typed, not dragged: numbers exact to the last digit, with arithmetic, and with one look for
// several values that differ. What cannot be taken over stays in the field, with the words why.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/text/field_spec.h"
#include "ui/widgets/ui.h"

namespace taxel::ui {

/// How a number is shown, and what is meant where no unit is typed.
struct FieldUnit {
  const char* name = "";  ///< as core/base/text/expression.h reads it
  int decimal = 0;        ///< it is 10^decimal SI units
  int digits = 2;         ///< behind the point; negative: as many as the number has
};

inline constexpr FieldUnit kMillimetres{"mm", -3, 2}, kPlain{"", 0, 2};
/// With all digits of the number, for values that are stored as typed.
inline constexpr FieldUnit kExactMillimetres{"mm", -3, -1}, kExactDegrees{"deg", 0, -1}, kExactNumber{"", 0, -1};

/// Returns the unit in which fields display a quantity.
constexpr FieldUnit field_unit(FieldQuantity quantity, int digits = -1) {
  const DisplayUnit unit = display_unit(quantity);
  return {unit.typed, unit.decimal, digits};
}

/// `values`: of all that are edited, in SI; "mixed" is shown where they differ. The new value, in SI, when Enter or
/// leaving the field takes over what was typed; none while it is typed, where nothing has changed, and where it is no
/// number: then it is refused.
std::optional<double> number_field(Ui& ui, const std::string& name, const std::vector<double>& values,
                                   const FieldUnit& unit, float width = -1);

/// The same for a text.
std::optional<std::string> text_field(Ui& ui, const std::string& name, const std::vector<std::string>& values,
                                      float width = -1);

/// A whole number from 0 to `most`; refused where it is another one.
std::optional<std::uint64_t> whole_field(Ui& ui, const std::string& name, std::uint64_t value, std::uint64_t most);

/// A number that need not be there: an empty field is none.
std::optional<std::optional<double>> optional_field(Ui& ui, const std::string& name, const std::optional<double>& value,
                                                    const FieldUnit& unit);

struct AxisValue {
  int axis = 0;
  double value = 0;
};
/// Three fields in a row, "NAME X" and so on, with what was refused below; tells the one that was changed.
std::optional<AxisValue> vector_field(Ui& ui, const std::string& name, const std::vector<dvec3>& values,
                                      const FieldUnit& unit);

/// The number as the field shows it.
std::string shown_number(double value, const FieldUnit& unit);

/// The field drawn last cannot take what was typed, for a reason that the core does not know.
void refuse(Ui& ui, const std::string& words);
/// Why the field of that name was refused, or one of a vector_field: below it. Nothing where it was not.
void show_refusal(Ui& ui, const std::string& name);

}  // namespace taxel::ui
