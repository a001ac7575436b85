// Dashes on the screen: their lengths, and their position on the curve.
#include "ui/widgets/plot_curves.h"

#include <gtest/gtest.h>

#include <cmath>

namespace taxel::ui {
namespace {

TEST(DashedCurve, CutsAStraightLineIntoEqualDashes) {
  // 100 pixels long: 10 pixels per unit of x.
  const CurvePoints dashes = dashes_of({{0, 10}, {3, 3}}, 10, 7, {6, 4});
  ASSERT_EQ(dashes.x.size(), 30U) << "ten dashes of two points and a gap each";
  for (std::size_t i = 0; i < 10; ++i) {
    EXPECT_NEAR(dashes.x[3 * i], static_cast<double>(i), 1e-9);
    EXPECT_NEAR(dashes.x[3 * i + 1] - dashes.x[3 * i], 0.6, 1e-9);
    EXPECT_EQ(dashes.y[3 * i], 3);
    EXPECT_TRUE(std::isnan(dashes.x[3 * i + 2]));
  }
}

TEST(DashedCurve, ContinuesDashesAroundCorners) {
  CurvePoints zigzag;
  for (int i = 0; i <= 200; ++i) zigzag.x.push_back(i), zigzag.y.push_back(i % 2);
  const double sqrt2 = std::sqrt(2.0);
  const CurvePoints dashes = dashes_of(zigzag, 1, 1, {6, 4});
  double length = 0, of_dash = 0;
  int count = 0;
  for (std::size_t i = 0; i < dashes.x.size(); ++i) {
    if (std::isnan(dashes.x[i])) {
      if (++count < 28) {
        EXPECT_NEAR(of_dash, 6, 0.05) << count;  // pixels; the last segment is never shorter than this
      }
      length += of_dash, of_dash = 0;
    } else if (i > 0 && !std::isnan(dashes.x[i - 1])) {
      of_dash += std::hypot(dashes.x[i] - dashes.x[i - 1], dashes.y[i] - dashes.y[i - 1]);
    }
    if (std::isnan(dashes.x[i])) continue;
    const double phase = std::fmod(dashes.x[i], 2.0);
    EXPECT_NEAR(dashes.y[i], phase < 1 ? phase : 2 - phase, 1e-9) << "on the curve";
  }
  EXPECT_NEAR(length + of_dash, 0.6 * 200 * sqrt2, 6);
}

TEST(DashedCurve, HasNoDashesForASinglePoint) {
  EXPECT_TRUE(dashes_of({{1}, {2}}, 1, 1, {6, 4}).x.empty());
  EXPECT_TRUE(dashes_of({{1, 1}, {2, 2}}, 1, 1, {6, 4}).x.empty());
}

}  // namespace
}  // namespace taxel::ui
