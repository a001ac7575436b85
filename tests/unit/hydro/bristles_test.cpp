// Bristles of a ball on a plane and of a block, compared with the closed forms of the brush model.
#include "core/hydro/bristles.h"

#include <gtest/gtest.h>

#include <numeric>

#include "core/base/error.h"
#include "core/base/rng.h"
#include "fixtures/hydro_bodies.h"

namespace taxel {
namespace {

constexpr double kBallModulus = 5e4, kFriction = 0.5;

/// A soft ball that is pressed on a plane, with its bristles.
struct BallOnPlane {
  double R = 0.02, depth = 0.003;
  double k = 2e8;  ///< [Pa/m]
  BristleSearch search;
  ContactSurface surface;
  BristleContact contact;
  double sticking = 0;  ///< area that stuck in the last move [m^2]

  explicit BallOnPlane(int count = 8000) : search(nullptr) {
    const HydroBodyPtr ball = make_simple_body(ShapeType::sphere, dvec3(R), soft_material(kBallModulus), 0.0012);
    const HydroBodyPtr floor = make_simple_body(ShapeType::plane, dvec3(0));
    search = BristleSearch(std::make_shared<const BristleSkin>(*std::get<SoftBody>(ball->geometry).field, count));
    surface = touch(*ball, *floor, at_height(R - depth), Pose{}).surface;
    contact.assign(surface, search);
  }
  [[nodiscard]] BristleLaw law() const { return {k, {0, kFriction}, 1, 0}; }
  [[nodiscard]] double center_height() const { return R - depth; }
  [[nodiscard]] double largest_pressure() const { return kBallModulus * depth / R; }
  /// Moves the ball by dx and lets its bristles slip. Returns the friction.
  double move(double dx) {
    double force = 0;
    sticking = 0;
    const Twist V{{dx, 0, 0}, {0, 0, 0}};
    for (Bristle& b : contact.bristles()) {
      const BristleAnswer answer = answer_of(b, law(), V);
      b.u = answer.u + dvec3(dx, 0, 0) - glm::dot(dvec3(dx, 0, 0), b.normal) * b.normal;
      force += answer.force.x;
      if (!answer.slips) sticking += b.area;
    }
    return force;
  }
  /// Radius within which k u < mu p, p = E (1 - r/R).
  [[nodiscard]] double sticking_radius(double u) const {
    const double r = R * (1 - k * u / (kFriction * kBallModulus));
    return std::sqrt(std::max(0.0, r * r - center_height() * center_height()));
  }
  /// Friction after a first displacement u: k u on the sticking disc and mu p on the ring around it.
  [[nodiscard]] double friction(double u) const {
    const double h2 = center_height() * center_height();
    const auto load = [&](double rho) {
      return 2 * kPi * kBallModulus * (0.5 * rho * rho - std::pow(h2 + rho * rho, 1.5) / (3 * R));
    };
    const double c = sticking_radius(u), a = std::sqrt(R * R - h2);
    return k * u * kPi * c * c + kFriction * (load(a) - load(c));
  }
};

TEST(BristleSkin, SpreadsRootsEvenly) {
  const HydroBodyPtr ball = make_simple_body(ShapeType::sphere, dvec3(0.02), soft_material(kBallModulus), 0.002);
  const BristleSkin skin(*std::get<SoftBody>(ball->geometry).field, 1000);
  ASSERT_EQ(skin.roots().size(), 1000U);
  // Discs of the densest packing have the distance sqrt(2/sqrt(3) area/n); farthest points reach two thirds of it.
  const double densest = std::sqrt(2 / std::sqrt(3.0) * 4 * kPi * 0.02 * 0.02 / 1000);
  EXPECT_GT(skin.spacing(), 0.66 * densest);
  EXPECT_LT(skin.spacing(), densest);
  for (std::size_t i = 0; i < skin.roots().size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      ASSERT_GE(glm::length(skin.roots()[i] - skin.roots()[j]), skin.spacing() * (1 - 1e-12));
}

// Each root is the farthest point of the skin from those before it. So the distance of a root from those before it
// never grows, and the last of these distances is at least the spacing that is left.
TEST(BristleSkin, ChoosesTheFarthestPointEachTime) {
  const HydroBodyPtr ball = make_simple_body(ShapeType::sphere, dvec3(0.02), soft_material(kBallModulus), 0.002);
  const BristleSkin skin(*std::get<SoftBody>(ball->geometry).field, 3000);
  double last = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < skin.roots().size(); ++i) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < i; ++k) nearest = std::min(nearest, glm::distance(skin.roots()[i], skin.roots()[k]));
    ASSERT_LE(nearest, last * (1 + 1e-12)) << i;
    last = nearest;
  }
  EXPECT_LE(skin.spacing(), last);
  EXPECT_GT(skin.spacing(), 0.99 * last);
}

