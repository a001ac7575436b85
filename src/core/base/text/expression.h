// Numbers with units, and arithmetic with them as users type it into number fields: "2*3.5 mm", "(30.5 - 18)/2",
// "45 deg", "2 N / 4 mm^2".
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace taxel {

/// Exponents of metre, kilogram, second and radian.
struct Kind {
  std::array<int, 4> exponents{};
  bool operator==(const Kind&) const = default;
  [[nodiscard]] bool plain() const { return *this == Kind{}; }
};

/// A quantity: number * factor * 10^decimal, in SI. Prefixes stay in `decimal`, so that they cost no rounding.
struct Quantity {
  double number = 0;
  double factor = 1;
  int decimal = 0;
  Kind kind;
};

inline constexpr Kind kPlain{}, kLength{{1, 0, 0, 0}}, kAngle{{0, 0, 0, 1}}, kMass{{0, 1, 0, 0}}, kTime{{0, 0, 1, 0}},
    kFrequency{{0, 0, -1, 0}}, kForce{{1, 1, -2, 0}}, kPressure{{-1, 1, -2, 0}};

/// Returns the quantity 1 of a unit (expression.h lists the units), or nothing if the name is unknown.
std::optional<Quantity> unit_named(std::string_view name);

/// Returns the name of a kind for messages: "a length", "a number without a unit"; "in m^3 s" if the kind has no name.
std::string name_of(const Kind& kind);

/// Returns the number of q in the unit of `like`, which has the same kind.
double number_in(const Quantity& q, const Quantity& like);

/// Returns `number` units of `factor` each. A decimal factor below 1 divides, so that 37 mm (factor 0.001) are the
/// double next to 0.037.
double times_unit(double number, double factor);

/// Returns a * b, or a / b if `sign` is -1.
Quantity product(const Quantity& a, const Quantity& b, int sign = 1);

/// Returns the value of the text in `unit`: evaluate("2 cm", "mm") is 20. A result without a unit is taken to be in
/// `unit`.
///
/// Operators + - * / ^ and parentheses, ^ strongest and from the right, a sign weaker than ^; the number pi; sqrt, abs,
/// sin, cos, tan (of an angle) and asin, acos, atan. Units: nm um mm cm m in, deg rad, mg g kg, us ms s min, Hz kHz, mN
/// N kN, Pa hPa kPa MPa GPa bar; µ, ° and ², ³ are understood. A unit belongs to the number or parenthesis before it,
/// with its power: "4 mm^2" are square millimetres. Both sides of + and - must be of one kind. Decimal units cost no
/// digits: "6.1 mm" in "mm" is 6.1.
///
/// `unit` has the same syntax ("mm", "1/m^2", "Pa s"; "" for plain numbers). Throws Error("", "character N", ...), with
/// N counted from 1 in characters of the text. The message names the mistake and the expected text; it also reports a
/// division by zero, and a result of another kind than `unit`.
double evaluate(std::string_view text, std::string_view unit = "");

}  // namespace taxel
