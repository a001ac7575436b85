#include "core/base/page/axis_ticks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace taxel {
namespace {

constexpr int kMaxFiner = 12;  // largest number of steps that is tried to get two ticks

}  // namespace

AxisTicks axis_ticks(double low, double high, int most) {
  const double span = high - low, least = span / std::max(1, most);
  if (!(span > 0) || !std::isfinite(span) || !(least > 0)) return {{low}, 0};
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  double step = 10 * power;
  for (const double factor : {5.0, 2.0, 1.0})
    if (factor * power >= least * (1 - 1e-12)) step = factor * power;
  if (!(step > 0)) return {{low}, 0};
  AxisTicks ticks{{}, step};
  const double first = std::ceil(low / step - 1e-9), last = std::floor(high / step + 1e-9);
  if (last - first < 1 && most < kMaxFiner) return axis_ticks(low, high, most + 1);
  for (double i = first; i <= last && ticks.values.size() <= static_cast<std::size_t>(std::max(1, most)); ++i)
    ticks.values.push_back(i == 0 ? 0 : i * step);
  return ticks;
}

std::vector<std::string> tick_texts(const AxisTicks& ticks) {
  double largest = 0;
  for (const double value : ticks.values) largest = std::max(largest, std::abs(value));
  const bool has_power = largest >= 1e7 || (largest > 0 && largest < 1e-4);
  const double decimals = ticks.step > 0 ? std::max(0.0, -std::floor(std::log10(ticks.step) + 1e-9)) : 0;
  std::vector<std::string> texts;
  for (const double value : ticks.values)
    texts.push_back(has_power || !(ticks.step > 0) ? fmt::format("{:g}", value)
                                                   : fmt::format("{:.{}f}", value, static_cast<int>(decimals)));
  return texts;
}

}  // namespace taxel
