#include "core/sensor/explain/samples_needed.h"

namespace taxel {

std::array<double, 3> noise_of_levels(const SampleLevels& levels, const Readings& exact) {
  std::array<double, 3> noise{};
  for (std::size_t i = 0; i < noise.size(); ++i)
    noise[i] = std::hypot(levels.before[i] - exact.before, levels.now[i] - exact.now);
  return noise;
}

SamplesNeeded samples_needed(const SampleLevels& levels, const Readings& exact, double allowed) {
  constexpr double kSlowest = 0.25, kFastest = 1.25;
  const std::array<double, 3> noise = noise_of_levels(levels, exact);
  const double asked = levels.samples[Convergence::kAsked];
  const auto needs = [&](double samples, bool measured) {
    return SamplesNeeded{samples, asked > 0 ? samples / asked : 0.0, measured};
  };
  // The least of them from which on all are quiet.
  std::size_t quiet = noise.size();
  while (quiet > 0 && noise[quiet - 1] <= allowed) --quiet;
  if (quiet < noise.size()) return needs(levels.samples[quiet], true);
  if (!(allowed > 0)) return {};
  double xx = 0, xy = 0, x = 0, y = 0;
  const double n = static_cast<double>(noise.size());
  for (std::size_t i = 0; i < noise.size(); ++i) {
    const double lx = std::log(static_cast<double>(std::max(1, levels.samples[i]))), ly = std::log(noise[i]);
    if (!std::isfinite(ly)) return {};
    x += lx, y += ly, xx += lx * lx, xy += lx * ly;
  }
  const double spread = n * xx - x * x;
  const double rate = std::clamp(spread > 0 ? -(n * xy - x * y) / spread : kSlowest, kSlowest, kFastest);
  const double samples = levels.samples.back() * std::pow(noise.back() / allowed, 1 / rate);
  return samples <= kMaxSamples ? needs(std::ceil(samples), false) : SamplesNeeded{};
}

}  // namespace taxel
