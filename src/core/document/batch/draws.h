// Random numbers of jobs: a pure function of the job's seed, the parameter and the distribution.
#pragma once

#include <cstdint>
#include <string_view>

namespace taxel {

enum class Distribution { uniform, log_uniform, normal };

/// A number that each job draws.
struct Draw {
  Distribution distribution = Distribution::uniform;
  double first = 0;   ///< lower limit, or mean of `normal`
  double second = 1;  ///< upper limit, or standard deviation of `normal`
  bool operator==(const Draw&) const = default;
};

/// Throws Error("", "", ...) if the limits are not finite or not in order, the limits of `log_uniform` are not
/// positive, or the deviation is negative.
void check_draw(const Draw& draw);

/// Returns the number that the job with this seed draws for the parameter `pointer`. The limits of `uniform` and
/// `log_uniform` are never exceeded.
double draw_number(const Draw& draw, std::uint64_t seed, std::string_view pointer);

/// Returns the value `index` of `count` >= 2 values at even distances; the first is `from` and the last is `to`.
double value_of_range(double from, double to, std::size_t index, std::size_t count);

}  // namespace taxel
