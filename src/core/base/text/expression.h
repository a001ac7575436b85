// Arithmetic with units, as users type it into number fields: "2*3.5 mm", "(30.5 - 18)/2", "45 deg", "2 N / 4 mm^2".
#pragma once

#include <string_view>

namespace taxel {

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
