// Arithmetic with units, as people type it into number fields: "2*3.5 mm", "(30.5 - 18)/2", "45 deg", "2 N / 4 mm^2".
#pragma once

#include <string_view>

namespace taxel {

/// The value of the text, in `unit`: evaluate("2 cm", "mm") is 20. A result without a unit is in `unit` already.
///
/// Operators + - * / ^ and parentheses, ^ strongest and from the right, a sign weaker than ^; the number pi; sqrt, abs,
/// sin, cos, tan (of an angle) and asin, acos, atan. Units: nm um mm cm m in, deg rad, mg g kg, us ms s min, Hz kHz, mN
/// N kN, Pa hPa kPa MPa GPa bar; µ, ° and ², ³ are understood. A unit belongs to the number or parenthesis before it,
/// with its power: "4 mm^2" are square millimetres. What is added must be of one kind. Decimal units cost no digits:
/// "6.1 mm" in "mm" is 6.1.
///
/// `unit` is written the same way ("mm", "1/m^2", "Pa s"; "" for plain numbers). Throws Error("", "character N", ...),
/// counted from 1 in characters of the text: what is wrong there, and what was expected; also for division by zero, and
/// where the result is of another kind than `unit`.
double evaluate(std::string_view text, std::string_view unit = "");

}  // namespace taxel
