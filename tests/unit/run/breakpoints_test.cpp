// Jumps of readings and searches for rows, compared with a slow implementation of their definitions.
#include "core/run/history/breakpoints.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/rng.h"
#include "core/run/history/lanes.h"

namespace taxel {
namespace {

struct Signal {
  std::vector<std::vector<double>> readings;  // readings of each step
  std::vector<double> force;
};

constexpr double kLeast = 5;  // [Pa]

/// Returns the first step with a jump by the definition, or 0 if there is none. With `at_equal_force`, the force must
/// be equal as well.
std::uint64_t first_jump(const Signal& signal, const Breakpoints& limits, bool at_equal_force) {
  for (std::size_t n = 1; n < signal.readings.size(); ++n) {
    for (std::size_t k = 0; k < signal.readings[n].size(); ++k) {
      double largest = kLeast;
      int touched = 0, sensor_touched = 0;
      for (std::size_t j = 0; j < signal.readings[n].size(); ++j) {
        int steps = 0;
        for (std::size_t m = 0; m <= n; ++m) {
          if (limits.of_sensor || j == k) largest = std::max(largest, signal.readings[m][j]);
          steps += signal.readings[m][j] != 0 ? 1 : 0;
        }
        if (j == k) touched = steps;
        sensor_touched = std::max(sensor_touched, steps);
      }
      const bool counts = (limits.of_sensor ? sensor_touched : touched) * limits.jump >= 3;
      const bool jumps = counts && std::abs(signal.readings[n][k] - signal.readings[n - 1][k]) > limits.jump * largest;
      const bool stays = std::abs(signal.force[n] - signal.force[n - 1]) <=
                         limits.equal_force * std::max(signal.force[n], signal.force[n - 1]);
      if (jumps && (!at_equal_force || stays)) return n;
    }
  }
  return 0;
}

std::uint64_t first_stop(const Signal& signal, const Breakpoints& limits) {
  JumpDetector detector;
  for (std::size_t n = 0; n < signal.readings.size(); ++n) {
    const SensorSignal now[] = {{signal.readings[n], signal.force[n], kLeast}};
    for (const auto& jump : detector.compare(n, 1e-3 * static_cast<double>(n), now, limits))
      if (jump && stops(*jump, limits)) return jump->step;
  }
  return 0;
}

TEST(JumpDetector, StopsAtTheFirstJumpOfTheDefinition) {
  int jumps = 0, equal = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const CounterRng rng(7, seed);
    Signal signal;
    std::uint64_t draw = 0;
    std::vector<double> readings(5, 0.0);
    double force = 0;
    for (int n = 0; n < 200; ++n) {
      for (double& reading : readings) {
        reading = std::max(0.0, reading + 400 * (rng.uniform(draw) - 0.4));
        if (rng.uniform(draw + 1) < 0.002) reading += 9000 * rng.uniform(draw + 2);
        draw += 3;
      }
      force = std::max(0.0, force + 0.1 * (rng.uniform(draw++) - 0.4));
      signal.readings.push_back(readings);
      signal.force.push_back(force);
    }
    Breakpoints limits;
    limits.jump = 0.15 + 0.5 * rng.uniform(draw++);
    limits.of_sensor = seed % 3 == 0;
    EXPECT_EQ(first_stop(signal, limits), 0u) << "off";
    limits.on_jump = true;
    const std::uint64_t first = first_jump(signal, limits, false);
    EXPECT_EQ(first_stop(signal, limits), first);
    jumps += first > 0 ? 1 : 0;
    limits.on_jump = false;
    limits.at_equal_force = true;
    const std::uint64_t calm = first_jump(signal, limits, true);
    EXPECT_EQ(first_stop(signal, limits), calm);
    equal += calm > first ? 1 : 0;
  }
  EXPECT_GT(jumps, 50);
  EXPECT_GT(equal, 5) << "some jumps are passed over because the force changes";
}

/// Ramps up to these readings in 100 steps, so that every taxel is considered.
void ramp_to(JumpDetector& detector, const std::vector<double>& readings, const Breakpoints& limits) {
  for (int n = 1; n <= 100; ++n) {
    std::vector<double> part = readings;
    for (double& reading : part) reading *= 0.01 * n;
    const SensorSignal now[] = {{part, 2.0, kLeast}};
    for (const auto& jump : detector.compare(static_cast<std::uint64_t>(n), 0, now, limits))
      EXPECT_FALSE(jump && is_jump(*jump, limits)) << "a first touch, step " << n;
  }
}

TEST(JumpDetector, NamesTaxelAndNumbers) {
  JumpDetector detector;
  Breakpoints limits;
  limits.on_jump = true;
  ramp_to(detector, {10000, 20000, 50}, limits);
  const std::vector<double> after{10000, 17000, 40};
  const SensorSignal now[] = {{after, 2.01, kLeast}};
  const Jump jump = detector.compare(101, 0.004, now, limits)[0].value();
  EXPECT_EQ(jump.taxel, 2) << "the largest part of its own largest reading, not the largest change";
  EXPECT_EQ(jump.step, 101u);
  EXPECT_EQ(jump.before, 50);
  EXPECT_EQ(jump.after, 40);
  EXPECT_DOUBLE_EQ(jump.part, 0.2);
  EXPECT_EQ(jump.force_before, 2.0);
  EXPECT_EQ(jump.force_after, 2.01);
  EXPECT_TRUE(jump.at_equal_force);
  EXPECT_EQ(detector.largest(0), 20000);
}

TEST(JumpDetector, MeasuresAgainstTheSensorOnRequest) {
  JumpDetector detector;
  Breakpoints limits;
  limits.on_jump = limits.of_sensor = true;
  ramp_to(detector, {10000, 20000, 50}, limits);
  const std::vector<double> after{10000, 17000, 40};
  const SensorSignal now[] = {{after, 2.01, kLeast}};
  const Jump jump = detector.compare(101, 0.004, now, limits)[0].value();
  EXPECT_EQ(jump.taxel, 1);
  EXPECT_DOUBLE_EQ(jump.part, 0.15);
}

/// Readings that begin as n, n^2 and n^3 do not jump, in any unit.
TEST(JumpDetector, IgnoresAFirstTouch) {
  for (const double unit : {1e-3, 1.0, 1e6}) {
    for (const double limit : {0.02, 0.1, 0.5}) {
      JumpDetector detector;
      Breakpoints limits;
      limits.jump = limit;
      for (int n = 0; n <= 300; ++n) {
        const double x = 0.01 * n;
        const std::vector<double> readings{unit * x, unit * x * x, unit * x * x * x};
        const SensorSignal now[] = {{readings, 1.0, 0.0}};
        for (const auto& jump : detector.compare(static_cast<std::uint64_t>(n), 0, now, limits))
          EXPECT_FALSE(jump && is_jump(*jump, limits)) << unit << ' ' << limit << ' ' << n;
      }
    }
  }
}

TEST(JumpDetector, ComparesOnlyTheSameTaxels) {
  JumpDetector detector;
  Breakpoints limits;
  ramp_to(detector, {100, 100}, limits);
  const std::vector<double> more{0, 0, 900};
  const SensorSignal now[] = {{more, 2.0, kLeast}};
  EXPECT_FALSE(detector.compare(101, 0, now, limits)[0].has_value());
}

HistoryLanes lanes_of(const std::vector<StepMark>& steps) {
  HistoryLanes lanes;
  lanes.steps = steps;
  return lanes;
}

TEST(Lanes, FindEventsInBothDirections) {
  HistoryLanes lanes = lanes_of({});
  EXPECT_EQ(next_event(lanes, 7, 1), 7u);
  for (std::uint64_t step = 100; step < 130; ++step) {
    lanes.steps.push_back({step, 0, 0, static_cast<std::uint8_t>(step == 104 || step == 117 ? 4 : 0)});
  }
  EXPECT_EQ(next_event(lanes, 100, 1), 104u);
  EXPECT_EQ(next_event(lanes, 104, 1), 117u);
  EXPECT_EQ(next_event(lanes, 117, 1), 117u) << "none after it";
  EXPECT_EQ(next_event(lanes, 129, -1), 117u);
  EXPECT_EQ(next_event(lanes, 110, -1), 104u);
  EXPECT_EQ(next_event(lanes, 104, -1), 104u);
}

TEST(Lanes, FindRowsByStepTimeAndTravel) {
  const HistoryLanes lanes =
      lanes_of({{50, 0.50, 1e-3, 0}, {51, 0.51, 2e-3, 0}, {52, 0.52, 2e-3, 0}, {53, 0.53, 3e-3, 0}});
  EXPECT_EQ(lanes.row_of(52), 2u);
  EXPECT_EQ(lanes.row_of(3), 0u);
  EXPECT_EQ(lanes.row_of(99), 3u);
  EXPECT_EQ(nearest_row(lanes, &StepMark::time, 0.5149), 1u);
  EXPECT_EQ(nearest_row(lanes, &StepMark::time, -1), 0u);
  EXPECT_EQ(nearest_row(lanes, &StepMark::time, 9), 3u);
  EXPECT_EQ(nearest_row(lanes, &StepMark::travel, 2.1e-3), 1u) << "of equal ones the first";
}

}  // namespace
}  // namespace taxel
