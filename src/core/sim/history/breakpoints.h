// Where the simulation stops by itself: a reading that jumps, one that jumps although the force stays, and one that is
// not what the contact surface presses on the field. Free of MuJoCo.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace taxel {

/// What to stop at. Thresholds are relative and mark events whether or not they stop.
struct Breakpoints {
  bool on_jump = false;
  bool at_equal_force = false;
  double jump = 0.1;          ///< a change from one step to the next, as part of the largest reading of the run so far
  double equal_force = 0.02;  ///< the force stays where it changes by at most this part of itself
  bool on_disagreement = false;
  double disagreement = 0.1;  ///< between samples and surface (SampleGap::gap), as part of the same
  /// What the largest reading counts at least, so that a first touch is no jump.
  double least_pressure = 1e3;  ///< [Pa]
  double least_force = 0.01;    ///< for readings that are forces [N]
  bool operator==(const Breakpoints&) const = default;
};

/// A taxel that jumped.
struct Jump {
  std::uint64_t step = 0;
  double time = 0;  ///< [s]
  int sensor = 0, taxel = 0;
  double before = 0, after = 0;              ///< readings, in their unit
  double part = 0;                           ///< |after - before| over the largest reading
  double force_before = 0, force_after = 0;  ///< on the sensor [N]
  bool at_equal_force = false;
};

/// A taxel whose samples do not read what its field is pressed with (disagreement.h).
struct Disagreement {
  std::uint64_t step = 0;
  double time = 0;  ///< [s]
  int sensor = 0, taxel = 0;
  double sampled = 0, exact = 0;  ///< readings, in their unit
  double part = 0;                ///< the gap over the largest reading
};

/// What the simulation stopped at.
using Stop = std::variant<Jump, Disagreement>;

/// One sensor as the detector sees it.
struct SensorSignal {
  std::span<const double> readings;
  double force = 0;     ///< magnitude [N]
  bool forces = false;  ///< readings are in N, not in Pa
};

[[nodiscard]] inline bool is_jump(const Jump& jump, const Breakpoints& limits) {
  return jump.part > limits.jump;
}
/// Whether the simulation is to stop there.
[[nodiscard]] inline bool stops(const Jump& jump, const Breakpoints& limits) {
  return is_jump(jump, limits) && (limits.on_jump || (limits.at_equal_force && jump.at_equal_force));
}

/// Compares each step with the one before. Equation: taxel k of a sensor jumps in step n when
/// |r_k(n) - r_k(n-1)| > jump * max(least, max over all taxels j of the sensor and steps m <= n of r_j(m)),
/// and it does so at equal force where |F(n) - F(n-1)| <= equal_force * max(F(n), F(n-1)) besides.
class JumpDetector {
 public:
  void restart() { *this = {}; }
  /// The largest change of each sensor since the step before, a jump or not. There is none in the first step, and none
  /// of a sensor that had another number of taxels.
  const std::vector<std::optional<Jump>>& compare(std::uint64_t step, double time,
                                                  std::span<const SensorSignal> sensors, const Breakpoints& limits);
  /// As if the step just compared had been this one: it was read anew, or the run goes on from an earlier one.
  /// `largest` of each sensor so far; empty: as it is.
  void go_on_from(std::span<const SensorSignal> sensors, std::span<const double> largest);
  [[nodiscard]] double largest(std::size_t sensor) const { return latest_[sensor].largest; }
  /// What parts are parts of, [Pa] or [N].
  [[nodiscard]] static double scale(double largest, bool forces, const Breakpoints& limits) {
    return std::max(largest, forces ? limits.least_force : limits.least_pressure);
  }

 private:
  struct Latest {
    std::vector<double> readings;
    double force = 0, largest = 0;
  };
  bool begun_ = false;
  std::vector<Latest> latest_;  // per sensor
  std::vector<std::optional<Jump>> jumps_;
};

}  // namespace taxel
