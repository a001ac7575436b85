// Poses and boxes: inverses, products and bounds on random values.
#include "core/base/math.h"

#include <gtest/gtest.h>

#include "core/base/rng.h"

namespace taxel {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();

/// Random poses and points by index.
class PoseTest : public testing::Test {
 protected:
  dvec3 point() { return {next(), next(), next()}; }
  Pose pose() { return {glm::normalize(dquat(next(), next(), next(), next())), point()}; }

 private:
  double next() { return 2 * rng_.uniform(i_++) - 1; }
  CounterRng rng_{3};
  std::uint64_t i_ = 0;
};

TEST_F(PoseTest, InvertsAPose) {
  for (int i = 0; i < 200; ++i) {
    const Pose X = pose();
    const dvec3 p = point();
    EXPECT_NEAR(glm::distance(X.inverse() * (X * p), p), 0, 1e-14);
    EXPECT_NEAR(glm::distance((X * X.inverse()) * p, p), 0, 1e-14);
  }
}

TEST_F(PoseTest, MultipliesPosesAsOneAfterTheOther) {
  for (int i = 0; i < 200; ++i) {
    const Pose X_AB = pose(), X_BC = pose();
    const dvec3 p_C = point();
    EXPECT_NEAR(glm::distance((X_AB * X_BC) * p_C, X_AB * (X_BC * p_C)), 0, 1e-14);
  }
}

TEST_F(PoseTest, KeepsLengthsAndHandednessInARotation) {
  for (int i = 0; i < 200; ++i) {
    const Pose X = pose();
    const dvec3 v = point();
    EXPECT_NEAR(glm::length(X.rotate(v)), glm::length(v), 1e-14);
    EXPECT_NEAR(glm::determinant(X.rotation()), 1, 1e-14);
  }
}

TEST_F(PoseTest, GivesARigidTransformOfThePoseAndItsInverse) {
  for (int i = 0; i < 200; ++i) {
    const Pose X = pose();
    const RigidTransform T(X);
    const dvec3 p = point();
    EXPECT_NEAR(glm::distance(T(p), X * p), 0, 1e-15);
    EXPECT_NEAR(glm::distance(T.inverse_point(p), X.inverse() * p), 0, 1e-14);
  }
}

TEST(Pose, TurnsCounterClockwiseAboutItsAxis) {
  const Pose X{glm::angleAxis(kPi / 2, dvec3(0, 0, 1)), {1, 2, 3}};
  EXPECT_NEAR(glm::distance(X * dvec3(1, 0, 0), dvec3(1, 3, 3)), 0, 1e-15);
}

TEST(Aabb, IsEmptyUntilAPointIsIncluded) {
  Aabb box;
  EXPECT_TRUE(box.empty());
  EXPECT_EQ(box.surface_area(), 0);
  EXPECT_EQ(box.diagonal(), 0);
  box.include(dvec3(1, 2, 3));
  EXPECT_FALSE(box.empty());
  EXPECT_EQ(box.surface_area(), 0);
  box.include(dvec3(2, 4, 6));
  EXPECT_EQ(box.extent(), dvec3(1, 2, 3));
  EXPECT_EQ(box.surface_area(), 22);
  EXPECT_EQ(box.center(), dvec3(1.5, 3, 4.5));
  box.include(Aabb{});
  EXPECT_EQ(box.extent(), dvec3(1, 2, 3));
}

TEST(Aabb, OverlapsATouchingBoxButNoEmptyOne) {
  const Aabb a{dvec3(0), dvec3(1)};
  EXPECT_TRUE(a.overlaps({dvec3(1, 0, 0), dvec3(2, 1, 1)}));
  EXPECT_FALSE(a.overlaps({dvec3(1.001, 0, 0), dvec3(2, 1, 1)}));
  EXPECT_FALSE(a.overlaps({dvec3(0, 0, -2), dvec3(1, 1, -1)}));
  EXPECT_FALSE(a.overlaps(Aabb{}));
}

TEST(Math, GivesAPerpendicularOfUnitLength) {
  const CounterRng rng(4);
  for (std::uint64_t i = 0; i < 300; i += 3) {
    const dvec3 n = glm::normalize(dvec3(rng.uniform(i) - 0.5, rng.uniform(i + 1) - 0.5, rng.uniform(i + 2) - 0.5));
    const dvec3 p = any_perpendicular(n);
    EXPECT_NEAR(glm::length(p), 1, 1e-14);
    EXPECT_NEAR(glm::dot(p, n), 0, 1e-14);
  }
  for (const dvec3& axis : {dvec3(1, 0, 0), dvec3(0, 1, 0), dvec3(0, 0, -1)})
    EXPECT_NEAR(glm::length(any_perpendicular(axis)), 1, 1e-14);
}

TEST(Math, CallsAVectorFiniteIfAllCoordinatesAre) {
  EXPECT_TRUE(is_finite({1, 2, 3}));
  for (int i = 0; i < 3; ++i) {
    dvec3 v(1);
    v[i] = i == 1 ? kInf : std::nan("");
    EXPECT_FALSE(is_finite(v));
  }
}

}  // namespace
}  // namespace taxel
