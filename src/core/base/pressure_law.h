// The pressure law of a compliant body: the pressure as a function of the strain e = d/H of its layer, in units of the
// hydroelastic modulus E. All that depends on the relation of depth and pressure asks this value.
#pragma once

#include <string>
#include <vector>

namespace taxel {

/// Kinds of pressure laws.
enum class LawKind {
  linear,      ///< p = E e
  stiffening,  ///< p = E e/(1 - k e)
  table        ///< linear between points (strain, pressure)
};

/// A point of a law: a strain and the pressure there over E.
struct LawPoint {
  double strain = 0, pressure = 0;
  bool operator==(const LawPoint&) const = default;
};

/// A law. Beyond the strain 1, and beyond the last point of a table, the pressure continues with the slope there, so a
/// body that is pressed deeper than its layer pushes ever more.
struct PressureLaw {
  LawKind kind = LawKind::linear;
  double k = 0;                 ///< stiffening, 0 <= k < 1
  std::vector<LawPoint> table;  ///< points of LawKind::table, without (0, 0)

  /// Returns whether p = E e, so that nothing depends on the law.
  [[nodiscard]] bool is_linear() const;
  /// Returns p/E at a strain, 0 for strains that are not positive.
  [[nodiscard]] double pressure(double strain) const;
  /// Returns the strain at which pressure() is p/E, 0 for pressures that are not positive.
  [[nodiscard]] double strain(double pressure) const;
  /// Returns the derivative of pressure() by the strain. At a point of the table it is that of the side beyond.
  [[nodiscard]] double gradient(double strain) const;
  /// Returns the integral of pressure() from 0 to the strain: the work per area over E H.
  [[nodiscard]] double energy(double strain) const;
  /// The smallest and the largest gradient() of any strain.
  struct Slopes {
    double least = 1, most = 1;
  };
  [[nodiscard]] Slopes slopes() const;
  bool operator==(const PressureLaw&) const = default;
};

/// Returns the kind, k and the points of a law as numbers, for files and for keys of caches.
std::vector<double> numbers_of(const PressureLaw& law);
/// Returns the law of such numbers. Throws Error if they are none.
PressureLaw law_of(const std::vector<double>& numbers);
/// Returns a law in words, such as "p = E e/(1 - 0.78 e)".
std::string to_text(const PressureLaw& law);

/// Returns the first broken rule of a law, such as "k must be at least 0 and less than 1, is 1.2", or an empty text.
/// `place` (optional) receives the JSON pointer below the law.
std::string law_problem(const PressureLaw& law, std::string* place = nullptr);

/// Returns the strains at which contact polygons are divided, ascending and without 0: at most `most`. A straight line
/// between two of them differs from the law by about the same fraction of the pressure everywhere. Empty for a linear
/// law.
std::vector<double> law_levels(const PressureLaw& law, int most);

}  // namespace taxel
