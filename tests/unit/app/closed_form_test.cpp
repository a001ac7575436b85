// The statistics of the validation: which errors pass and which fail; the quadrature of A7 against published numbers.
#include "app/validate/validation.h"

#include <gtest/gtest.h>

#include <limits>

#include "app/validate/setups.h"

namespace taxel {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
const CheckedCase kCase{"A0", "nothing"};

TEST(ClosedForm, FailsForAnErrorOutOfBounds) {
  Statistic statistic;
  statistic.add(1.01, 1);
  statistic.add(-1.98, -2);  // the same error with the opposite sign
  EXPECT_TRUE(statistic.mean(kCase, "q", "N", 0.0101).pass());
  EXPECT_FALSE(statistic.mean(kCase, "q", "N", 0.0099).pass());
  statistic.add(-1, 1);  // a wrong sign
  const ClosedFormCheck worst = statistic.worst(kCase, "q", "N", 0.5);
  EXPECT_FALSE(worst.pass());
  EXPECT_EQ(worst.computed, -1);
  EXPECT_EQ(worst.exact, 1);
  EXPECT_EQ(worst.error, 2);
  EXPECT_EQ(worst.quantity, "q, worst of 3");
}

TEST(ClosedForm, FailsForValuesThatWereNotComputed) {
  Statistic statistic;
  statistic.add(1, 1);
  statistic.add(kNaN, 1);
  statistic.add(1, 1);
  EXPECT_FALSE(statistic.mean(kCase, "q", "N", 1).pass());
  EXPECT_FALSE(statistic.worst(kCase, "q", "N", 1).pass());
  EXPECT_FALSE(Statistic().mean(kCase, "q", "N", 1).pass());  // no pose at all
  EXPECT_FALSE(Statistic().worst(kCase, "q", "N", 1).pass());
  EXPECT_FALSE(kCase.limit("q", "1", kNaN, Relation::at_most, 1).pass());
}

TEST(ClosedForm, BoundsAnErrorOnOneSide) {
  EXPECT_TRUE(kCase.limit("q", "1", 2.1, Relation::at_least, 1.9).pass());
  EXPECT_FALSE(kCase.limit("q", "1", 1.8, Relation::at_least, 1.9).pass());
  EXPECT_TRUE(kCase.limit("q", "1", -3, Relation::at_most, 0.2).pass());
  EXPECT_FALSE(kCase.limit("q", "1", 0.3, Relation::at_most, 0.2).pass());
  EXPECT_NEAR(kCase.limit("q", "1", 0.3, Relation::at_most, 0.2).error, 0.5, 1e-12);
}

// A7 with two equal moduli is a plane through the lens circle. F and p0 are those of the flat disc.
TEST(TwoSpheresContact, IsADiscForEqualSpheres) {
  constexpr double R = 0.05, E = 1e5, x = 0.004, half = x / 2;
  const TwoSpheresContact c = two_spheres_contact({R, E, R, E, x});
  // A1: each sphere presses against its mirror image.
  const double force = kPi * E * half * half * (1 - 2 * half / (3 * R));
  EXPECT_NEAR(c.force, force, 1e-9 * force);
  EXPECT_NEAR(c.area, kPi * (2 * R * half - half * half), 1e-9 * c.area);
  EXPECT_NEAR(c.axis_pressure, E * half / R, 1e-9);
}

// Unequal moduli: the numbers in the design document, computed independently.
TEST(TwoSpheresContact, HasThePublishedNumbers) {
  const TwoSpheresContact c = two_spheres_contact({0.05, 1e5, 0.05, 4e5, 0.004});
  EXPECT_NEAR(c.rim_radius, 0.014, 1e-12);
  EXPECT_NEAR(c.axis_pressure, 6400, 1e-8);
  EXPECT_NEAR(c.force, 1.9568, 5e-5);
  EXPECT_NEAR(c.area, 620.317e-6, 5e-10);
  const TwoSpheresContact swapped = two_spheres_contact({0.05, 4e5, 0.05, 1e5, 0.004});
  EXPECT_NEAR(swapped.force, c.force, 1e-12);
  EXPECT_NEAR(swapped.area, c.area, 1e-15);
}

TEST(TurnUp, TurnsEveryUnitVectorToZ) {
  for (int i = 0; i < 100; ++i) {
    const dvec3 n = random_pose(40, i, 0).rotate(dvec3(0, 0, 1));
    EXPECT_LT(glm::distance(Pose{turn_up(n), dvec3(0)}.rotate(n), dvec3(0, 0, 1)), 1e-12);
  }
  EXPECT_LT(glm::distance(Pose{turn_up({0, 0, -1}), dvec3(0)}.rotate({0, 0, -1}), dvec3(0, 0, 1)), 1e-12);
}

}  // namespace
}  // namespace taxel
