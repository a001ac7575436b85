// A field for a number that is typed, not dragged: exact to the last digit, with arithmetic, and with one look for
// several values that differ.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ui/ui_state.h"

namespace taxel::ui {

/// How a number is shown, and what is meant where no unit is typed.
struct FieldUnit {
  const char* name = "";  ///< as core/base/expression.h reads it
  int decimal = 0;        ///< it is 10^decimal SI units
  int digits = 2;         ///< behind the point
};

/// `values`: of all that are edited, in SI; "mixed" is shown where they differ. The new value, in SI, when Enter or
/// leaving the field takes over what was typed; none while it is typed, where nothing has changed, and where it is no
/// number: then ui.tool.problem says why.
std::optional<double> number_field(UiState& ui, const std::string& name, const std::vector<double>& values,
                                   const FieldUnit& unit, float width = -1);

/// The same for a text.
std::optional<std::string> text_field(UiState& ui, const std::string& name, const std::vector<std::string>& values,
                                      float width = -1);

}  // namespace taxel::ui
