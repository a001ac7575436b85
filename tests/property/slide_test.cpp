// Slides in small steps over edges, face boundaries and vertices: the contact changes without jumps.
#include <gtest/gtest.h>

#include <functional>
#include <set>

#include "core/hydro/intersect.h"
#include "fixtures/hydro_bodies.h"

namespace taxel {
namespace {

constexpr double kStep = 1e-5;  // 10 micrometres
constexpr double kTop = 0.03;   // height of the top of the crates below [m]

/// A slide of A past B, which rests.
struct Slide {
  const char* name;
  std::function<HydroBodyPtr()> a, b;
  Pose X_WA;                               ///< pose of A; p is A's lowest point at the middle of the slide
  dvec3 direction_W;                       ///< direction of the slide, of any length
  bool even = false;                       ///< B is a plane wherever A touches it
  double top = kTop;                       ///< height of B's highest point [m]
  double depth = 0.001, distance = 0.012;  ///< depth of A in B, and length of the slide [m]
};

std::ostream& operator<<(std::ostream& out, const Slide& slide) {
  return out << slide.name;
}

HydroBodyPtr soft_ball() {
  return make_simple_body(ShapeType::sphere, dvec3(0.02, 0, 0), soft_material(5e4));
}
HydroBodyPtr soft_block() {
  return make_simple_body(ShapeType::box, dvec3(0.012, 0.015, 0.01), soft_material(5e4));
}
HydroBodyPtr pad_finger() {
  return make_mesh_body(make_fingertip(), soft_material(5e4, 0.002));
}
HydroBodyPtr soft_crate() {
  return make_simple_body(ShapeType::box, dvec3(0.03), soft_material(2e5));
}
/// Returns a box whose top is the plane z = 0.03. The edges of the top are at x, y = +-0.03, and a diagonal divides the
/// top into two triangles.
HydroBodyPtr crate() {
  return make_simple_body(ShapeType::box, dvec3(0.03));
}
HydroBodyPtr rigid_ball() {
  return make_simple_body(ShapeType::sphere, dvec3(0.02, 0, 0), {}, 0.003);
}

Pose tilted(double degrees_x, double degrees_z, const dvec3& p) {
  const double degree = kPi / 180;
  return {glm::angleAxis(degrees_z * degree, dvec3(0, 0, 1)) * glm::angleAxis(degrees_x * degree, dvec3(1, 0, 0)), p};
}

/// Moves the body so that its lowest point is above p and `depth` below z = top.
Pose pressed(const HydroBody& body, Pose X_WA, double depth, double top) {
  const auto* soft = std::get_if<SoftBody>(&body.geometry);
  const auto& vertices =
      soft != nullptr ? soft->field->vertices() : std::get<RigidMesh>(body.geometry).index->mesh().vertices();
  dvec3 lowest(0, 0, std::numeric_limits<double>::infinity());
  for (const dvec3& v : vertices) {
    const dvec3 p = X_WA.rotate(v);
    if (p.z < lowest.z) lowest = p;
  }
  X_WA.p = dvec3(X_WA.p.x, X_WA.p.y, top - depth) - lowest;
  return X_WA;
}

/// The largest changes between two steps, and the peaks.
struct Changes {
  double force = 0, area = 0, force_jump = 0, area_jump = 0;
  std::set<int> tets, faces;  ///< tets and faces of all polygons
};

Changes changes_of(const Slide& slide) {
  const HydroBodyPtr a = slide.a(), b = slide.b();
  const dvec3 along = glm::normalize(slide.direction_W);
  const int steps = static_cast<int>(std::lround(slide.distance / kStep));
  const Pose X_WA = pressed(*a, slide.X_WA, slide.depth, slide.top);
  ContactSurface surface;
  IntersectWorkspace workspace;
  Changes changes;
  double last_area = 0;
  dvec3 last_force{0};
  for (int i = 0; i <= steps; ++i) {
    Pose X = X_WA;
    X.p += (i - 0.5 * steps) * kStep * along;
    intersect(*a, *b, X, Pose{}, surface, workspace);
    // In frame A, which does not rotate.
    const dvec3 force = surface.empty() ? dvec3(0) : pressure_wrench(surface).force;
    const double area = surface.area();
    if (i > 0) {
      changes.force_jump = std::max(changes.force_jump, glm::distance(force, last_force));
      changes.area_jump = std::max(changes.area_jump, std::abs(area - last_area));
    }
    last_force = force;
    last_area = area;
    changes.force = std::max(changes.force, glm::length(force));
    changes.area = std::max(changes.area, area);
    for (const ContactPolygon& polygon : surface.polygons) {
      changes.tets.insert(polygon.tet);
      changes.faces.insert(polygon.face);
    }
  }
  return changes;
}

class Slides : public testing::TestWithParam<Slide> {};

TEST_P(Slides, ChangeWithoutJumps) {
  const Slide& slide = GetParam();
  const Changes c = changes_of(slide);
  EXPECT_GT(c.force, 0.05);
  EXPECT_GT(c.faces.size() + c.tets.size(), 3u);  // at least one boundary is crossed
  // Along a plane nothing changes at all, for any division into triangles and tets.
  EXPECT_LE(c.force_jump, (slide.even ? 1e-9 : 0.005) * c.force);
  EXPECT_LE(c.area_jump, (slide.even ? 1e-9 : 0.01) * c.area);
  EXPECT_GT(c.force_jump, (slide.even ? 0 : 1e-5) * c.force);
  RecordProperty("force_jump_percent", std::to_string(100 * c.force_jump / c.force));
  RecordProperty("area_jump_percent", std::to_string(100 * c.area_jump / c.area));
}

const Slide kSlides[] = {
    // Over the edge x = 0.03 of the crate's top, outward from its middle.
    {"BallOverAnEdge", soft_ball, crate, tilted(20, 30, {0.03, 0.004, 0}), {1, 0.1, 0}},
    {"FingerOverAnEdge", pad_finger, crate, tilted(135, 90, {0.03, 0.002, 0}), {1, 0, 0}},
    {"BlockOverAnEdge", soft_block, crate, tilted(0, 17, {0.03, 0.002, 0}), {1, 0.2, 0}},
    // Over the diagonal of the top, which is not an edge of the body.
    {"BallOverAFaceBoundary", soft_ball, crate, tilted(20, 30, {0.001, 0.001, 0}), {1, -1, 0}, true},
    {"BlockAlongAFaceBoundary", soft_block, crate, tilted(0, 45, {0.0021, -0.0191, 0}), {1, 1, 0}, true},
    {"BlockOverAFaceBoundary", soft_block, crate, tilted(0, 0, {-0.012, -0.015, 0}), {1, 0, 0}, true},
    {"FingerOverAFaceBoundary", pad_finger, crate, tilted(135, 90, {0.001, 0.002, 0}), {1, -1, 0}, true},
    // Over the corner of the top.
    {"BallOverAVertex", soft_ball, crate, tilted(20, 30, {0.03, 0.03, 0}), {1, 1.1, 0}},
    {"FingerOverAVertex", pad_finger, crate, tilted(135, 90, {0.03, 0.03, 0}), {1, 0.7, 0}},
    // Over an edge, a corner and the middle of a soft body.
    {"RigidBallOverASoftEdge", rigid_ball, soft_crate, tilted(20, 30, {0.03, 0.004, 0}), {1, 0.1, 0}},
    {"RigidBallOverASoftVertex", rigid_ball, soft_crate, tilted(20, 30, {0.03, 0.03, 0}), {1, 1.1, 0}},
    {"RigidBallOverASoftFace", rigid_ball, soft_crate, tilted(20, 30, {0, 0, 0}), {1, 1.1, 0}, true},
    // Facets against facets: edges, face boundaries and vertices of both bodies, one after another.
    {"BallOverABall", soft_ball, rigid_ball, tilted(20, 30, {0, 0.001, 0}), {1, 0.2, 0}, false, 0.02},
    {"FingerOverABall", pad_finger, rigid_ball, tilted(135, 90, {0, 0.001, 0}), {1, 0.2, 0}, false, 0.02, 0.0015},
    // Both bodies are soft.
    {"BallOverASoftEdge", soft_ball, soft_crate, tilted(20, 30, {0.03, 0.004, 0}), {1, 0.1, 0}},
    {"BallOverASoftVertex", soft_ball, soft_crate, tilted(20, 30, {0.03, 0.03, 0}), {1, 1.1, 0}},
    {"BlockOverASoftFace", soft_block, soft_crate, tilted(0, 0, {-0.012, -0.015, 0}), {1, 0, 0}, true},
    {"FingerOverASoftEdge", pad_finger, soft_crate, tilted(135, 90, {0.03, 0.002, 0}), {1, 0, 0}},
};

INSTANTIATE_TEST_SUITE_P(Property, Slides, testing::ValuesIn(kSlides),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace taxel
