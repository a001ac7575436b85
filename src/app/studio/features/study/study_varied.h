// What a parameter study can vary, as the window shows it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/studio/features/scenario/scenario_fields.h"

namespace taxel::ui {

inline constexpr std::string_view kDensityKey = "density", kSeedKey = "seed";  // of the layout's samples

struct Varied {
  std::string_view key;   ///< in files
  std::string_view name;  ///< with its unit in brackets
  FieldUnit unit;
  double Scenario::*value = nullptr;  ///< null: not the scenario's

  [[nodiscard]] std::string_view unit_text() const;  ///< "mm"; empty: none
  [[nodiscard]] std::string with(double si) const;   ///< "Depth 0.5 mm"
};

/// Numbers that the scenario uses, in the order of the inspector, then those of the samples.
std::vector<Varied> varied_in(const Scenario& scenario);

}  // namespace taxel::ui
