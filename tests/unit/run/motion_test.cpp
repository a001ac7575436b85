// Motions of the finger in scenarios: closed forms of the poses of each kind.
#include "core/run/motion/motion.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/document/paper_setting.h"
#include "core/mesh/make/primitives.h"

namespace taxel {
namespace {

constexpr double kRadius = 0.008, kHalf = 0.012;
constexpr int kSides = 360;
const Aabb kObject{{0, -0.025, 0}, {0.05, 0.025, 0.05}};

/// Returns a cylinder of many sides along `distal` (x of its mesh) with the width axis y.
TriMesh finger() {
  std::vector<dvec3> vertices;
  std::vector<ivec3> faces;
  for (int i = 0; i < kSides; ++i) {
    const double a = 2 * kPi * i / kSides;
    for (const double y : {-kHalf, kHalf}) vertices.emplace_back(kRadius * std::sin(a), y, -kRadius * std::cos(a));
  }
  for (int i = 0; i < kSides; ++i) {
    const int j = (i + 1) % kSides;
    faces.emplace_back(2 * i, 2 * i + 1, 2 * j);
    faces.emplace_back(2 * j, 2 * i + 1, 2 * j + 1);
  }
  return TriMesh(vertices, faces);
}
const SensorFrame kFrame{{1, 0, 0}, {0, 0, -1}};

Scenario of_kind(ScenarioKind kind) {
  Scenario scenario = default_scenario(kind);
  if (double* tilt = find_number(scenario, "tilt_deg")) *tilt = 0;
  return scenario;
}

double lowest(const TriMesh& skin, const Pose& X_WM) {
  double z = 1;
  for (const dvec3& v : skin.vertices()) z = std::min(z, (X_WM * v).z);
  return z;
}

std::uint64_t step_at(const Motion& motion, double seconds) {
  return static_cast<std::uint64_t>(std::lround(seconds / motion.timestep));
}

TEST(Motion, PressesToTheDepthRestsAndRises) {
  const TriMesh skin = finger();
  Scenario scenario = of_kind(kKind<scenarios::Press>);
  auto& press = scenario.as<scenarios::Press>();
  press.depth = 0.002;
  press.clearance = 0.0015;
  press.speed = 0.02;
  press.hold = 0.1;
  press.place = -0.01;
  const Motion motion = make_motion(skin, kFrame, scenario, kObject);
  const double down = 0.0035 / 0.02;
  EXPECT_EQ(motion.last_step, step_at(motion, 2 * down + 0.1));
  EXPECT_NEAR(lowest(skin, motion.pose(0)), 0.0515, 1e-12);
  EXPECT_NEAR((motion.pose(0) * motion.lead_M).x, 0.015, 1e-12);
  for (const double t : {0.175, 0.2, 0.275}) EXPECT_NEAR(lowest(skin, motion.pose(step_at(motion, t))), 0.048, 1e-12);
  EXPECT_NEAR(lowest(skin, motion.pose(step_at(motion, 0.1))), 0.0515 - 0.1 * 0.02, 1e-12);
  EXPECT_NEAR(lowest(skin, motion.pose(motion.last_step)), 0.0515, 1e-12);
  ASSERT_EQ(motion.way_points.size(), 4U);
  for (const WayPoint& point : motion.way_points)
    EXPECT_LT(glm::distance(point.X_WM.p, motion.pose(step_at(motion, point.time)).p), 1e-12);
}

TEST(Motion, RollsByRadiusTimesAngleWithoutSlipping) {
  const TriMesh skin = finger();
  for (const double angle : {75.0, -75.0, 400.0}) {
    Scenario scenario = of_kind(kKind<scenarios::Roll>);
    auto& roll = scenario.as<scenarios::Roll>();
    roll.angle_deg = angle;
    roll.hold = 0;
    const Motion motion = make_motion(skin, kFrame, scenario, kObject);
    const double down = (roll.clearance + roll.depth) / roll.speed;
    const Pose before = motion.pose(step_at(motion, down));
    const Pose after = motion.pose(step_at(motion, down + std::abs(angle) / roll.rate_deg));
    // The axis travels R times the angle, like an inscribed circle of 360 sides.
    const double travelled = after.p.x - before.p.x;
    EXPECT_NEAR(travelled, kRadius * angle * kPi / 180, 2e-4 * std::abs(travelled));
    EXPECT_NEAR(after.p.y, before.p.y, 1e-15);
    // The point of contact is at rest.
    for (std::uint64_t step = step_at(motion, down); step < step_at(motion, down + 1); ++step) {
      const Pose a = motion.pose(step), b = motion.pose(step + 1);
      EXPECT_NEAR(lowest(skin, a), 0.05 - roll.depth, 1e-12);
      const dvec3 contact(a.p.x, a.p.y, 0.05 - roll.depth);
      const double slip = glm::distance(b * (a.inverse() * contact), contact);
      // Within half a side of the vertex about which it rotates.
      EXPECT_LT(slip, 0.02 * glm::distance(a.p, b.p)) << step;
    }
    EXPECT_LT(glm::distance(motion.pose(motion.last_step).p, motion.X_start.p), 1e-12);  // back at the start
  }
}

TEST(Motion, RollsASquareOverItsCorners) {
  const TriMesh box = make_box({0.5, 2, 0.5});
  const RollingOutline outline(box, {1, 0, 0, 0});
  const auto x = [&](double degrees) { return outline.at(degrees * kPi / 180).travelled; };
  const double start = x(1e-6);  // either of the lower corners may be first
  EXPECT_NEAR(x(89) - start, 0, 1e-15);
  EXPECT_NEAR(x(91) - start, 1, 1e-15);
  EXPECT_NEAR(x(361) - start, 4, 1e-15);
  EXPECT_NEAR(x(-91) - x(-1e-6), -1, 1e-15);
}

TEST(Motion, TwistsAboutThePadsNormalThroughTheLowestPoint) {
  const TriMesh skin = finger();
  Scenario scenario = of_kind(kKind<scenarios::Twist>);
  auto& twist = scenario.as<scenarios::Twist>();
  twist.angle_deg = 40;
  twist.tilt_deg = 20;
  const Motion motion = make_motion(skin, kFrame, scenario, kObject);
  const double down = (twist.clearance + twist.depth) / twist.speed, turning = 40 / 60.0;
  const Pose before = motion.pose(step_at(motion, down));
  dvec3 pivot_M(0);
  for (const dvec3& v : skin.vertices())
    if ((before * v).z < (before * pivot_M).z - 1e-12) pivot_M = v;
  const dvec3 pad = before.rotate(kFrame.pad);
  for (double t = 0; t < turning; t += 0.05) {
    const Pose X = motion.pose(step_at(motion, down + t));
    EXPECT_LT(glm::distance(X * pivot_M, before * pivot_M), 1e-12);
    EXPECT_LT(glm::distance(X.rotate(kFrame.pad), pad), 1e-12);
  }
  const Pose after = motion.pose(step_at(motion, down + turning + 0.1));
  EXPECT_NEAR(glm::dot(after.rotate(kFrame.distal), before.rotate(kFrame.distal)), std::cos(40 * kPi / 180), 1e-9);
}

TEST(Motion, SlidesThereAndBack) {
  const TriMesh skin = finger();
  Scenario scenario = of_kind(kKind<scenarios::Slide>);
  auto& slide = scenario.as<scenarios::Slide>();
  slide.direction_deg = 30;
  slide.hold = 0;
  const Motion motion = make_motion(skin, kFrame, scenario, kObject);
  const double down = (slide.clearance + slide.depth) / slide.speed, way = slide.distance / slide.speed;
  const Pose to = motion.pose(step_at(motion, down + way)), from = motion.pose(step_at(motion, down));
  EXPECT_LT(glm::distance(to.p - from.p, 0.01 * dvec3(std::cos(kPi / 6), 0.5, 0)), 1e-12);
  EXPECT_LT(glm::distance(motion.pose(step_at(motion, down + 2 * way)).p, from.p), 1e-12);
  EXPECT_NEAR(lowest(skin, to), 0.05 - slide.depth, 1e-12);
}

TEST(Motion, PrescribesNoMotionForADrop) {
  const TriMesh skin = finger();
  const Motion motion = make_motion(skin, kFrame, of_kind(kKind<scenarios::Drop>), kObject);
  EXPECT_FALSE(motion.pose);
  EXPECT_NEAR(lowest(skin, motion.X_start), 0.06, 1e-12);
  EXPECT_EQ(motion.last_step, 500U);
}

TEST(Motion, RecordsRowsAtUniformTimes) {
  Scenario scenario = of_kind(kKind<scenarios::Press>);
  auto& press = scenario.as<scenarios::Press>();
  press.record_interval = 0.0025;
  const Motion motion = make_motion(finger(), kFrame, scenario, kObject);
  std::vector<std::uint64_t> rows;
  for (std::uint64_t step = 0; step < 12; ++step)
    if (motion.row_due(step)) rows.push_back(step);
  EXPECT_EQ(rows, (std::vector<std::uint64_t>{0, 3, 5, 8, 10}));
  EXPECT_FALSE(motion.row_due(motion.last_step + 5));
}

/// Returns the largest height of the finger's vertices above the upright edge's surface, at most 0. A value below 0
/// means that the finger is clear of the edge.
double deepest_in_edge(const TriMesh& skin, const Pose& X_WM, const Scenario& scenario) {
  const double r = scenario.edge_radius, center_z = scenario.box_size * std::sqrt(2.0) - std::sqrt(2.0) * r;
  double deepest = -1;
  for (const dvec3& v : skin.vertices()) {
    const dvec3 p = X_WM * v - dvec3(0, 0, center_z);
    // Distance from the centre of the rounding along a side.
    const double side = (std::abs(p.x) + p.z) / std::sqrt(2.0);
    const bool above_round = p.z > std::abs(p.x);
    deepest = std::max(deepest, r - (above_round ? std::hypot(p.x, p.z) : side));
  }
  return deepest;
}

Aabb edge_bounds(const Scenario& scenario) {
  return make_upright_edge(scenario.box_size, scenario.edge_radius).bounds();
}

TEST(Motion, SweepsOverAnEdgeFromClearToClear) {
  const TriMesh skin = finger();
  for (const double tilt : {-60.0, 0.0, 45.0, 80.0}) {
    for (const double depth : {0.0005, 0.0015, 0.01}) {
      Scenario scenario;
      auto& sweep = scenario.as<scenarios::Sweep>();
      sweep.tilt_deg = tilt;
      sweep.depth = depth;
      sweep.before = sweep.past = 0;  // as near as the finger is clear
      const Aabb object = edge_bounds(scenario);
      const Motion motion = make_motion(skin, kFrame, scenario, object);
      EXPECT_NEAR(lowest(skin, motion.X_start), object.hi.z - depth, 1e-12);
      for (const std::uint64_t step : {std::uint64_t{0}, motion.last_step})
        EXPECT_LT(deepest_in_edge(skin, motion.pose(step), scenario), -0.0005) << tilt << " deg, " << depth;
      EXPECT_GT(deepest_in_edge(skin, motion.pose(motion.last_step / 2), scenario), 0.2 * depth) << tilt << " deg";
    }
  }
}

/// A pyramid on its apex, steeper toward +x than toward -x. Only the apex is below the crest, so the distances are
/// found where the edges of the pyramid pass the crest.
TEST(Motion, ConsidersFacesThatPassTheCrestForTheClearReach) {
  const double forward = 3, backward = 2;  // per height, for edges in the plane y = 0
  const TriMesh pyramid({{0, 0, 0}, {forward, 0, 1}, {0, 1, 1}, {-backward, 0, 1}, {0, -1, 1}},
                        {{0, 2, 1}, {0, 3, 2}, {0, 4, 3}, {0, 1, 4}, {1, 2, 3}, {1, 3, 4}});
  const double crest = 0.01, round = 0.0004;
  const dvec2 reach = clear_reach(pyramid, Pose{}, crest, round);
  EXPECT_NEAR(reach[0], forward * crest + crest + round, 1e-15);
  EXPECT_NEAR(reach[1], backward * crest + crest + round, 1e-15);
}

TEST(Motion, SweepsOverAnEdgeByALongerRequestedWay) {
  const TriMesh skin = finger();
  const Scenario scenario;
  const Motion motion = make_motion(skin, kFrame, scenario, edge_bounds(scenario));
  EXPECT_NEAR((motion.pose(0) * motion.lead_M).x, -0.025, 1e-12);
  EXPECT_NEAR((motion.pose(motion.last_step) * motion.lead_M).x, 0.025, 1e-12);
  EXPECT_EQ(motion.last_step, 5000U);
}

TEST(UprightEdge, IsAClosedBoxWithARoundedTop) {
  const double size = 0.05, r = 0.001, top = size * std::sqrt(2.0);
  const TriMesh mesh = make_upright_edge(size, r);
  EXPECT_TRUE(mesh.closed());
  const double missing = (1 - kPi / 4) * r * r * size;  // between the corner of the square and the arc
  EXPECT_NEAR(mesh.volume(), size * size * size - missing, 1e-3 * missing);
  EXPECT_NEAR(mesh.bounds().hi.z, top - height_of_round(r), 2e-3 * r);
  EXPECT_NEAR(mesh.bounds().lo.z, 0, 1e-15);
  EXPECT_NEAR(mesh.bounds().hi.x, size / std::sqrt(2.0), 1e-15);
  EXPECT_NEAR(mesh.bounds().lo.x, -size / std::sqrt(2.0), 1e-15);
  EXPECT_NEAR(mesh.bounds().extent().y, size, 1e-15);
}

// The distances from the axis of the round, along each strip: at most 2e-3 of the radius off, and not in the mean.
TEST(UprightEdge, HasAMeanRadiusOfThatOfItsRound) {
  const double size = 0.05, r = 0.001, top = size * std::sqrt(2.0);
  const TriMesh mesh = make_upright_edge(size, r);
  const dvec2 center(0, top - std::sqrt(2.0) * r);
  double sum = 0, largest = 0, angles = 0;
  for (int f = 0; f < mesh.face_count(); ++f)
    for (int i = 0; i < 3; ++i) {  // the edges of strips at right angles to y
      const dvec3 &a = mesh.vertex(f, i), &b = mesh.vertex(f, (i + 1) % 3);
      const dvec2 from = dvec2(a.x, a.z) - center, to = dvec2(b.x, b.z) - center;
      const bool on_round = glm::length(from) < 1.01 * r && glm::length(to) < 1.01 * r;
      if (!on_round || a.y != b.y || a.x == b.x || std::abs(mesh.face_normals()[static_cast<std::size_t>(f)].y) > 0.5)
        continue;
      const double turn = std::acos(glm::dot(glm::normalize(from), glm::normalize(to)));
      const double step = turn / 1000;
      for (int k = 0; k < 1000; ++k) {
        const double along = (std::tan((k + 0.5) * step - 0.5 * turn) / std::tan(0.5 * turn) + 1) / 2;
        const double off = glm::length(from + along * (to - from)) / r - 1;
        sum += off * step;
        largest = std::max(largest, std::abs(off));
      }
      angles += turn;
    }
  EXPECT_GT(angles, 2 * 0.9 * kPi / 2) << "both ends";
  EXPECT_LT(std::abs(sum / angles), 2e-5);
  EXPECT_LT(largest, 2e-3);
}

/// Returns X_WM of the released demo at s = pi t / 25 s.
Pose released_pose(double time) {
  const double s = std::sin(kPi * time / 25);
  return {glm::normalize(dquat(0.271, 0.653, 0.653, 0.271)), {-0.02 + 0.025 * s, 0, 0.07 - 0.012 * s}};
}

TEST(PaperDemo, MovesAFingerInThePapersFrameAsReleased) {
  const TriMesh skin = finger();
  const SensorFrame paper_frame{{0, 0, 1}, {0, -1, 0}};
  const Motion motion = make_motion(skin, paper_frame, default_scenario(kKind<scenarios::Paper>), kDemoBox);
  EXPECT_EQ(motion.last_step, 25000U);
  for (const std::uint64_t step : {0U, 5000U, 12500U, 20000U, 25000U}) {
    const Pose X = motion.pose(step), released = released_pose(static_cast<double>(step) * 1e-3);
    EXPECT_LT(glm::distance(X.p - motion.X_start.p, released.p - released_pose(0).p), 1e-15);
    EXPECT_LT(glm::length(X.q - released.q), 1e-15);
    // The lowest point goes 23.4 mm below the released origin.
    EXPECT_NEAR(lowest(skin, X), released.p.z - 0.0234081, 1e-7);
  }
}

TEST(PaperDemo, RotatesAnyFingerLikeThePapers) {
  const TriMesh skin = finger();
  const Motion motion = make_motion(skin, kFrame, default_scenario(kKind<scenarios::Paper>), kDemoBox);
  const Pose released = released_pose(0);
  EXPECT_LT(glm::distance(motion.X_start.rotate(kFrame.distal), released.rotate({0, 0, 1})), 1e-15);
  EXPECT_LT(glm::distance(motion.X_start.rotate(kFrame.pad), released.rotate({0, -1, 0})), 1e-15);
  EXPECT_NEAR(lowest(skin, motion.pose(12500)), 0.0345919, 1e-7);  // 3.4 mm below the box's top
}

TEST(PaperDemo, RecordsEveryStepAndTheTravelThereAndBack) {
  const Motion motion = make_motion(finger(), kFrame, default_scenario(kKind<scenarios::Paper>), kDemoBox);
  const double way = std::hypot(0.025, 0.012);
  EXPECT_NEAR(motion.travel(12500), way, 1e-15);
  EXPECT_NEAR(motion.travel(25000), 2 * way, 1e-15);
  int rows = 0;
  for (std::uint64_t step = 0; step <= motion.last_step; ++step) rows += motion.row_due(step);
  EXPECT_EQ(rows, 1001);
}

TEST(Motion, RefusesMotionsThatNeverEnd) {
  Scenario scenario = of_kind(kKind<scenarios::Press>);
  auto& press = scenario.as<scenarios::Press>();
  press.hold = 1e300;
  EXPECT_THROW(make_motion(finger(), kFrame, scenario, kObject), Error);
}

}  // namespace
}  // namespace taxel