TEST(BristleSkin, ErrorNamesAWrongCount) {
  const HydroBodyPtr ball = make_simple_body(ShapeType::sphere, dvec3(0.02), soft_material(kBallModulus), 0.01);
  try {
    const BristleSkin skin(*std::get<SoftBody>(ball->geometry).field, 0);
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("at least 1, is 0"), std::string::npos) << error.what();
  }
}

TEST(BristleSearch, GivesContinuousSharesThatAddUpToOne) {
  const HydroBodyPtr ball = make_simple_body(ShapeType::sphere, dvec3(0.02), soft_material(kBallModulus), 0.002);
  const auto skin = std::make_shared<const BristleSkin>(*std::get<SoftBody>(ball->geometry).field, 500);
  BristleSearch search(skin);
  std::vector<double> before(500, 0.0);
  const double step = 1e-3 * skin->spacing();
  for (int n = 0; n < 4000; ++n) {
    std::vector<double> parts(500, 0.0);
    for (const BristleShare& share : search.shares({-0.01 + n * step, 0.004, -0.015})) {
      EXPECT_GT(share.part, 0);
      parts[static_cast<std::size_t>(share.root)] = share.part;
    }
    EXPECT_NEAR(std::accumulate(parts.begin(), parts.end(), 0.0), 1, 1e-12);
    for (std::size_t i = 0; n > 0 && i < parts.size(); ++i) EXPECT_NEAR(parts[i], before[i], 0.02) << n;
    before = parts;
  }
}

// (1 - (d_i^2 - d^2)/s^2)^2 with d = 1, s = 2: 1 for the nearest root, 1/4 at d_i^2 = 3, 0 from d_i^2 = 5 on.
TEST(BristleSearch, SharesByTheSquareOfTheBracket) {
  EXPECT_EQ(share_of(1, 1, 2), 1);
  EXPECT_EQ(share_of(3, 1, 2), 0.25);
  EXPECT_EQ(share_of(5, 1, 2), 0);
  EXPECT_EQ(share_of(6, 1, 2), 0);
}

// The shares of random points, also far below the skin, are those of a sum over all roots.
TEST(BristleSearch, FindsEveryRootWithAShare) {
  const HydroBodyPtr box = make_mesh_body(make_box({0.03, 0.02, 0.01}), soft_material(kBallModulus, 0.005));
  const auto skin = std::make_shared<const BristleSkin>(*std::get<SoftBody>(box->geometry).field, 400);
  BristleSearch search(skin);
  const CounterRng random(3);
  for (std::uint64_t n = 0; n < 1500; ++n) {
    const dvec3 place(random.uniform(3 * n) - 0.5, random.uniform(3 * n + 1) - 0.5, random.uniform(3 * n + 2) - 0.5);
    const dvec3 x = place * dvec3(0.06, 0.04, 0.02);
    double least = std::numeric_limits<double>::infinity(), sum = 0;
    const auto squared = [&](const dvec3& root) { return glm::dot(root - x, root - x); };
    for (const dvec3& root : skin->roots()) least = std::min(least, squared(root));
    std::vector<double> parts;
    for (const dvec3& root : skin->roots()) sum += parts.emplace_back(share_of(squared(root), least, skin->reach()));
    std::vector<double> found(parts.size(), 0.0);
    for (const BristleShare& share : search.shares(x)) found[static_cast<std::size_t>(share.root)] = share.part;
    for (std::size_t i = 0; i < parts.size(); ++i) ASSERT_NEAR(found[i], parts[i] / sum, 1e-12) << n;
  }
}

