// The parameters that a study can vary, as the window displays them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/document/scenario/scenario.h"

namespace taxel::ui {

inline constexpr const char *kDensityKey = "density", *kSeedKey = "seed";  // keys of the layout's samples

/// Returns a value with its parameter and unit: "Depth 0.5 mm".
std::string value_text(const FieldSpec& parameter, double si);

/// Returns the numbers that the scenario uses, in the order of the inspector, then density and seed of the samples.
std::vector<FieldSpec> varied_in(const Scenario& scenario);

}  // namespace taxel::ui
