// Where the simulation stops by itself: a reading that jumps, one that jumps although the force stays, and one that is
// not what the contact surface presses on the field. Free of MuJoCo.
#pragma once

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
  /// A change from one step to the next, as a fraction of the taxel's largest reading of the run so far.
  double jump = 0.1;
  double equal_force = 0.02;  ///< the force stays where it changes by at most this part of itself
  bool on_disagreement = false;
  double disagreement = 0.1;  ///< between samples and surface (SampleGap::gap), as a fraction of the same
  bool of_sensor = false;     ///< measures against the largest reading of all taxels of the sensor instead
  bool operator==(const Breakpoints&) const = default;
};

/// A taxel that jumped.
struct Jump {
  std::uint64_t step = 0;
  double time = 0;  ///< [s]
  int sensor = 0, taxel = 0;
  double before = 0, after = 0;              ///< readings, in their unit
  double part = 0;                           ///< |after - before| over the largest reading; 0 in a first touch
  double force_before = 0, force_after = 0;  ///< on the sensor [N]
  bool at_equal_force = false;
  double largest_change = 0;  ///< |after - before| of the taxel of this sensor that changed most, jump or not
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
  double force = 0;  ///< magnitude [N]
  double least = 0;  ///< least value of a largest reading (reading_floor.h) [unit of the readings]
};

/// The readings of one sensor in the steps so far.
struct ReadingHistory {
  std::vector<double> largest;  ///< magnitude, by taxel
  std::vector<int> touched;     ///< number of steps with a reading other than 0, by taxel
};

[[nodiscard]] inline bool is_jump(const Jump& jump, const Breakpoints& limits) {
  return jump.part > limits.jump;
}
/// Whether the simulation is to stop there.
[[nodiscard]] inline bool stops(const Jump& jump, const Breakpoints& limits) {
  return is_jump(jump, limits) && (limits.on_jump || (limits.at_equal_force && jump.at_equal_force));
}

/// Compares each step with the one before. Equation: taxel k of a sensor jumps in step n when
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
  /// The change of each sensor since the step before that is the largest fraction of its taxel's largest reading, a
  /// jump or not; of several that do not count yet the largest change. There is none in the first step, and none of a
  /// sensor that had another number of taxels.
  const std::vector<std::optional<Jump>>& compare(std::uint64_t step, double time,
                                                  std::span<const SensorSignal> sensors, const Breakpoints& limits);
  /// As if the step just compared had been this one: it was read anew, or the run goes on from an earlier one.
  /// `histories` of the sensors so far; empty: as they are.
  void go_on_from(std::span<const SensorSignal> sensors, std::span<const ReadingHistory> histories);
  /// Of all taxels of a sensor, of the steps compared so far.
  [[nodiscard]] double largest(std::size_t sensor) const;
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
  static double scale(const ReadingHistory& history, std::size_t taxel, double least, double limit, bool of_sensor);
  bool begun_ = false;
  std::vector<Latest> latest_;  // per sensor
  std::vector<std::optional<Jump>> jumps_;
};

}  // namespace taxel
