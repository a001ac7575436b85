#include "core/sensor/chain/chain.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"

namespace taxel {
namespace {

/// All stages in their order.
constexpr StagePtr (*kStages[])(const ChainSettings&) = {
    make_response, make_relaxation, make_hysteresis,   make_low_pass, make_crosstalk, make_scaling,
    make_noise,    make_range,      make_quantisation, make_hold,     make_latency,   make_dead_taxels};

}  // namespace

Chain::Chain(const Layout& layout, double timestep)
    : taxels_(layout.taxels.size()), rate_(layout.calibration.value().rate) {
  const ChainSettings settings{layout, *layout.calibration, timestep};
  for (const auto make : kStages) {
    StagePtr stage = make(settings);
    if (stage == nullptr) continue;
    state_size_ += stage->state_size();
    stages_.push_back(std::move(stage));
  }
}

Moment Chain::moment(double time, std::span<const double> state) const {
  Moment now;
  now.reading = static_cast<std::uint64_t>(std::clamp(state[kReadings], 0.0, 0x1p53));
  now.value = now.reading;
  if (!now.is_first()) now.step = time - state[kTime];
  if (!rate_) return now;
  // Ticks are at k / rate. Times are sums of steps, so a tick may be reached a millionth of a period early.
  const double early = 1e-6;
  const double tick = std::clamp(std::floor(time * *rate_ + early), -0x1p53, 0x1p53);
  now.value = static_cast<std::uint64_t>(static_cast<std::int64_t>(tick));
  now.is_due = now.is_first() || tick != state[kValue];
  return now;
}

void Chain::advance(double time, std::span<const double> readings, std::span<double> state,
                    std::span<double> values) const {
  if (readings.size() != taxels_ || values.size() != taxels_)
    throw Error("calibration", fmt::format("{} readings for {} taxels", readings.size(), taxels_));
  if (state.size() != state_size_)
    throw Error("calibration", fmt::format("a state of {} numbers, needs {}", state.size(), state_size_));
  if (!std::isfinite(time) || (!is_new(state) && time < time_of(state)))
    throw Error("calibration", fmt::format("a reading at {} s after one at {} s", time, time_of(state)));
  const Moment now = moment(time, state);
  std::copy(readings.begin(), readings.end(), values.begin());
  std::size_t begin = kHeadSize;
  for (const StagePtr& stage : stages_) {
    stage->apply(now, state.subspan(begin, stage->state_size()), values);
    begin += stage->state_size();
  }
  state[kReadings] += 1.0;
  state[kTime] = time;
  state[kValue] = static_cast<double>(static_cast<std::int64_t>(now.value));
}

}  // namespace taxel
