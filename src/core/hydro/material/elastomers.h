// Known elastomers, with the sources of their numbers, and Young's modulus from a hardness on one of Shore's scales.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace taxel {

/// A Young's modulus with the range that the hardness allows.
struct YoungsEstimate {
  double youngs = 0;         ///< [Pa]
  double low = 0, high = 0;  ///< range of all formulas, for a hardness within its tolerance [Pa]
  std::string source;        ///< formula and paper
};
/// Usual tolerance of a stated hardness, on each scale.
inline constexpr double kHardnessTolerance = 5.0;

/// From Shore A (Gent 1958; range with the fit of Qi, Joyce and Boyce 2003, made for 20 to 80). Throws
/// Error("", "shore_a", message) outside of 5 to 95.
YoungsEstimate youngs_from_shore_a(double hardness);

/// From Shore 00: Hertz's force of the ball of ASTM D2240, of an incompressible solid, equals the force of its spring
/// (the method of Mix and Giacomin 2011). Throws Error("", "shore_00", message) outside of 5 to 95.
YoungsEstimate youngs_from_shore_00(double hardness);

struct Elastomer {
  std::string word;   ///< name on command lines
  std::string title;  ///< name of the product
  double youngs = 0;  ///< Young's modulus at small strain [Pa]
  double poisson = 0;
  double density = 0;                ///< [kg/m^3]
  std::optional<double> stress_100;  ///< stress at 100 % strain, of the data sheet [Pa]
  std::optional<double> shore_a;     ///< hardness of the data sheet
  std::optional<double> shore_00;    ///< hardness of the data sheet
  std::string source;                ///< origin of the numbers
  std::string unverified;            ///< numbers that are estimates; never empty
};

/// Young's modulus at small strain from the stress at 100 % strain, by the neo-Hookean solid: stress (per area before
/// the stretch) = E/3 (s - 1/s^2) at the stretch s = 2 (Treloar 1975).
inline double youngs_from_stress_100(double stress) {
  return stress * 12.0 / 7.0;
}

/// Poisson's ratio of a rubber with bulk modulus K: 1/2 - E/(6 K), with K = 1 GPa, at most 0.4999.
double rubber_poisson(double youngs);

/// Returns all known elastomers, in the order of lists.
const std::vector<Elastomer>& elastomers();

/// Returns an elastomer by its word. Throws Error("", "preset", message) naming all words if there is none.
const Elastomer& find_elastomer(std::string_view word);

}  // namespace taxel
