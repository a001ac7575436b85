// Jumps of readings, and rows searched: against their definitions, written down once more the slow way.
#include "core/sim/history/breakpoints.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/rng.h"
#include "core/sim/history/lanes.h"

namespace taxel {
namespace {

struct Signal {
  std::vector<std::vector<double>> readings;  // step by step
  std::vector<double> force;
};

/// First step that the definition calls a jump (at equal force: with that besides); 0: none.
std::uint64_t first_jump(const Signal& signal, const Breakpoints& limits, bool at_equal_force) {
  for (std::size_t n = 1; n < signal.readings.size(); ++n) {
    double largest = limits.least_pressure;
    for (std::size_t m = 0; m <= n; ++m)
      for (const double reading : signal.readings[m]) largest = std::max(largest, reading);
    for (std::size_t k = 0; k < signal.readings[n].size(); ++k) {
      const bool jumps = std::abs(signal.readings[n][k] - signal.readings[n - 1][k]) > limits.jump * largest;
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
    const SensorSignal now[] = {{signal.readings[n], signal.force[n]}};
    for (const auto& jump : detector.compare(n, 1e-3 * static_cast<double>(n), now, limits))
      if (jump && stops(*jump, limits)) return jump->step;
  }
  return 0;
}

TEST(JumpDetector, StopsAtTheFirstStepThatTheDefinitionNames) {
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
    limits.jump = 0.05 + 0.3 * rng.uniform(draw++);
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

TEST(JumpDetector, NamesTaxelAndNumbers) {
  JumpDetector detector;
  Breakpoints limits;
  limits.on_jump = true;
  const std::vector<double> before{10000, 20000, 0}, after{10000, 15000, 500};
  const SensorSignal a[] = {{before, 2.0}}, b[] = {{after, 2.01}};
  EXPECT_FALSE(detector.compare(4, 0.003, a, limits)[0].has_value()) << "nothing to compare with";
  const Jump jump = detector.compare(5, 0.004, b, limits)[0].value();
  EXPECT_EQ(jump.taxel, 1);
  EXPECT_EQ(jump.step, 5u);
  EXPECT_EQ(jump.before, 20000);
  EXPECT_EQ(jump.after, 15000);
  EXPECT_DOUBLE_EQ(jump.part, 0.25);
  EXPECT_EQ(jump.force_before, 2.0);
  EXPECT_EQ(jump.force_after, 2.01);
  EXPECT_TRUE(jump.at_equal_force);
  EXPECT_EQ(detector.largest(0), 20000);
}

TEST(JumpDetector, AFirstTouchIsNoJumpAndOtherTaxelsAreNotCompared) {
  Breakpoints limits;
  limits.on_jump = true;
  for (const bool forces : {false, true}) {
    JumpDetector detector;
    const double least = forces ? limits.least_force : limits.least_pressure;
    const std::vector<double> none{0, 0}, touch{0.09 * least, 0}, jump{0.2 * least, 0}, more{0, 0, 0.9 * least};
    const auto stops_at = [&](const std::vector<double>& readings) {
      const SensorSignal now[] = {{readings, 0.0, forces}};
      const auto found = detector.compare(1, 0, now, limits)[0];
      return found && stops(*found, limits);
    };
    EXPECT_FALSE(stops_at(none));
    EXPECT_FALSE(stops_at(touch));
    EXPECT_TRUE(stops_at(jump));
    EXPECT_FALSE(stops_at(more));
  }
}

HistoryLanes lanes_of(const std::vector<StepMark>& steps) {
  HistoryLanes lanes;
  lanes.steps = steps;
  return lanes;
}

TEST(Lanes, EventsAreFoundInBothDirections) {
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

TEST(Lanes, RowsAreFoundByStepTimeAndTravel) {
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
