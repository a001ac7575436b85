// Breakpoints of the simulation: a reading that jumps, a reading that jumps at equal force, and a reading that differs
// from the exact integral over the contact surface. Free of MuJoCo.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace taxel {

/// The events at which to stop. Thresholds are relative, and mark events whether or not the simulation stops at them.
struct Breakpoints {
  bool on_jump = false;
  bool at_equal_force = false;
  /// A change from one step to the next, as a fraction of the taxel's largest reading of the run so far.
  double jump = 0.1;
  double equal_force = 0.02;  ///< largest change of an equal force, as a fraction of the force
  bool on_disagreement = false;
  double disagreement = 0.1;  ///< SampleGap::gap, as a fraction of the largest reading
  bool of_sensor = false;     ///< use the largest reading of all taxels of the sensor
  bool operator==(const Breakpoints&) const = default;
};

/// A taxel that jumped.
struct Jump {
  std::uint64_t step = 0;
  double time = 0;  ///< [s]
  int sensor = 0, taxel = 0;
  double before = 0, after = 0;              ///< readings, in their unit
  double part = 0;                           ///< |after - before| / largest reading; 0 at a first touch
  double force_before = 0, force_after = 0;  ///< on the sensor [N]
  bool at_equal_force = false;
  double largest_change = 0;  ///< largest |after - before| of all taxels of this sensor
};

/// A taxel whose sampled reading differs from the exact integral over its field (field_integral.h).
struct Disagreement {
  std::uint64_t step = 0;
  double time = 0;  ///< [s]
  int sensor = 0, taxel = 0;
  double sampled = 0, exact = 0;  ///< readings, in their unit
  double part = 0;                ///< gap / largest reading
};

/// The event that stopped the simulation.
using Stop = std::variant<Jump, Disagreement>;

/// The values of one sensor that the detector compares.
struct SensorSignal {
  std::span<const double> readings;
  double force = 0;  ///< magnitude [N]
  double least = 0;  ///< lower bound of the largest reading (explanation.h) [unit of the readings]
};

/// The readings of one sensor in the steps so far.
struct ReadingHistory {
  std::vector<double> largest;  ///< magnitude, by taxel
  std::vector<int> touched;     ///< number of steps with a reading other than 0, by taxel
};

[[nodiscard]] inline bool is_jump(const Jump& jump, const Breakpoints& limits) {
  return jump.part > limits.jump;
}
/// Returns whether the simulation stops at this jump.
[[nodiscard]] inline bool stops(const Jump& jump, const Breakpoints& limits) {
  return is_jump(jump, limits) && (limits.on_jump || (limits.at_equal_force && jump.at_equal_force));
}

/// Compares each step with the previous step. Equation: taxel k of a sensor jumps in step n when
/// |r_k(n) - r_k(n-1)| > jump * max(least, max over all steps m <= n of |r_k(m)|),
/// and it does so at equal force if also |F(n) - F(n-1)| <= equal_force * max(F(n), F(n-1)). With `of_sensor` the
/// largest reading is that of all taxels.
///
/// A first touch is no jump: a reading that begins to grow as n^c changes by the fraction c / n of itself in its n-th
/// step, so a taxel counts once it was touched in 3 / jump steps; c is at most 3 (area, pressure and weight grow
/// together).
class JumpDetector {
 public:
  void restart() { *this = {}; }
  /// Returns for each sensor the change since the previous step that is the largest fraction of its taxel's largest
  /// reading, whether or not it is a jump; the largest change if no taxel is valid yet. Empty at the first step, and
  /// for a sensor whose number of taxels changed.
  const std::vector<std::optional<Jump>>& compare(std::uint64_t step, double time,
                                                  std::span<const SensorSignal> sensors, const Breakpoints& limits);
  /// Continues as if the latest step had these signals, because it was read again or the run continues from an earlier
  /// step. `histories` replaces the histories of the sensors; if it is empty they stay as they are.
  void continue_from(std::span<const SensorSignal> sensors, std::span<const ReadingHistory> histories);
  /// Returns the largest reading of all taxels of a sensor so far.
  [[nodiscard]] double largest(std::size_t sensor) const;
  /// Returns the reading that fractions of one taxel are measured by, whether or not the taxel counts yet.
  [[nodiscard]] double scale(std::size_t sensor, int taxel, double least, bool of_sensor) const;
  /// Returns for each taxel the reading that fractions are measured by [Pa] or [N]; infinite if the taxel does not
  /// count yet for a threshold `limit`.
  [[nodiscard]] std::vector<double> scales(std::size_t sensor, double least, double limit, bool of_sensor) const;

 private:
  static constexpr double kMaxGrowth = 3;  // exponent c of a reading that begins
  struct Latest {
    std::vector<double> readings;
    double force = 0;
    ReadingHistory history;
  };
  static double counted_scale(const ReadingHistory& history, std::size_t taxel, double least, double limit,
                              bool of_sensor);
  bool begun_ = false;
  std::vector<Latest> latest_;  // per sensor
  std::vector<std::optional<Jump>> jumps_;
};

}  // namespace taxel
