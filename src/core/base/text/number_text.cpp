#include "core/base/text/number_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace taxel {
namespace {

/// Returns the decimal place of the first significant digit: 0 for 1 to 9, -2 for 0.01 to 0.09.
int magnitude_of(double number) {
  return static_cast<int>(std::floor(std::log10(std::abs(number))));
}

}  // namespace

NumberPair number_pair(double first, double second, int digits) {
  constexpr int kDigitsOfChange = 2;
  constexpr int kMaxDigits = 15;  // digits of a double; further digits are noise
  constexpr int kTiny = -6;       // smaller magnitudes are written with an exponent
  const double largest = std::max(std::abs(first), std::abs(second)), change = std::abs(first - second);
  if (!std::isfinite(largest) || !std::isfinite(change)) return {fmt::format("{}", first), fmt::format("{}", second)};
  if (largest == 0) return {"0", "0"};
  const int magnitude = magnitude_of(largest);
  int significant = digits;
  if (change > 0) significant = std::max(significant, magnitude - magnitude_of(change) + kDigitsOfChange);
  significant = std::min(significant, kMaxDigits);
  if (magnitude < kTiny)
    return {fmt::format("{:.{}e}", first, significant - 1), fmt::format("{:.{}e}", second, significant - 1)};
  const int decimals = std::max(0, significant - 1 - magnitude);
  return {fmt::format("{:.{}f}", first, decimals), fmt::format("{:.{}f}", second, decimals)};
}

std::string in_mm(double length) {
  return fmt::format("{:.3g} mm", 1e3 * length);
}

std::string in_mm2(double area) {
  return fmt::format("{:.3g} mm\u00b2", 1e6 * area);
}

std::string place_in_mm(const dvec3& place) {
  // Adding 0 turns -0 into 0.
  return fmt::format("({:.5g}, {:.5g}, {:.5g}) mm", 1e3 * place.x + 0.0, 1e3 * place.y + 0.0, 1e3 * place.z + 0.0);
}

}  // namespace taxel