TEST(Bristles, BearTheAreaAndTheForceOfTheSurface) {
  const BallOnPlane ball;
  double area = 0, push = 0;
  for (const Bristle& b : ball.contact.bristles()) {
    area += b.area;
    push += b.push;
    const dvec3& root = ball.search.skin().roots()[static_cast<std::size_t>(b.root)];
    EXPECT_NEAR(b.x.x, root.x, 1e-12) << "the root, moved along the normal";
    EXPECT_NEAR(b.x.y, root.y, 1e-12);
    EXPECT_NEAR(b.x.z, -ball.center_height(), 1e-12);
    EXPECT_NEAR(glm::length(b.normal), 1, 1e-12);
  }
  EXPECT_NEAR(area, ball.surface.area(), 1e-12 * area);
  EXPECT_NEAR(push, pressure_wrench(ball.surface).force.z, 1e-12 * push);
}

// Cattaneo's problem in the brush model: each point sticks while k u < mu p.
TEST(Bristles, StickWithinTheRadiusOfTheClosedForm) {
  BallOnPlane ball;
  const double full = kFriction * ball.largest_pressure() / ball.k, du = full / 50;  // all slips at u = full
  const double a = ball.sticking_radius(0);
  for (int n = 1; n < 50; ++n) {
    const double friction = -ball.move(du), u = n * du;
    const double c = std::sqrt(ball.sticking / kPi), exact = ball.sticking_radius(u);
    EXPECT_NEAR(c, exact, 0.02 * a) << n;
    if (exact > 0.5 * a) {
      EXPECT_NEAR(c, exact, 0.02 * exact) << n;
    }
    EXPECT_NEAR(friction, ball.friction(u), 0.005 * ball.friction(full)) << n;
  }
}

// Masing (1926): each branch of the loop is the first loading, scaled by two, from where the motion turned.
TEST(Bristles, FollowTheHysteresisLoopOfTheClosedForm) {
  BallOnPlane ball;
  const double full = kFriction * ball.largest_pressure() / ball.k, U = 0.7 * full, du = U / 100;
  const double top = ball.friction(U);
  double u = 0, work = 0, exact_work = 0, before = 0;
  const auto go = [&](double step, int count, const auto& exact) {
    for (int n = 0; n < count; ++n) {
      const double friction = -ball.move(step);
      u += step;
      EXPECT_NEAR(friction, exact(u), 0.02 * top) << u / full;
      work += 0.5 * (before + friction) * step;
      exact_work += exact(u - 0.5 * step) * step;
      before = friction;
    }
  };
  go(du, 100, [&](double at) { return ball.friction(at); });
  work = exact_work = 0;
  go(-du, 200, [&](double at) { return top - 2 * ball.friction(0.5 * (U - at)); });
  go(du, 200, [&](double at) { return 2 * ball.friction(0.5 * (U + at)) - top; });
  double first = 0;  // integral of the first loading
  for (int n = 0; n < 1000; ++n) first += ball.friction((n + 0.5) * U / 1000) * U / 1000;
  const double loop = 8 * (first - 0.5 * U * top);
  EXPECT_NEAR(work, loop, 0.02 * loop);
  EXPECT_NEAR(exact_work, loop, 0.002 * loop);
}

