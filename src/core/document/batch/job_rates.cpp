#include "core/document/batch/job_rates.h"

#include <fmt/format.h>

#include <cmath>
#include <map>

#include "core/base/error.h"

namespace taxel {
namespace {

constexpr double kRateRounding = 1e-9;  ///< relative difference of equal rates

/// Returns the number of time steps between two rows.
double steps_between_rows(const Scenario& scenario) {
  const auto seconds = [](const auto& motion) {
    if constexpr (requires { motion.record_every / motion.speed; })
      return motion.record_every / motion.speed;
    else
      return motion.record_interval;
  };
  return std::visit(seconds, scenario.motion) / scenario.timestep;
}

}  // namespace

void check_rates(const JobList& list, const std::string& file) {
  const std::string remedy = ": --fps N resamples all episodes to N rows a second, or give each rate a list of its own";
  std::map<double, int> lines;  // first line of each rate
  for (const Job& job : list.jobs) {
    if (!job.error.empty()) continue;
    const double steps = steps_between_rows(job.scenario), rate = 1 / (steps * job.scenario.timestep);
    if (std::abs(steps - std::round(steps)) > kRateRounding * steps)
      throw Error(file, fmt::format("line {}", job.line),
                  fmt::format("has a row every {:.6g} time steps, so its intervals are uneven{}", steps, remedy));
    const auto near = lines.lower_bound(rate * (1 - kRateRounding));
    if (near == lines.end() || near->first > rate * (1 + kRateRounding)) lines.emplace(rate, job.line);
  }
  if (lines.size() < 2) return;
  constexpr std::size_t kShown = 6;
  std::string rates;
  std::size_t shown = 0;
  for (const auto& [rate, line] : lines) {
    if (shown == kShown) break;
    rates += fmt::format("{}{:.6g} (line {})", shown++ == 0 ? "" : ", ", rate, line);
  }
  if (lines.size() > kShown) rates += fmt::format(" and {} more", lines.size() - kShown);
  throw Error(file, fmt::format("has episodes of different rows a second, {}{}", rates, remedy));
}

}  // namespace taxel
