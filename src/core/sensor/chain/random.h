// Random numbers of the chain: each is a function of (seed, part, taxel id, number of the value) alone, so it has the
// same bits on every machine, for any order of the taxels, any number of threads, and with any other parts.
#pragma once

#include <cstdint>

#include "core/base/rng.h"

namespace taxel {

/// Each part draws from its own streams, so that the numbers of a part do not depend on the other parts.
enum class RandomPart : std::uint64_t { noise = 1, gain, tare, dead };

/// Returns the numbers of one part and one taxel.
inline CounterRng random_stream(std::uint64_t seed, RandomPart part, int id) {
  return CounterRng(seed, (static_cast<std::uint64_t>(part) << 32U) | static_cast<std::uint32_t>(id));
}

/// Returns value n of a normal distribution of mean 0 and variance 1: the sum of 12 uniform numbers, less 6 (Irwin,
/// Hall 1927; the variance is 12/12 and the largest value 6). The numbers are summed as integers of 53 bits, without a
/// library's logarithm or cosine, so that the bits are the same on every machine.
inline double normal_number(const CounterRng& rng, std::uint64_t n) {
  constexpr std::uint64_t kTerms = 12;
  std::int64_t sum = -static_cast<std::int64_t>(kTerms / 2) * (std::int64_t{1} << 53);
  for (std::uint64_t i = 0; i < kTerms; ++i) sum += static_cast<std::int64_t>(rng.bits(kTerms * n + i) >> 11U);
  return static_cast<double>(sum) * 0x1.0p-53;
}

}  // namespace taxel
