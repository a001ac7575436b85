// Readings of skins whose pressure follows a law: a table that is a straight line reads as the linear law, and a ball
// on a plate reads as the law of its depth below each sample.
#include <gtest/gtest.h>

#include "core/sensor/contact_case/pose_readings.h"
#include "fixtures/strip.h"
#include "fixtures/touches.h"

namespace taxel {
namespace {

constexpr double kTipRadius = 0.0037;

std::vector<Pose> presses() {
  std::vector<Pose> poses;
  for (const double x : {-0.004, 0.0, 0.0031})
    for (const double depth : {0.0004, 0.0012, 0.0022, 0.0035})
      poses.push_back({dquat(1, 0, 0, 0), dvec3(x, 0.0004, 0.006 + kTipRadius - depth)});
  return poses;
}

TEST(LawReadings, AreThoseOfTheLinearLawWithAStraightTable) {
  const PressureLaw straight{LawKind::table, 0, {{0.07, 0.07}, {0.15, 0.15}, {0.3, 0.3}, {0.6, 0.6}, {1, 1}}};
  const HydroBodyPtr ball = make_body(test::ball_shape(kTipRadius), {}, "ball");
  Material soft;
  soft.modulus = 2e5;
  soft.thickness = 0.002;
  const HydroBodyPtr soft_ball = make_body(test::ball_shape(kTipRadius), soft, "soft ball");
  for (const HydroBodyPtr& object : {ball, soft_ball}) {
    for (const auto& [how, method] :
         {std::pair(Aggregate::weighted_mean, ReadingMethod::samples),
          std::pair(Aggregate::weighted_mean, ReadingMethod::exact), std::pair(Aggregate::max, ReadingMethod::samples),
          std::pair(Aggregate::force, ReadingMethod::samples)}) {
      const PoseReadings linear = read_poses(*test::strip_model({}, {how, method}), *object, presses());
      const PoseReadings table = read_poses(*test::strip_model(straight, {how, method}), *object, presses());
      double largest = 0;
      for (const double value : linear.readings) largest = std::max(largest, value);
      ASSERT_GT(largest, 0);
      // The exact integrals are quadratures over the polygons, which the table divides.
      const double error = method == ReadingMethod::exact ? 1e-4 : 1e-7;
      for (std::size_t i = 0; i < linear.readings.size(); ++i)
        EXPECT_NEAR(table.readings[i], linear.readings[i], error * largest) << i;
      for (std::size_t i = 0; i < linear.wrenches.size(); ++i)
        EXPECT_NEAR(table.wrenches[i], linear.wrenches[i], 1e-9) << i;
      for (std::size_t i = 0; i < linear.areas.size(); ++i) EXPECT_NEAR(table.areas[i], linear.areas[i], 1e-12) << i;
    }
  }
}

TEST(LawReadings, AreThoseOfTheLawAtTheSamples) {
  const PressureLaw law{LawKind::stiffening, 0.78, {}};
  Shape tip = test::ball_shape(kTipRadius);
  tip.resolution = kTipRadius / 40;
  const HydroBodyPtr ball = make_body(tip, {}, "ball");
  for (const ReadingMethod method : {ReadingMethod::samples, ReadingMethod::exact}) {
    const SensorModelPtr model = test::strip_model(law, {Aggregate::weighted_mean, method});
    const std::vector<Pose> poses = presses();
    const PoseReadings all = read_poses(*model, *ball, poses);
    double largest = 0;
    for (const double value : all.readings) largest = std::max(largest, value);
    for (std::size_t i = 0; i < poses.size(); ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        double sum = 0, weights = 0;
        for (int e = model->fields.first[k]; e < model->fields.first[k + 1]; ++e) {
          const ReceptiveFields::Entry& entry = model->fields.entries[at(e)];
          const dvec3& x = model->samples[at(entry.sample)].position;
          const double r2 = std::pow(x.x - poses[i].p.x, 2) + std::pow(x.y - poses[i].p.y, 2);
          const double left = kTipRadius * kTipRadius - r2;
          const double depth = left > 0 ? x.z - (poses[i].p.z - std::sqrt(left)) : 0;
          sum += entry.weight * test::kStripModulus * law.pressure(depth / test::kStripPad);
          weights += entry.weight;
        }
        // The exact integral differs from the mean of the samples by their sampling error, 0.98 % with a linear law.
        const double error = method == ReadingMethod::exact ? 0.012 : 0.001;
        EXPECT_NEAR(all.readings[3 * i + k], sum / weights, error * largest) << i << " " << k;
      }
    }
  }
}

}  // namespace
}  // namespace taxel
