#include "core/sim/plugin/reported_values.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/error.h"

namespace taxel {

ReportedValues::ReportedValues(const mjModel& m, int instance, const Layout& layout)
    : instance_(instance),
      chain_(layout, m.opt.timestep),
      next_state_(chain_.state_size()),
      values_(chain_.taxel_count()) {
  if (static_cast<std::size_t>(m.plugin_statenum[instance]) < chain_.state_size())
    throw Error(
        "", "output",
        fmt::format("\"calibrated\" needs {} numbers of state, the model was compiled with {}: compile it again",
                    chain_.state_size(), m.plugin_statenum[instance]));
}

int ReportedValues::state_size(const mjModel& m, const Layout& layout) {
  return static_cast<int>(Chain(layout, m.opt.timestep).state_size());
}

std::size_t ReportedValues::begin_of_state(const mjModel& m) const {
  return static_cast<std::size_t>(m.plugin_stateadr[instance_] + m.plugin_statenum[instance_]) - chain_.state_size();
}

void ReportedValues::evaluate(const mjModel& m, const mjData& d, std::span<const double> readings) {
  const mjtNum* state = d.plugin_state + begin_of_state(m);
  std::copy_n(state, chain_.state_size(), next_state_.begin());
  if (begins_again_ || (!Chain::is_new(next_state_) && d.time < Chain::time_of(next_state_)))
    std::fill(next_state_.begin(), next_state_.end(), 0.0);
  chain_.advance(d.time, readings, next_state_, values_);
  has_next_state_ = true;
}

void ReportedValues::advance(const mjModel& m, mjData& d) {
  if (!has_next_state_) return;
  std::copy(next_state_.begin(), next_state_.end(), d.plugin_state + begin_of_state(m));
  has_next_state_ = begins_again_ = false;
}

}  // namespace taxel
