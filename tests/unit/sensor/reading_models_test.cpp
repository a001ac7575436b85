// The comparison of curves, with closed forms.
#include "core/sensor/compare.h"

#include <gtest/gtest.h>

#include <cmath>

namespace taxel {
namespace {

TEST(CompareCurve, FindsNoErrorInAScaledCurve) {
  const std::vector<double> exact{0, 1, 4, 2, 0.5}, curve{0, 3, 12, 6, 1.5};
  const CurveComparison c = compare_curve(curve, exact);
  EXPECT_EQ(c.peak, 12);
  EXPECT_NEAR(c.largest_step, 9.0 / 12, 1e-15);
  EXPECT_NEAR(*c.correlation, 1, 1e-14);
  EXPECT_NEAR(*c.rms, 0, 1e-7);
}

// Orthogonal curves: the best gain is 0, and the residual is the exact curve.
TEST(CompareCurve, HasTheWholeCurveAsErrorIfOrthogonal) {
  const std::vector<double> exact{3, 0, 3, 0}, curve{0, 5, 0, 5};
  const CurveComparison c = compare_curve(curve, exact);
  EXPECT_NEAR(*c.correlation, -1, 1e-14);
  EXPECT_NEAR(*c.rms, std::sqrt(0.5), 1e-14);
}

// e = c + n with n orthogonal to c: rms = |n| / sqrt(N) / peak. The correlation is computed directly.
TEST(CompareCurve, MeasuresTheResidualOfTheGain) {
  const std::vector<double> curve{1, 2, 3, 4}, noise{2, -1, 0, 0}, none(4, 0.0);
  std::vector<double> exact;
  for (std::size_t i = 0; i < 4; ++i) exact.push_back(curve[i] + noise[i]);
  const CurveComparison c = compare_curve(curve, exact);
  EXPECT_NEAR(*c.rms, std::sqrt(5.0 / 4) / 4, 1e-14);
  // The means are 2.5 and 2.75. The covariance is 4.5 - 1.5 + ..., by its definition.
  double cov = 0, vc = 0, ve = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    cov += (curve[i] - 2.5) * (exact[i] - 2.75);
    vc += (curve[i] - 2.5) * (curve[i] - 2.5);
    ve += (exact[i] - 2.75) * (exact[i] - 2.75);
  }
  EXPECT_NEAR(*c.correlation, cov / std::sqrt(vc * ve), 1e-14);
  EXPECT_FALSE(compare_curve(none, exact).correlation);
  EXPECT_FALSE(compare_curve(curve, none).correlation);
  EXPECT_FALSE(compare_curve(curve, none).rms);
  EXPECT_NEAR(*compare_curve(none, exact).rms, std::sqrt((9.0 + 1 + 9 + 16) / 4) / 4, 1e-14);
}

TEST(CompareCurve, IgnoresMissingValues) {
  const double nan = std::nan("");
  const CurveComparison c = compare_curve(std::vector<double>{0, nan, 2, 4}, std::vector<double>{0, 7, 1, 2});
  EXPECT_NEAR(*c.correlation, 1, 1e-14);
  EXPECT_EQ(c.peak, 4);
  EXPECT_NEAR(c.largest_step, 0.5, 1e-15);
  const CurveComparison empty = compare_curve(std::vector<double>{nan, nan}, std::vector<double>{1, 2});
  EXPECT_FALSE(empty.correlation || empty.rms);
  EXPECT_EQ(empty.peak, 0);
}

TEST(ModelReadings, HaveNoValuesOfAModelThatHasNotRead) {
  const ModelReadings readings{{{ReadingModel::exact, {1, 2}, "why"}}, {}};
  EXPECT_TRUE(readings[ReadingModel::exact].has(1));
  EXPECT_EQ(readings[ReadingModel::exact].missing, "why");
  EXPECT_FALSE(readings[ReadingModel::star].has(0));
  EXPECT_EQ(readings[ReadingModel::star].missing, "");
}

TEST(ReadingsTable, LeavesMissingValuesEmpty) {
  ComparedStep step{7, 0.5, 0.25, {}, false};
  step.readings.models = {{ReadingModel::star, {0.1, std::nan("")}, ""}};
  const ComparedStepList steps{std::make_shared<const ComparedStep>(step)};
  const std::vector<ModelColumns> columns{{ReadingModel::star, "star_", {3, 4}}, {ReadingModel::exact, "exact_", {3}}};
  EXPECT_EQ(readings_to_csv(steps, columns), "time,travel,star_3,star_4,exact_3\n0.5,0.25,0.1,,\n");
  EXPECT_EQ(compare_with_exact(steps, ReadingModel::star, 0).peak, 0.1);
}

}  // namespace
}  // namespace taxel