TEST(Bristles, HoldAtMostTheCoulombForceAndKeepTheirDeflection) {
  BallOnPlane ball;
  const double full = kFriction * ball.largest_pressure() / ball.k;
  const double load = pressure_wrench(ball.surface).force.z;
  for (int n = 0; n < 200; ++n) ball.move(0.1 * full);
  EXPECT_NEAR(-ball.move(0.1 * full), kFriction * load, 1e-12 * load);
  // At rest the friction remains, in contrast to regularised friction.
  EXPECT_NEAR(-ball.move(0), kFriction * load, 1e-12 * load);
}

TEST(Bristles, HaveASecantThatGivesTheirForces) {
  BallOnPlane ball(1000);
  ball.move(2e-7);
  const Twist V{{3e-8, -4e-8, 1e-8}, {2e-6, 1e-6, -3e-6}};
  const BristleLaw law{ball.k, {0.3, kFriction}, 0.5, 0.1};
  Traction sum;
  ball.contact.add_friction(law, V, sum);
  Wrench direct;
  for (const Bristle& b : ball.contact.bristles()) {
    const BristleAnswer answer = answer_of(b, law, V);
    direct.force += answer.force;
    direct.torque += glm::cross(b.x, answer.force);
  }
  EXPECT_LE(glm::length(sum.wrench.force - direct.force), 1e-12 * glm::length(direct.force));
  EXPECT_LE(glm::length(sum.wrench.torque - direct.torque), 1e-12 * glm::length(direct.torque));
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < 6; ++j)
      EXPECT_NEAR(sum.secant[i][j], sum.secant[j][i], 1e-12 * (sum.secant[i][i] + sum.secant[j][j]));
}

/// Returns a bristle on a horizontal surface with an area of 1 cm^2 and a push of 2 N.
Bristle one_bristle() {
  Bristle b;
  b.area = 1e-4;
  b.push = 2;
  b.normal = {0, 0, 1};
  return b;
}

// The limit is mu push (1 - d vn)+: 0.4 x 2 N x (1 - 0.5 vn), and 0 where the bodies part faster than 2 m/s.
TEST(Bristles, SlipAtTheCoulombLimitOfTheDampedPush) {
  const BristleLaw law{1e9, {0.5, 0.4}, 1e-3, 0};
  for (const auto& [vn, limit] : {std::pair(0.0, 0.8), {-0.8, 1.12}, {0.8, 0.48}, {2.0, 0.0}, {3.0, 0.0}}) {
    const BristleAnswer answer = answer_of(one_bristle(), law, {{1, 0, vn}, {0, 0, 0}});
    EXPECT_TRUE(answer.slips) << vn;
    EXPECT_NEAR(answer.force.x, -limit, 1e-12) << vn;
    EXPECT_EQ(answer.force.y, 0) << vn;
  }
}

// k area = 100 N/m, and the limit of 0.1 N holds at a deflection of 1 mm. With h = T = 1 ms the element's force is
// k area (u1 + (u1 - u)), where u1 is the deflection at the end of the step: u = 0.5 mm gives u1 = (1 + 0.5)/2 mm. The
// tip has moved by h v = 1 mm, so the deflection at the present pose is 0.75 mm - 1 mm. Without damping u1 = 1 mm, and
// a bristle that sticks keeps its deflection.
TEST(Bristles, KeepAPartOfTheirBendWhileTheySlip) {
  Bristle b = one_bristle();
  b.u = {0.5e-3, 0, 0};
  BristleLaw law{1e6, {0, 0.05}, 1e-3, 1e-3};
  const Twist V{{1, 0, 0}, {0, 0, 0}};
  const BristleAnswer damped = answer_of(b, law, V);
  EXPECT_TRUE(damped.slips);
  EXPECT_NEAR(damped.force.x, -0.1, 1e-12);
  EXPECT_NEAR(damped.u.x, -0.25e-3, 1e-15);
  law.time = 0;
  EXPECT_NEAR(answer_of(b, law, V).u.x, 0, 1e-15);
  const BristleAnswer sticks = answer_of(b, law, {{0.1, 0, 0}, {0, 0, 0}});
  EXPECT_FALSE(sticks.slips);
  EXPECT_NEAR(sticks.force.x, -0.06, 1e-12);
  EXPECT_EQ(sticks.u, b.u);
}

