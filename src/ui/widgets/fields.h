// Fields for exact numbers and texts, and for a choice of a few words. A number may be typed as an expression, and one
// field can edit several values. Input that is not valid stays in the field, with the reason below it.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/text/field_spec.h"
#include "core/layout/words.h"
#include "ui/widgets/ui.h"

namespace taxel::ui {

/// Unit in which a field displays a number, and in which a typed number without a unit is read.
struct FieldUnit {
  const char* name = "";  ///< name that core/base/text/expression.h accepts
  int decimal = 0;        ///< the unit is 10^decimal SI units
  int digits = 2;         ///< digits after the decimal point; all digits of the number if negative
};

inline constexpr FieldUnit kMillimetres{"mm", -3, 2}, kPlain{"", 0, 2};
/// Units that display all digits, for values that are stored as typed.
inline constexpr FieldUnit kExactMillimetres{"mm", -3, -1}, kExactNumber{"", 0, -1};

/// Returns the unit in which fields display a quantity.
constexpr FieldUnit field_unit(FieldQuantity quantity, int digits = -1) {
  const DisplayUnit unit = display_unit(quantity);
  return {unit.typed, unit.decimal, digits};
}

/// Draws a field for a number. `values` are the edited values in SI; the field displays "mixed" if they differ. Returns
/// the new value in SI when the user presses Enter or leaves the field. Returns nothing while the user types, if
/// nothing has changed, and if the text is not a number; such a text is refused.
std::optional<double> number_field(Ui& ui, const std::string& name, const std::vector<double>& values,
                                   const FieldUnit& unit, float width = -1);

/// Draws a field for a text. Returns the new text like number_field().
std::optional<std::string> text_field(Ui& ui, const std::string& name, const std::vector<std::string>& values,
                                      float width = -1);

/// Draws a field for a whole number from 0 to `most`. Other numbers are refused.
std::optional<std::uint64_t> whole_field(Ui& ui, const std::string& name, std::uint64_t value, std::uint64_t most);

/// Draws a field for an optional number. An empty field means that there is no number.
std::optional<std::optional<double>> optional_field(Ui& ui, const std::string& name, const std::optional<double>& value,
                                                    const FieldUnit& unit);

/// A new value of one coordinate.
struct AxisValue {
  int axis = 0;      ///< 0, 1 or 2 for x, y or z
  double value = 0;  ///< new value in SI
};
/// Draws three fields in a row, named "NAME X" and so on, with a refusal below them. Returns the changed coordinate.
std::optional<AxisValue> vector_field(Ui& ui, const std::string& name, const std::vector<dvec3>& values,
                                      const FieldUnit& unit);

/// Returns the text with which a field displays a number.
std::string shown_number(double value, const FieldUnit& unit);

/// Refuses the input of the last drawn field, for a reason that number_field() cannot check.
void refuse(Ui& ui, const std::string& words);
/// Draws the reason why a field, or one of the fields of a vector_field(), was refused. Draws nothing if it was not.
void show_refusal(Ui& ui, const std::string& name);

/// Draws a field for one of several choices. Returns the index of the choice that the user makes in this frame, or
/// nothing. `chosen` is the index of the present choice. `width` is that of ImGui::SetNextItemWidth().
std::optional<std::size_t> choice_of(Ui& ui, const std::string& name, std::span<const std::string_view> choices,
                                     std::size_t chosen, float width = -1);

/// Draws a field for the words that a layout file uses for the values of E. Returns the new value, or nothing.
template <class E>
std::optional<E> word_field(Ui& ui, const std::string& name, E value) {
  std::vector<std::string_view> choices;
  std::size_t chosen = 0;
  for (const auto& word : words_of(E{})) {
    if (word.value == value) chosen = choices.size();
    choices.push_back(word.text);
  }
  const std::optional<std::size_t> made = choice_of(ui, name, choices, chosen);
  return made ? std::optional<E>(words_of(E{})[*made].value) : std::nullopt;
}

/// Draws a field for yes or no. Returns the new state if the user toggles it in this frame, or nothing.
std::optional<bool> switch_field(Ui& ui, const std::string& name, bool on);

}  // namespace taxel::ui
