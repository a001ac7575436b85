// A hand of five fingertips with 60 taxels that holds a ball: how many times real time one step of 2 ms runs.
#include <benchmark/benchmark.h>

#include "core/sim/simulator.h"

namespace taxel {
namespace {

/// The scene once the ball is held still. One for all rounds: opening it takes longer than they do.
Simulator& held() {
  static const auto simulator = [] {
    auto opened = Simulator::load(std::string(TAXEL_SOURCE_DIR) + "/assets/scenes/hand_grasps_ball.xml");
    for (int n = 0; n < 1500; ++n) opened->step();
    return opened;
  }();
  return *simulator;
}

void BM_five_fingers(benchmark::State& state) {
  Simulator* const simulator = &held();
  const SensorTimes before = simulator->sensor_times();
  std::size_t steps = 0;
  for (auto _ : state) {
    simulator->step();
    ++steps;
  }
  const SensorTimes after = simulator->sensor_times();
  const auto mean = [&](double from, double to) { return 1e6 * (to - from) / static_cast<double>(steps); };
  state.counters["surfaces_us"] = mean(before.surfaces, after.surfaces);
  state.counters["forces_us"] = mean(before.forces, after.forces);
  state.counters["readings_us"] = mean(before.readings, after.readings);
  std::size_t polygons = 0;
  for (const SensorView& sensor : simulator->view().sensors)
    for (const ContactSurface* surface : sensor.surfaces) polygons += surface->polygons.size();
  state.counters["polygons"] = static_cast<double>(polygons);
  state.counters["times_real_time"] =
      benchmark::Counter(static_cast<double>(steps) * simulator->scene()->timestep, benchmark::Counter::kIsRate);
}
BENCHMARK(BM_five_fingers)->Unit(benchmark::kMicrosecond)->MinTime(2);

}  // namespace
}  // namespace taxel

BENCHMARK_MAIN();