// A is turned by 90 degrees about z and moved by 5 m along z to become B: x becomes y. Action and reaction are opposed.
TEST(StickingFriction, IsMirroredInTheOppositeDirection) {
  StickingFriction on_A;
  on_A.reach = 0.5;
  on_A.roots = {{{1, 0, 0}, {0, 0, 1}, 2.0, {3, 0, -1}, true}, {{-1, 0, 0}, {1, 0, 0}, 1.0, {0, 7, 0}, false}};
  const double half = std::sqrt(0.5);
  const StickingFriction on_B = mirrored(on_A, RigidTransform(Pose{dquat(half, 0, 0, half), dvec3(0, 0, 5)}));
  const auto expect_near = [](const dvec3& is, const dvec3& wanted) { EXPECT_LT(glm::distance(is, wanted), 1e-14); };
  ASSERT_EQ(on_B.roots.size(), 2U);
  expect_near(on_B.roots[0].place, {0, 1, 5});
  expect_near(on_B.roots[0].normal, {0, 0, -1});
  expect_near(on_B.roots[0].traction, {0, -3, 1});
  expect_near(on_B.roots[1].normal, {0, -1, 0});
  expect_near(on_B.roots[1].traction, {7, 0, 0});
  EXPECT_EQ(on_B.roots[0].area, 2.0);
  expect_near(on_B.traction_at({0, 1, 5}), {0, -3, 1});
  EXPECT_EQ(on_B.slip_at({0, 1, 5}), 1);
  EXPECT_EQ(on_B.slip_at({0, -1, 5}), 0);
}

// Two bristles of 2 cm^2 and 1 cm^2, of which the second one slips. The traction is the force divided by the area: k u
// = 100 Pa where the first one sticks, and mu push / area = 0.1 N / 1 cm^2 where the second one slips.
TEST(StickingFriction, IsTheForceOfEachBristleOnItsArea) {
  const HydroBodyPtr box = make_mesh_body(make_box({0.03, 0.03, 0.01}), soft_material(kBallModulus, 0.005));
  const BristleSkin skin(*std::get<SoftBody>(box->geometry).field, 2);
  BristleContact contact;
  contact.bristles() = {one_bristle(), one_bristle()};
  contact.bristles()[0].area = 2e-4;
  contact.bristles()[1].root = 1;
  contact.bristles()[0].u = {1e-4, 0, 0};
  contact.bristles()[1].u = {0, 5e-3, 0};
  const StickingFriction friction = sticking_friction(contact, skin, {1e6, {0, 0.05}, 0, 0}, Twist{});
  ASSERT_EQ(friction.roots.size(), 2U);
  EXPECT_NEAR(friction.roots[0].traction.x, -100, 1e-9);
  EXPECT_NEAR(friction.roots[1].traction.y, -1000, 1e-9);
  EXPECT_NEAR(friction.traction_at(skin.roots()[0]).x, -100, 1e-9);
  EXPECT_EQ(friction.slip_at(skin.roots()[0]), 0);
  EXPECT_EQ(friction.slip_at(skin.roots()[1]), 1);
}

// Work of the friction over a cycle of random motions is never negative.
TEST(Bristles, NeverReturnMoreWorkThanTheyStored) {
  BallOnPlane ball(2000);
  const double full = kFriction * ball.largest_pressure() / ball.k;
  CounterRng random(5);
  double work = 0;
  for (std::uint64_t n = 0; n < 500; ++n) {
    const double dx = full * (random.uniform(n) - 0.5);
    work -= ball.move(dx) * dx;
    double stored = 0;
    for (const Bristle& b : ball.contact.bristles()) stored += 0.5 * ball.k * b.area * glm::dot(b.u, b.u);
    EXPECT_GE(work, stored * (1 - 1e-9)) << n;
  }
}

}  // namespace
}  // namespace taxel
