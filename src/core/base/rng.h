// Counter-based random numbers: value i of stream s under a seed is a pure function of (seed, s, i), so results do not
// depend on the order or the number of threads.
#pragma once

#include <cstdint>

namespace taxel {

/// SplitMix64 finaliser (Steele, Lea, Flood 2014): a bijection of 64 bits that passes BigCrush when fed a counter.
inline std::uint64_t mix64(std::uint64_t z) {
  z += 0x9e3779b97f4a7c15ULL;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}

/// Random access into one stream of one seed.
class CounterRng {
 public:
  explicit CounterRng(std::uint64_t seed, std::uint64_t stream = 0) : key_(mix64(seed ^ mix64(stream))) {}
  [[nodiscard]] std::uint64_t bits(std::uint64_t i) const { return mix64(key_ ^ mix64(i)); }
  /// Uniform in [0, 1), 53 bits.
  [[nodiscard]] double uniform(std::uint64_t i) const { return static_cast<double>(bits(i) >> 11) * 0x1.0p-53; }

 private:
  std::uint64_t key_;
};

}  // namespace taxel
