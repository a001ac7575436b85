// Shift and gains between a run and a real recording: known values are found, and values that cannot be determined are
// reported.
#include <gtest/gtest.h>

#include <cmath>

#include "core/base/rng.h"
#include "core/run/real/align.h"

namespace taxel {
namespace {

/// Returns the value of taxel k at time t: two smooth bumps.
double bump(int taxel, double t) {
  const double a = (t - 0.8 - 0.1 * taxel) / 0.12, b = (t - 1.7) / (0.2 + 0.02 * taxel);
  return std::exp(-a * a) + 0.4 * std::exp(-b * b);
}

/// Returns a series sampled every `interval` from `begin` to `end`. `jitter` is that of the times, in intervals;
/// `noise` is a standard deviation.
TaxelSeries sampled(double begin, double end, double interval, double shift, double gain, double offset, double noise,
                    double jitter = 0, std::uint64_t seed = 7) {
  TaxelSeries series{"", {}, {4, 9, 2}, {{}, {}, {}}};
  const CounterRng rng(seed);
  std::uint64_t n = 0;
  for (int i = 0; begin + i * interval <= end; ++i) {
    const double t = begin + (i + jitter * (rng.uniform(n++) - 0.5)) * interval;
    series.time.push_back(t - shift);
    for (int k = 0; k < 3; ++k) {
      double sum = 0;
      for (int j = 0; j < 12; ++j) sum += rng.uniform(n++);  // approximately normal
      series.values[static_cast<std::size_t>(k)].push_back(gain * (k + 1) * bump(k, t) + offset + noise * (sum - 6));
    }
  }
  return series;
}

TEST(Align, FindsAKnownShiftToAFractionOfASample) {
  const TaxelSeries run = sampled(0, 2.4, 0.001, 0, 1000, 0, 0);
  for (const double shift : {0.0, 0.25, -3.0, 0.123456, 117.00037}) {
    // The first value is between two values of the run.
    const auto found = align(run, sampled(0.00037, 2.4, 0.01, shift, 3, 40, 0));
    ASSERT_TRUE(found) << shift;
    EXPECT_NEAR(found->shift, shift, 0.05 * 0.001) << "a twentieth of the finer interval";
    EXPECT_GT(found->correlation, 0.9999);
    EXPECT_NEAR(found->overlap, 2.4, 0.02);
    EXPECT_LE(found->overlap, 2.39 + 1e-9) << "the recording lasts 2.39 s";
  }
}

TEST(Align, FindsAShiftInSpiteOfNoiseJitterAndOtherLengths) {
  const TaxelSeries run = sampled(0, 2.4, 0.001, 0, 1000, 0, 0);
  double squares = 0;
  constexpr int kSeeds = 12;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {  // noise: 5 % of the smallest peak
    const auto found = align(run, sampled(-4, 9, 0.0137, 0.4321, 3, 40, 0.15, 0.5, seed));
    ASSERT_TRUE(found);
    squares += (found->shift - 0.4321) * (found->shift - 0.4321);
  }
  EXPECT_LT(std::sqrt(squares / kSeeds), 0.0137 / 8) << "an eighth of the recording's interval";
  const auto part = align(run, sampled(0.5, 2.0, 0.01, -1.5, 3, 40, 0.03));
  ASSERT_TRUE(part);
  EXPECT_NEAR(part->shift, -1.5, 0.1 * 0.01) << "a tenth of the recording's interval";
}

TEST(Align, IgnoresMissingValuesAndGaps) {
  const TaxelSeries run = sampled(0, 2.4, 0.001, 0, 1000, 0, 0);
  TaxelSeries real = sampled(0, 2.4, 0.01, 0.25, 3, 40, 0);
  for (std::size_t i = 0; i < 20; ++i) real.values[1][60 + i] = std::numeric_limits<double>::quiet_NaN();
  real.values[0][5] = std::numeric_limits<double>::quiet_NaN();
  const auto found = align(run, real);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->shift, 0.25, 0.1 * 0.001);
}

TEST(Align, IgnoresATaxelWithNoiseAlone) {
  const TaxelSeries run = sampled(0, 2.4, 0.001, 0, 1000, 0, 0);
  TaxelSeries real = sampled(0, 2.4, 0.01, 0.25, 30, 0, 0);
  const CounterRng rng(3);
  for (std::size_t i = 0; i < real.time.size(); ++i) real.values[2][i] = rng.uniform(i);
  const auto found = align(run, real);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->shift, 0.25, 0.1 * 0.001);
}

TEST(Align, FindsNothingForCurvesThatDoNotAlign) {
  const TaxelSeries run = sampled(0, 2.4, 0.001, 0, 1000, 0, 0);
  EXPECT_FALSE(align(run, sampled(0, 2.4, 0.01, 0, 0, 5, 0))) << "constant";
  EXPECT_FALSE(align(run, TaxelSeries{"", {0, 1}, {77}, {{1, 2}}})) << "no taxel in common";
  EXPECT_FALSE(align(run, {})) << "nothing";
}

