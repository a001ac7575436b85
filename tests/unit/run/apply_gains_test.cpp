// Fitted gains as a calibration: the device then reports the recorded values.
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/run/real/align.h"
#include "core/sensor/calibration.h"
#include "fixtures/complaint.h"

namespace taxel {
namespace {

TaxelFit gain_of(int taxel, double gain, double offset) {
  TaxelFit fit;
  fit.taxel = taxel;
  fit.gain = gain;
  fit.offset = offset;
  return fit;
}

TEST(ApplyGains, CalibratesByTheFittedLine) {
  Layout layout;
  layout.taxels.resize(3);
  for (int i = 0; i < 3; ++i) layout.taxels[static_cast<std::size_t>(i)].id = 10 + i;
  TaxelFit refused;
  refused.taxel = 11;
  refused.refused = "does not respond in the run";
  layout.calibration = with_gains(std::nullopt, {gain_of(10, 0.002, 3), refused, gain_of(12, -0.5, 0)}, "V");
  EXPECT_EQ(layout.calibration->unit, "V");
  const std::vector<double> values = Calibrator(layout).advance(0, std::vector<double>{1000, 70, 8});
  EXPECT_DOUBLE_EQ(values[0], 0.002 * 1000 + 3);
  EXPECT_DOUBLE_EQ(values[1], 70) << "as it was";
  EXPECT_DOUBLE_EQ(values[2], -4);
}

TEST(ApplyGains, ChangesNothingElse) {
  Calibration before;
  before.unit = "mV";
  before.noise = 0.1;
  before.taxels = {{3, 7.0, {}, {{0, 0}, {1, 2}}, {}}, {4, {}, 2.0, {}, 0.5}};
  const Calibration after = with_gains(before, {gain_of(3, 5, 0)}, "");
  EXPECT_EQ(after.unit, "mV");
  EXPECT_EQ(after.noise, 0.1);
  ASSERT_EQ(after.taxels.size(), 2U);
  EXPECT_EQ(after.taxels[0].gain, 5);
  EXPECT_EQ(after.taxels[0].tare, 0);
  EXPECT_TRUE(after.taxels[0].curve.empty()) << "a curve and a gain exclude each other";
  EXPECT_EQ(after.taxels[1], before.taxels[1]);
  EXPECT_EQ(test::complaint_of([&] { with_gains(before, {}, ""); }), "no taxel has a gain");
}

}  // namespace
}  // namespace taxel
