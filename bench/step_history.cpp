// Cost of the history of steps: additional time of a step, and memory. The fingertip sweep (12 taxels, 16 000 samples)
// is recorded in every second stretch of 30 steps, and in the next round in the other stretches. Measured is the
// processor time of the thread that steps. The times with and without recording are of the same steps in the same
// seconds, so other programs on the machine affect both equally.
//
//   bench_step_history [ROUNDS]
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstring>
#include <ctime>
#include <vector>

#include "core/run/history/step_history.h"
#include "core/sim/simulator.h"
#include "our_fingertip.h"

namespace {
using namespace taxel;

constexpr int kFirst = 900, kSteps = 1500;  // steps of the sweep that are in contact
constexpr int kStretch = 30;
constexpr double kSamples = 16000;

/// Returns the processor time of this thread, including the kernel's time, such as page faults of new memory [s].
double processor_seconds() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

struct Cost {
  double plain = 0, recorded = 0;  // [s]
  [[nodiscard]] double part() const { return recorded / plain - 1; }
};

/// Measures two rounds through the steps. The recorded steps are numbered without gaps.
Cost measure(Simulator& simulator, StepHistory& history) {
  Cost cost;
  SimState state;
  StepView view;
  std::uint64_t number = history.empty() ? 0 : history.last() + 1;
  for (int round = 0; round < 2; ++round) {
    simulator.reset();
    for (int i = 0; i < kFirst; ++i) simulator.step();
    for (int stretch = 0; stretch < kSteps / kStretch; ++stretch) {
      const bool records = (stretch + round) % 2 == 0;
      const double begin = processor_seconds();
      for (int i = 0; i < kStretch; ++i) {
        simulator.step();
        if (!records) continue;
        simulator.save_state(state);
        simulator.view(view);
        view.step = state.step = number++;
        history.record(view, state);
      }
      (records ? cost.recorded : cost.plain) += processor_seconds() - begin;
    }
  }
  return cost;
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

}  // namespace

int main(int argc, char** argv) {
  int rounds = 7;
  if (argc > 1) std::from_chars(argv[1], argv[1] + std::strlen(argv[1]), rounds);
  const SensorModelPtr model = bench::our_fingertip(kSamples);
  const auto simulator = Simulator::make_scenario(model, with_shape({}, ObjectShape::box));
  StepHistory full;
  full.set_limits({kSteps / 3, std::size_t{1} << 31});
  measure(*simulator, full);
  std::vector<double> plain, growing, going_round;
  std::size_t bytes = 0;
  for (int round = 0; round < rounds; ++round) {
    StepHistory fresh;
    const Cost first = measure(*simulator, fresh), later = measure(*simulator, full);
    bytes = fresh.bytes();
    plain.push_back(later.plain / kSteps);
    growing.push_back(first.part());
    going_round.push_back(later.part());
  }
  fmt::print("{} samples, {} taxels, steps {} to {} of the sweep, {} rounds\n\n", model->samples.size(),
             model->taxel_count(), kFirst, kFirst + kSteps, rounds);
  fmt::print("| a step of {:.0f} us | more than without, median | least | most |\n| --- | --- | --- | --- |\n",
             1e6 * median(plain));
  const auto print = [](const char* what, const std::vector<double>& parts) {
    fmt::print("| {} | {:+.1f} % | {:+.1f} % | {:+.1f} % |\n", what, 100 * median(parts),
               100 * *std::min_element(parts.begin(), parts.end()),
               100 * *std::max_element(parts.begin(), parts.end()));
  };
  print("with a history that grows", growing);
  print("with a full one", going_round);
  fmt::print("\n{} steps take {:.0f} MB\n", kSteps, 1e-6 * static_cast<double>(bytes));
  return 0;
}