TEST(GainFit, RecoversKnownGains) {
  const TaxelSeries run = sampled(0, 2.4, 0.001, 0, 1000, 0, 0);
  const TaxelSeries real = sampled(0, 2.4, 0.002, 0.25, 3, 40, 0);
  const std::vector<TaxelFit> fits = fit_gains(run, real, 0.25, {});
  ASSERT_EQ(fits.size(), 3U);
  for (const TaxelFit& fit : fits) {
    EXPECT_EQ(fit.refused, "");
    EXPECT_NEAR(fit.gain, 0.003, 1e-6);
    EXPECT_NEAR(fit.offset, 40, 1e-3);
    EXPECT_GT(fit.r2, 0.999999);
    EXPECT_EQ(fit.points, 2401U);
  }
  EXPECT_EQ(fits[1].taxel, 9);
}

TEST(GainFit, FitsOneGainToAllPairs) {
  const TaxelSeries run = sampled(0, 2.4, 0.01, 0, 1000, 0, 0);
  TaxelSeries real = sampled(0, 2.4, 0.01, 0, 3, 0, 0);
  for (double& value : real.values[0]) value *= 1.5;
  const std::vector<TaxelFit> fits = fit_gains(run, real, 0, {true, false});
  double xx = 0, xy = 0;  // by the definition
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < run.time.size(); ++i)
      xx += run.values[k][i] * run.values[k][i], xy += run.values[k][i] * real.values[k][i];
  for (const TaxelFit& fit : fits) {
    EXPECT_NEAR(fit.gain, xy / xx, 1e-12 * xy / xx);
    EXPECT_EQ(fit.offset, 0);
  }
  EXPECT_GT(fits[0].residual, 0.01) << "its own gain would be larger";
}

TEST(GainFit, HasTheNoiseAsResidual) {
  const TaxelSeries run = sampled(0, 2.4, 0.001, 0, 1000, 0, 0);
  const std::vector<TaxelFit> fits = fit_gains(run, sampled(0, 2.4, 0.001, 0, 3, 40, 0.2), 0, {});
  ASSERT_EQ(fits.size(), 3U);
  for (const TaxelFit& fit : fits) {
    EXPECT_NEAR(fit.residual, 0.2, 0.02);
    EXPECT_NEAR(fit.gain, 0.003, 0.0001);
    EXPECT_GT(fit.largest_error, fit.residual);
  }
}

TEST(GainFit, NamesTheReasonForATaxelWithoutAGain) {
  TaxelSeries run = sampled(0, 2.4, 0.001, 0, 1000, 0, 0);
  TaxelSeries real = sampled(0, 2.4, 0.001, 0, 3, 40, 0);
  for (double& value : run.values[0]) value *= 1e-3;
  for (double& value : real.values[1]) value = 5;
  const CounterRng rng(3);
  for (std::size_t i = 0; i < real.time.size(); ++i) real.values[2][i] = rng.uniform(i);
  const std::vector<TaxelFit> fits = fit_gains(run, real, 0, {});
  EXPECT_EQ(fits[0].refused, "does not respond in the run");
  EXPECT_EQ(fits[1].refused, "is constant in the recording");
  EXPECT_EQ(fits[2].refused.substr(0, 24), "does not follow the run:");
  for (const TaxelFit& fit : fits) EXPECT_EQ(fit.gain, 0);
  const std::vector<TaxelFit> late = fit_gains(run, real, 100, {});
  EXPECT_EQ(late[1].refused, "has no values in the recording while the run lasts");
}

TEST(GainFit, WritesTheAlignedTableAtTheTimesOfTheRun) {
  const TaxelSeries run{"Pa", {0, 1, 2}, {5}, {{0, 10, 20}}};
  const TaxelSeries real{"V", {10.5, 11.5, 12.5}, {5}, {{1, 2, 3}}};
  const std::vector<TaxelFit> fits = fit_gains(run, real, -10, {});
  EXPECT_EQ(aligned_csv(run, real, -10, fits).substr(0, 38), "time,taxel_5,real_5,fitted_5\n0,0,,\n1,1");
  TaxelFit fit{5, "", 0.1, 0.5};
  EXPECT_EQ(aligned_csv(run, real, -10, {fit}), "time,taxel_5,real_5,fitted_5\n0,0,,0.5\n1,10,1.5,1.5\n2,20,2.5,2.5\n");
}

TEST(GainFit, WritesTheFitsAsATable) {
  ColumnMapping mapping;
  mapping.unit = "V";
  mapping.taxels = {{9, "left, low", {}, {}}, {5, "p5", {}, {}}};
  const std::vector<TaxelFit> fits{{5, "", 0.1, 0.5, 0.875, 0.25, 1, 7}, {9, "is constant, at 0"}};
  EXPECT_EQ(fits_csv(fits, mapping, "Pa", -0.5),
            "taxel,column,gain,gain_unit,offset,r2,rms,unit,shift_s,points,refused\n"
            "5,p5,0.1,V/Pa,0.5,0.875,0.25,V,-0.5,7,\n"
            "9,\"left, low\",,V/Pa,,,,V,-0.5,0,\"is constant, at 0\"\n");
}

}  // namespace
}  // namespace taxel
