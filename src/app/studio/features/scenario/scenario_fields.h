// How the numbers of a scenario are named and shown: lengths in mm, angles in degrees. Files have them in SI.
#pragma once

#include <span>

#include "core/document/scenario/scenario.h"
#include "ui/widgets/number_field.h"

namespace taxel::ui {

struct ScenarioField {
  double Scenario::*value;
  const char* name;  ///< with its unit in brackets, as the field has it
  FieldUnit unit;
  const char* tip;
};

/// All of them, in the order of the inspector.
std::span<const ScenarioField> scenario_fields();

}  // namespace taxel::ui
