// Contact beyond a pad's tets: no hole, and the force of p = (E/H) D at any depth.
#include "core/hydro/kernel/depth_pieces.h"

#include <gtest/gtest.h>

#include "core/base/rng.h"
#include "core/mesh/make/primitives.h"
#include "fixtures/counted_new.h"
#include "fixtures/depth_oracle.h"
#include "fixtures/instruction_sets.h"
#include "fixtures/random_pose.h"

namespace taxel {
namespace {

constexpr double kModulus = 5e4, kThickness = 0.002, kStiffness = kModulus / kThickness;

int pieces_of(const ContactSurface& surface) {
  return static_cast<int>(std::count_if(surface.polygons.begin(), surface.polygons.end(),
                                        [](const ContactPolygon& p) { return p.tet < 0; }));
}

double force_of(const Contact& contact) {
  return glm::length(contact.wrench.force);
}

/// A pad on a sphere of radius R has p = (E/H)(R - r). A rigid plane at depth x, at the distance h = R - x from the
/// centre, cuts the sphere in a disc of radius a, a^2 = R^2 - h^2:
///   F = (E/H) 2 pi integral_0^a (R - sqrt(h^2 + s^2)) s ds = (E/H) pi (R a^2 - 2/3 (R^3 - h^3))
///     = (E/H) pi (R x^2 - 2/3 x^3),   area = pi (2 R x - x^2).
TEST(DepthPieces, EqualTheClosedFormForAPlaneInASphericalPad) {
  const double R = 0.02;
  const auto ball = make_simple_body(ShapeType::sphere, dvec3(R, 0, 0), soft_material(kModulus, kThickness), 0.002);
  const auto plane = make_simple_body(ShapeType::plane, dvec3(0)), box = make_simple_body(ShapeType::box, dvec3(0.03));
  for (const double part : {0.3, 0.8, 1.1, 1.5, 2.0, 3.0, 5.0}) {
    const double x = part * kThickness;
    const double force = kStiffness * kPi * (R * x * x - 2.0 / 3.0 * x * x * x), area = kPi * (2 * R * x - x * x);
    for (const bool half_space : {true, false}) {
      const Contact c = half_space ? touch(*ball, *plane, at_height(R - x), Pose{})
                                   : touch(*ball, *box, at_height(R - x), at_height(-0.03));
      EXPECT_NEAR(force_of(c), force, 0.01 * force) << part << half_space;
      EXPECT_NEAR(c.surface.area(), area, 0.01 * area) << part << half_space;
      EXPECT_EQ(pieces_of(c.surface) > 0, part > 1) << part;
      EXPECT_EQ(c.surface.at_core(), 0);
    }
  }
}

/// Below the middle of a face, D is the depth below the plane of this face. Any closed body there is pushed out with
/// (E/H) V (A3), also if no tet is near and no part of the body is at the skin.
TEST(DepthPieces, PushABodyInsideTheCoreByItsVolume) {
  const double half = 0.02;
  const auto pad = make_mesh_body(make_box(dvec3(half)), all_faces(soft_material(kModulus, 0.001)));
  const TriMesh ball = make_icosphere(0.003, 2);
  const auto rigid = make_mesh_body(ball);
  const double force = kModulus / 0.001 * ball.volume();
  for (int i = 0; i < 10; ++i) {
    Pose X = random_pose(3, i, 0.002);
    X.p.z += half - 0.008;
    const Contact c = touch(*pad, *rigid, Pose{}, X);
    EXPECT_EQ(pieces_of(c.surface), static_cast<int>(c.surface.polygons.size()));
    EXPECT_NEAR(c.wrench.force.z, -force, 1e-9 * force);
    EXPECT_NEAR(c.surface.area(), ball.area(), 1e-9 * ball.area());
  }
}

struct Press {
  HydroBodyPtr rigid;
  double reach;  ///< distance from the rigid body's origin to its lowest point, against the press [m]
};

/// Returns the pose pressed along -normal at a place of the skin, which is `depth` above the rigid body's foremost
/// point.
Pose pressed_at(const dvec3& place, const dvec3& normal, double depth, double reach) {
  const dvec3 z = -normal, x = any_perpendicular(z), y = glm::cross(z, x);
  return {glm::normalize(glm::quat_cast(dmat3(x, y, z))), place + (reach - depth) * normal};
}

std::vector<Press> presses() {
  return {{make_simple_body(ShapeType::sphere, dvec3(0.004, 0, 0), {}, 0.0008), 0.004},
          {make_simple_body(ShapeType::plane, dvec3(0)), 0},
          {make_simple_body(ShapeType::box, dvec3(0.006, 0.004, 0.006)), 0.006}};
}

TEST(DepthPieces, GiveAForceThatGrowsWithDepthEverywhere) {
  const TriMesh tip = make_fingertip();
  const auto finger = make_mesh_body(tip, all_faces(soft_material(kModulus, kThickness)));
  const CounterRng rng(7);
  ContactSurface surface;
  IntersectWorkspace workspace, fine;
  fine.kernel->piece_size = {0.002, 0.1};
  int checked = 0;
  for (std::uint64_t place = 0; place < 30; ++place) {
    const int face = static_cast<int>(rng.uniform(place) * tip.face_count());
    const dvec3 middle = (tip.vertex(face, 0) + tip.vertex(face, 1) + tip.vertex(face, 2)) / 3.0;
    const dvec3 normal = tip.face_normals()[static_cast<std::size_t>(face)];
    for (const Press& press : presses()) {
      double before = 0;
      for (const double part : {0.1, 0.3, 0.6, 0.9, 1.0, 1.1, 1.3, 1.6, 2.0, 2.5, 3.0}) {
        const Pose X = pressed_at(middle, normal, part * kThickness, press.reach);
        intersect(*finger, *press.rigid, Pose{}, X, surface, workspace);
        const double force = glm::dot(pressure_wrench(surface).force, -normal);
        EXPECT_GT(force, before) << "place " << place << ", depth " << part;
        before = force;
        if (place % 10 != 0 || part < 1) continue;
        const double area = surface.area();
        intersect(*finger, *press.rigid, Pose{}, X, surface, fine);
        const double exact = glm::dot(pressure_wrench(surface).force, -normal);
        EXPECT_NEAR(force, exact, 0.0015 * exact) << "place " << place << ", depth " << part;
        EXPECT_NEAR(area, surface.area(), 0.002 * area) << "place " << place << ", depth " << part;
        ++checked;
      }
    }
  }
  EXPECT_EQ(checked, 3 * 3 * 7);
}

TEST(DepthPieces, EqualDenseQuadratureOfTheDepth) {
  const auto mesh = std::make_shared<const TriMesh>(make_fingertip());
  const auto finger = make_mesh_body(*mesh, all_faces(soft_material(kModulus, kThickness)));
  const MeshIndex skin(mesh);
  const dvec3 place(0, 0, mesh->bounds().hi.z);
  for (const Press& press : {presses()[0], presses()[2]}) {
    for (const double part : {1.1, 2.0, 3.0}) {
      const Pose X = pressed_at(place, {0, 0, 1}, part * kThickness, press.reach);
      const Contact c = touch(*finger, *press.rigid, Pose{}, X);
      const DepthOracle oracle =
          depth_oracle(skin, kStiffness, std::get<RigidMesh>(press.rigid->geometry).index->mesh(), X, 2e-4);
      EXPECT_NEAR(force_of(c), glm::length(oracle.force), 0.004 * force_of(c)) << part;
      EXPECT_NEAR(c.surface.area(), oracle.area, 0.005 * oracle.area) << part;
      EXPECT_GT(pieces_of(c.surface), 10);
    }
  }
}

TEST(DepthPieces, TreatAHalfSpaceLikeALargeBox) {
  const auto finger = make_mesh_body(make_fingertip(), soft_material(kModulus, kThickness));
  const auto plane = make_simple_body(ShapeType::plane, dvec3(0)), box = make_simple_body(ShapeType::box, dvec3(0.1));
  const double top = make_fingertip().bounds().hi.z;
  for (const double part : {1.2, 2.0, 3.0}) {
    const Pose X = pressed_at({0, 0, top}, {0, 0, 1}, part * kThickness, 0);
    const Contact flat = touch(*finger, *plane, Pose{}, X);
    const Contact boxed = touch(*finger, *box, Pose{}, X * at_height(-0.1));
    EXPECT_NEAR(force_of(flat), force_of(boxed), 0.002 * force_of(boxed)) << part;
    EXPECT_NEAR(flat.surface.area(), boxed.surface.area(), 0.002 * boxed.surface.area()) << part;
  }
}

/// Returns a box whose top consists of narrow strips from one end to the other.
TriMesh box_with_strips(double half, int strips) {
  const TriMesh box = make_box(dvec3(half));
  std::vector<dvec3> vertices = box.vertices();
  std::vector<ivec3> faces;
  for (int f = 0; f < box.face_count(); ++f) {
    const bool is_top = box.face_normals()[static_cast<std::size_t>(f)].z > 0.5;
    const bool is_end = std::abs(box.face_normals()[static_cast<std::size_t>(f)].y) > 0.5;
    if (!is_top && !is_end) faces.push_back(box.faces()[static_cast<std::size_t>(f)]);
  }
  const int first = static_cast<int>(vertices.size());
  for (int i = 0; i <= strips; ++i) {
    for (const double y : {-half, half}) vertices.push_back({-half + 2 * half * i / strips, y, half});
    const int a = first + 2 * i;  // (x, -y), then (x, +y)
    if (i == 0) continue;
    faces.push_back({a - 2, a, a + 1});
    faces.push_back({a - 2, a + 1, a - 1});
  }
  for (const int end : {0, 1}) {
    const double y = end == 0 ? -half : half;
    const int low = static_cast<int>(vertices.size());
    vertices.push_back({-half, y, -half});
    vertices.push_back({half, y, -half});
    std::vector<ivec3> fan{{low, low + 1, first + 2 * strips + end}};
    for (int i = strips; i > 0; --i) fan.push_back({low, first + 2 * i + end, first + 2 * (i - 1) + end});
    for (const ivec3& face : fan) faces.push_back(end == 0 ? face : ivec3(face.x, face.z, face.y));
  }
  return {std::move(vertices), std::move(faces)};
}

/// A rounded edge consists of such strips. Repeated quartering once gave thousands of pieces narrower than a micrometre
/// for each strip.
TEST(DepthPieces, AreFewForNarrowTriangles) {
  const auto finger = make_mesh_body(make_fingertip(), soft_material(kModulus, kThickness));
  const auto box = make_simple_body(ShapeType::box, dvec3(0.02)), strips = make_mesh_body(box_with_strips(0.02, 400));
  for (const double part : {1.5, 3.0}) {
    const Pose X = pressed_at({0, 0, make_fingertip().bounds().hi.z}, {0, 0, 1}, part * kThickness, 0.02);
    const Contact whole = touch(*finger, *box, Pose{}, X), cut = touch(*finger, *strips, Pose{}, X);
    EXPECT_NEAR(force_of(cut), force_of(whole), 0.002 * force_of(whole)) << part;
    EXPECT_NEAR(cut.surface.area(), whole.surface.area(), 0.002 * whole.surface.area()) << part;
    EXPECT_GT(pieces_of(cut.surface), 100) << part;
    EXPECT_LT(pieces_of(cut.surface), 4000) << part;
  }
}

/// A field that ends with its tets gives the same polygons of tets, in the same order and with the same bits.
TEST(DepthPieces, LeaveThePolygonsOfTheTetsUnchanged) {
  const auto finger = make_mesh_body(make_fingertip(), soft_material(kModulus, kThickness));
  HydroBody ends = *finger;
  ends.geometry = SoftBody(std::get<SoftBody>(finger->geometry).field);
  for (const Press& press : presses()) {
    for (const double part : {0.5, 1.5}) {
      const Pose X = pressed_at({0, 0, make_fingertip().bounds().hi.z}, {0, 0, 1}, part * kThickness, press.reach);
      const ContactSurface with = touch(*finger, *press.rigid, Pose{}, X).surface;
      const ContactSurface without = touch(ends, *press.rigid, Pose{}, X).surface;
      EXPECT_EQ(without.at_core() > 0, part > 1);
      std::size_t next = 0;
      for (const ContactPolygon& p : with.polygons) {
        if (p.tet < 0) continue;
        ASSERT_LT(next, without.polygons.size());
        const ContactPolygon& q = without.polygons[next++];
        ASSERT_EQ(p.tet, q.tet);
        ASSERT_EQ(p.centroid, q.centroid);
        ASSERT_EQ(p.area, q.area);
        for (int i = 0; i < p.count; ++i)
          ASSERT_EQ(with.vertices[static_cast<std::size_t>(p.first + i)],
                    without.vertices[static_cast<std::size_t>(q.first + i)]);
      }
      EXPECT_EQ(next, without.polygons.size());
    }
  }
}

/// For any pressed shape, no piece overlaps another piece or a polygon of the tets, and no area is missing.
TEST(DepthPieces, CoverTheAreaInsideTheSkin) {
  const double half = 0.01;
  const auto pad = make_mesh_body(make_box(dvec3(half)), all_faces(soft_material(kModulus, kThickness)));
  for (int i = 0; i < 20; ++i) {
    const auto cube = make_simple_body(ShapeType::box, dvec3(0.004));
    Pose X = random_pose(9, i, 0.004);
    const Contact c = touch(*pad, *cube, Pose{}, X);
    const DepthOracle oracle = depth_oracle(MeshIndex(std::make_shared<const TriMesh>(make_box(dvec3(half)))), 1,
                                            make_box(dvec3(0.004)), X, 2e-4);
    EXPECT_NEAR(c.surface.area(), oracle.area, 0.005 * oracle.area) << i;
  }
}

TEST(DepthPieces, HaveALinearPressureOnEachPiece) {
  const auto finger = make_mesh_body(make_fingertip(), soft_material(kModulus, kThickness));
  const Press ball = presses()[0];
  const Pose X = pressed_at({0, 0, make_fingertip().bounds().hi.z}, {0, 0, 1}, 2 * kThickness, ball.reach);
  const MeshIndex skin(std::make_shared<const TriMesh>(make_fingertip()));
  const ContactSurface s = touch(*finger, *ball.rigid, Pose{}, X).surface;
  int pieces = 0;
  for (const ContactPolygon& p : s.polygons) {
    if (p.tet >= 0) continue;
    ++pieces;
    EXPECT_GE(p.face, 0);
    for (int i = 0; i < p.count; ++i) {
      const auto v = static_cast<std::size_t>(p.first + i);
      const double linear = p.pressure + glm::dot(p.gradient, s.vertices[v] - p.centroid);
      EXPECT_NEAR(s.pressure[v], std::max(0.0, linear), 1e-7 * kModulus);
      EXPECT_NEAR(s.pressure[v], -kStiffness * skin.signed_distance(s.vertices[v]), 0.03 * kModulus);
    }
  }
  EXPECT_GT(pieces, 0);
}

/// Below a saddle z = k x y, D is linear along both edges of a flat rectangle and twisted between them.
TEST(DepthPieces, FollowATwistedDepth) {
  const double half = 0.015, k = 20, height = k * half * half;
  HeightField saddle{31, 31, {}, {half, half, 2 * height}, half};
  for (int row = 0; row < saddle.rows; ++row) {
    for (int column = 0; column < saddle.columns; ++column)
      saddle.elevation.push_back(0.5 + 0.5 * (row / 15.0 - 1) * (column / 15.0 - 1));
  }
  const auto skin = std::make_shared<const TriMesh>(make_height_field(saddle));
  const auto pad = make_mesh_body(*skin, soft_material(kModulus, kThickness));
  const auto box = make_simple_body(ShapeType::box, dvec3(0.005));
  const double below = 1.5 * kThickness;
  const ContactSurface s = touch(*pad, *box, Pose{}, at_height(height - below + 0.005)).surface;
  const MeshIndex index(skin);
  int on_face = 0;
  for (const ContactPolygon& p : s.polygons) {
    if (std::abs(p.centroid.z - (height - below)) > 1e-9) continue;
    ++on_face;
    EXPECT_LT(p.tet, 0);
    for (int i = 0; i < p.count; ++i) {
      const auto v = static_cast<std::size_t>(p.first + i);
      EXPECT_NEAR(s.pressure[v], -kStiffness * index.signed_distance(s.vertices[v]), 0.03 * kModulus);
    }
  }
  EXPECT_GE(on_face, 16);
  EXPECT_LE(on_face, 64);
}

TEST(DepthPieces, AllocateNothingAfterWarmUp) {
  const auto finger = make_mesh_body(make_fingertip(), soft_material(kModulus, kThickness));
  ContactSurface surface;
  IntersectWorkspace workspace;
  const std::vector<Press> all = presses();
  std::size_t polygons = 0;
  const auto run = [&] {
    for (const Press& press : all) {
      const Pose X = pressed_at({0, 0, make_fingertip().bounds().hi.z}, {0, 0, 1}, 2 * kThickness, press.reach);
      const long before = allocation_count();
      intersect(*finger, *press.rigid, Pose{}, X, surface, workspace);
      polygons += surface.polygons.size();
      EXPECT_TRUE(polygons < 3000 || allocation_count() == before);
    }
  };
  while (polygons < 3000) run();
  run();
}

TEST(DepthPieces, HaveTheSameBitsOnAllInstructionSets) {
  const auto finger = make_mesh_body(make_fingertip(), soft_material(kModulus, kThickness));
  for (const Press& press : presses()) {
    const Pose X = pressed_at({0, 0, make_fingertip().bounds().hi.z}, {0, 0, 1}, 2 * kThickness, press.reach);
    const ContactSurface usual = touch(*finger, *press.rigid, Pose{}, X).surface;
    ASSERT_GT(pieces_of(usual), 50);
    test::for_each_set([&](std::int64_t target) {
      const ContactSurface found =
          test::on_target(target, [&] { return touch(*finger, *press.rigid, Pose{}, X).surface; });
      ASSERT_EQ(found.vertices, usual.vertices);
      ASSERT_EQ(found.pressure, usual.pressure);
    });
  }
}

}  // namespace
}  // namespace taxel
