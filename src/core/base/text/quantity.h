// Numbers with units, as users write them.
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

/// Returns a * b, or a / b if `sign` is -1.
Quantity product(const Quantity& a, const Quantity& b, int sign = 1);

}  // namespace taxel
