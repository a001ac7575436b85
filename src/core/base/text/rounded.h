// Numbers for people: rounded at the scale of their quantity, without exponents.
#pragma once

#include <string>

namespace taxel {

/// Returns a number with at most `digits` significant digits and at most `decimals` decimals, which are those that its
/// quantity has a use for. Zeros at the end are left out, and there is never an exponent. A number that rounds to zero
/// is "0", without a sign.
[[nodiscard]] std::string rounded(double number, int digits, int decimals);

/// Returns a change as rounded() does, with its sign: "+0.12", "-3", and "0" for one that rounds to zero.
[[nodiscard]] std::string rounded_change(double change, int digits, int decimals);

}  // namespace taxel
