#include "core/base/text/quantity.h"

#include <fmt/format.h>

#include <cmath>

#include "core/base/math.h"

namespace taxel {
namespace {

struct Unit {
  std::string_view name;
  int decimal;
  Kind kind;
  double factor = 1;
};

constexpr Unit kUnits[] = {{"nm", -9, kLength},
                           {"um", -6, kLength},
                           {"\u00b5m", -6, kLength},
                           {"\u03bcm", -6, kLength},
                           {"mm", -3, kLength},
                           {"cm", -2, kLength},
                           {"m", 0, kLength},
                           {"in", -4, kLength, 254},
                           {"deg", 0, kAngle, kPi / 180},
                           {"\u00b0", 0, kAngle, kPi / 180},
                           {"rad", 0, kAngle},
                           {"mg", -6, kMass},
                           {"g", -3, kMass},
                           {"kg", 0, kMass},
                           {"us", -6, kTime},
                           {"\u00b5s", -6, kTime},
                           {"\u03bcs", -6, kTime},
                           {"ms", -3, kTime},
                           {"s", 0, kTime},
                           {"min", 0, kTime, 60},
                           {"Hz", 0, kFrequency},
                           {"kHz", 3, kFrequency},
                           {"mN", -3, kForce},
                           {"N", 0, kForce},
                           {"kN", 3, kForce},
                           {"Pa", 0, kPressure},
                           {"hPa", 2, kPressure},
                           {"kPa", 3, kPressure},
                           {"MPa", 6, kPressure},
                           {"GPa", 9, kPressure},
                           {"bar", 5, kPressure}};

struct KindName {
  Kind kind;
  const char* name;
};
constexpr KindName kKindNames[] = {{kPlain, "a number without a unit"},
                                   {kLength, "a length"},
                                   {kAngle, "an angle"},
                                   {kMass, "a mass"},
                                   {kTime, "a time"},
                                   {kFrequency, "a frequency"},
                                   {kForce, "a force"},
                                   {kPressure, "a pressure"},
                                   {{{2, 0, 0, 0}}, "an area"},
                                   {{{-2, 0, 0, 0}}, "a number per area"},
                                   {{{1, 0, -1, 0}}, "a speed"}};

double times_power_of_ten(double v, int decimal) {
  return decimal < 0 ? v / std::pow(10.0, -decimal) : v * std::pow(10.0, decimal);
}

}  // namespace

std::optional<Quantity> unit_named(std::string_view name) {
  for (const Unit& unit : kUnits)
    if (unit.name == name) return Quantity{1, unit.factor, unit.decimal, unit.kind};
  return std::nullopt;
}

std::string name_of(const Kind& kind) {
  for (const KindName& known : kKindNames)
    if (known.kind == kind) return known.name;
  const std::array<const char*, 4> symbols = {"m", "kg", "s", "rad"};
  std::string text = "in";
  for (std::size_t i = 0; i < symbols.size(); ++i)
    if (const int e = kind.exponents[i]; e != 0)
      text += e == 1 ? fmt::format(" {}", symbols[i]) : fmt::format(" {}^{}", symbols[i], e);
  return text;
}

double number_in(const Quantity& q, const Quantity& like) {
  const double number = q.factor == like.factor ? q.number : q.number * (q.factor / like.factor);
  return times_power_of_ten(number, q.decimal - like.decimal);
}

Quantity product(const Quantity& a, const Quantity& b, int sign) {
  Quantity out = a;
  out.number = sign > 0 ? a.number * b.number : a.number / b.number;
  out.factor = sign > 0 ? a.factor * b.factor : a.factor / b.factor;
  out.decimal += sign * b.decimal;
  for (std::size_t i = 0; i < out.kind.exponents.size(); ++i) out.kind.exponents[i] += sign * b.kind.exponents[i];
  return out;
}

}  // namespace taxel
