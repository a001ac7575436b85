// Counter-based random numbers: published values and statistics.
#include "core/base/rng.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>

namespace taxel {
namespace {

TEST(CounterRng, MixesAsPublished) {
  // SplitMix64 seeded with 1234567: the first outputs of the authors' reference implementation.
  std::uint64_t state = 1234567;
  const std::array<std::uint64_t, 5> expected{6457827717110365317ULL, 3203168211198807973ULL, 9817491932198370423ULL,
                                              4593380528125082431ULL, 16408922859458223821ULL};
  for (const std::uint64_t value : expected) {
    EXPECT_EQ(mix64(state), value);
    state += 0x9e3779b97f4a7c15ULL;
  }
}

TEST(CounterRng, IsAFunctionOfSeedStreamAndCounter) {
  const CounterRng a(1, 2), same(1, 2), other_seed(2, 2), other_stream(1, 3);
  const std::uint64_t fifth = a.bits(5);
  EXPECT_EQ(same.bits(5), fifth) << "the order of the calls does not matter";
  EXPECT_NE(a.bits(6), fifth);
  EXPECT_NE(other_seed.bits(5), fifth);
  EXPECT_NE(other_stream.bits(5), fifth);
}

TEST(CounterRng, IsUniformAndUncorrelated) {
  const CounterRng rng(42);
  constexpr int kCount = 200000, kBins = 64;
  std::array<int, kBins> bins{};
  double sum = 0, lag = 0;
  for (int i = 0; i < kCount; ++i) {
    const auto counter = static_cast<std::uint64_t>(i);
    const double u = rng.uniform(counter);
    ASSERT_GE(u, 0);
    ASSERT_LT(u, 1);
    ++bins[static_cast<std::size_t>(u * kBins)];
    sum += u;
    lag += (u - 0.5) * (rng.uniform(counter + 1) - 0.5);
  }
  EXPECT_NEAR(sum / kCount, 0.5, 0.003);
  EXPECT_NEAR(lag / kCount * 12, 0, 0.01);
  double chi2 = 0;
  for (const int n : bins) chi2 += std::pow(n - kCount / kBins, 2) / (kCount / kBins);
  EXPECT_LT(chi2, 120) << "63 degrees of freedom: beyond 1 in 10^5";
}

TEST(CounterRng, SharesNoValuesBetweenNeighbouringSeedsAndStreams) {
  std::set<std::uint64_t> seen;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    for (std::uint64_t stream = 0; stream < 20; ++stream) {
      for (std::uint64_t i = 0; i < 50; ++i) seen.insert(CounterRng(seed, stream).bits(i));
    }
  }
  EXPECT_EQ(seen.size(), 20U * 20U * 50U);
}

}  // namespace
}  // namespace taxel
