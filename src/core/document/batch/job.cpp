#include "core/document/batch/job.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/base/rng.h"

namespace taxel {
namespace {

/// FNV-1a, 64 bit (Fowler, Noll, Vo): gives each parameter a stream of random numbers of its own.
std::uint64_t stream_of(std::string_view pointer) {
  constexpr std::uint64_t kBasis = 0xcbf29ce484222325, kPrime = 0x100000001b3;
  std::uint64_t hash = kBasis;
  for (const char c : pointer) hash = (hash ^ static_cast<unsigned char>(c)) * kPrime;
  return hash;
}

}  // namespace

void check_draw(const Draw& draw) {
  const auto [distribution, first, second] = draw;
  if (!std::isfinite(first) || !std::isfinite(second))
    throw Error(fmt::format("must be two finite numbers, are {} and {}", first, second));
  if (distribution == Distribution::normal) {
    if (!(second >= 0)) throw Error(fmt::format("the standard deviation must not be negative, is {}", second));
    return;
  }
  if (!(first <= second)) throw Error(fmt::format("the lower limit {} is above the upper limit {}", first, second));
  if (distribution == Distribution::log_uniform && !(first > 0))
    throw Error(fmt::format("the lower limit must be greater than 0, is {}", first));
}

double draw_number(const Draw& draw, std::uint64_t seed, std::string_view pointer) {
  const CounterRng rng(seed, stream_of(pointer));
  const auto [distribution, first, second] = draw;
  const double u = rng.uniform(0);
  switch (distribution) {
    case Distribution::uniform:
      return std::clamp((1 - u) * first + u * second, first, second);
    case Distribution::log_uniform:
      return std::clamp(std::exp((1 - u) * std::log(first) + u * std::log(second)), first, second);
    case Distribution::normal:
      break;
  }
  // Box and Muller (1958). The argument of the logarithm is in (0, 1].
  const double radius = std::sqrt(-2 * std::log(1 - u));
  return first + second * radius * std::cos(2 * std::numbers::pi * rng.uniform(1));
}

std::size_t draw_choice(std::size_t count, std::uint64_t seed, std::string_view pointer) {
  const double u = CounterRng(seed, stream_of(pointer)).uniform(0);
  return std::min(static_cast<std::size_t>(u * static_cast<double>(count)), count - 1);
}

double value_of_range(double from, double to, std::size_t index, std::size_t count) {
  const double u = static_cast<double>(index) / static_cast<double>(count - 1);
  return (1 - u) * from + u * to;
}

namespace {

constexpr std::size_t kIdDigits = 32;

std::string group_id(const JobList& list, const std::vector<std::size_t>& jobs) {
  std::string ids;
  for (const std::size_t job : jobs) ids += list.jobs[job].id + "\n";
  return sha256_hex(ids).substr(0, kIdDigits);
}

}  // namespace

std::vector<JobGroup> group_jobs(const JobList& list, std::size_t size) {
  std::vector<std::vector<std::size_t>> of_layout;
  std::map<std::string, std::size_t> place_of;
  for (std::size_t i = 0; i < list.jobs.size(); ++i) {
    if (!list.jobs[i].error.empty()) continue;
    const auto [place, is_new] = place_of.try_emplace(list.jobs[i].layout_key, of_layout.size());
    if (is_new) of_layout.emplace_back();
    of_layout[place->second].push_back(i);
  }
  std::vector<JobGroup> groups;
  for (const std::vector<std::size_t>& jobs : of_layout) {
    for (std::size_t first = 0; first < jobs.size(); first += size) {
      JobGroup& group = groups.emplace_back();
      for (std::size_t i = first; i < jobs.size() && i < first + size; ++i) group.jobs.push_back(jobs[i]);
      group.id = group_id(list, group.jobs);
    }
  }
  return groups;
}

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
  const std::string remedy =
      list.of_scenes ? ": give all the same /scene/record_interval, or give each rate a list of its own"
                     : ": --fps N resamples all episodes to N rows a second, or give each rate a list of its own";
  std::map<double, int> lines;  // first line of each rate
  for (const Job& job : list.jobs) {
    if (!job.error.empty()) continue;
    const double steps = job.scene ? 1 : steps_between_rows(job.scenario);  // of a scene: SceneReader counts them
    const double rate = 1 / (job.scene ? job.scene->record_interval : steps * job.scenario.timestep);
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
