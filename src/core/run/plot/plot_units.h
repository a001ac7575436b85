// Units of the axes of charts, with the prefix that suits the values.
#pragma once

#include <string>

namespace taxel {

/// Sizes of numbers that charts show: their sums and quotients are finite.
inline constexpr double kMinPlotted = 1e-100, kMaxPlotted = 1e100;

/// A unit and the factor from SI to it.
struct PlotUnit {
  std::string text;
  double scale = 1;
};

/// Returns the unit for values up to `largest`: Pa, kPa or MPa; mN, N or kN. Other units have no prefixes.
[[nodiscard]] inline PlotUnit plot_unit(const std::string& unit, double largest) {
  if (unit == "N" && largest > 0 && largest < 0.1) return {"mN", 1e3};
  if (unit != "Pa" && unit != "N") return {unit, 1};
  if (largest >= 1e6) return {"M" + unit, 1e-6};
  if (largest >= 1e3) return {"k" + unit, 1e-3};
  return {unit, 1};
}

/// Returns the name of an axis with its unit: "reading (kPa)".
[[nodiscard]] inline std::string named_with_unit(const std::string& name, const std::string& unit) {
  return unit.empty() ? name : name + " (" + unit + ")";
}

}  // namespace taxel
