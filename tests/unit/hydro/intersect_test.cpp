// Contact surfaces of pairs of bodies: special positions, symmetry and memory.
#include "core/hydro/intersect.h"

#include <gtest/gtest.h>

#include <set>

#include "core/base/error.h"
#include "fixtures/counted_new.h"
#include "fixtures/hydro_bodies.h"
#include "fixtures/random_pose.h"
#include "fixtures/slab_field.h"

namespace taxel {
namespace {

constexpr double kStiffness = 1e7;  // E/H [Pa/m]

/// Returns a slab of 40 x 40 x 10 mm whose tets meet in the planes x = 0, y = 0, z = -5 mm and others.
/// Returns a slab in which all faces count, so that areas are those of the whole body.
HydroBodyPtr slab() {
  return make_slab(dvec2(0.02), 0.01, {4, 4, 2}, kStiffness, FaceRule::all);
}

std::string message_of(const HydroBody& a, const HydroBody& b) {
  try {
    touch(a, b, Pose{}, Pose{});
    return "";
  } catch (const Error& error) {
    return error.what();
  }
}

TEST(Intersect, NamesUnsupportedPairs) {
  const auto rigid = make_body({ShapeType::box, dvec3(1), nullptr, 0}, {}, "crate");
  const auto other = make_body({ShapeType::plane, dvec3(0), nullptr, 0}, {}, "floor");
  const auto soft = make_body({ShapeType::sphere, dvec3(1), nullptr, 0}, soft_material(1), "ball");
  const auto mat = make_body({ShapeType::plane, dvec3(0), nullptr, 0}, soft_material(1, 1), "mat");
  for (const std::string& text : {message_of(*rigid, *other), message_of(*mat, *other)}) EXPECT_FALSE(text.empty());
  EXPECT_NE(message_of(*rigid, *other).find("'crate' and 'floor' are both rigid"), std::string::npos);
  EXPECT_EQ(message_of(*soft, *mat), "");
  EXPECT_NE(message_of(*mat, *other).find("half-spaces"), std::string::npos);
  EXPECT_EQ(message_of(*soft, *other), "");
}

/// A box as large as the slab, whose upper face is in the plane z of the slab, exactly or with one rounding error.
TEST(Intersect, CountsAFaceInASharedPlaneOnce) {
  const dvec3 half(0.01, 0.01, 0.002);
  const auto box = make_simple_body(ShapeType::box, half);
  const double top = 4 * half.x * half.y, side = 4 * 2 * half.x * 2 * half.z;
  for (const double noise : {0.0, 1e-19, -1e-19, 1e-18, -1e-18, 1e-17, -1e-17, 1e-16, -1e-16}) {
    // The top is in z = -5 mm, the sides are in x = +-10 mm and y = +-10 mm. All faces except the bottom are in planes
    // of tets.
    const Pose pose{dquat(1, 0, 0, 0), dvec3(noise, -noise, -0.005 - half.z + noise)};
    const Contact c = touch(*slab(), *box, Pose{}, pose);
    const double area = 2 * top + side;
    EXPECT_NEAR(c.surface.area(), area, 1e-12 * area) << noise;
    EXPECT_NEAR(c.wrench.force.z, -kStiffness * 8 * half.x * half.y * half.z, 1e-12 * kStiffness * area * 0.01)
        << noise;
  }
}

TEST(Intersect, CountsACoplanarFaceOnceInAnyFrame) {
  const dvec3 half(0.01, 0.01, 0.002);
  const auto box = make_simple_body(ShapeType::box, half);
  const double area = 8 * half.x * half.y + 16 * half.x * half.z;
  for (int i = 0; i < 100; ++i) {
    const Pose motion = random_pose(31, i, 0.5);
    const Contact c = touch(*slab(), *box, motion, motion * Pose{dquat(1, 0, 0, 0), dvec3(0, 0, -0.005 - half.z)});
    EXPECT_NEAR(c.surface.area(), area, 1e-12 * area) << i;
  }
}

TEST(Intersect, CountsARigidPlaneInASharedPlaneOnce) {
  const auto plane = make_simple_body(ShapeType::plane, dvec3(0));
  for (const double noise : {0.0, 1e-19, -1e-19, 1e-18, -1e-18}) {
    const Contact c = touch(*slab(), *plane, Pose{}, at_height(-0.005 + noise));
    EXPECT_NEAR(c.surface.area(), 0.04 * 0.04, 1e-12 * 0.04 * 0.04) << noise;
  }
}

TEST(Intersect, FindsNoContactIfOnlyTheSkinIsTouched) {
  const auto box = make_simple_body(ShapeType::box, dvec3(0.01));
  const Contact c = touch(*slab(), *box, Pose{}, at_height(0.01));
  EXPECT_TRUE(c.surface.empty());
  const RejectedPolygons& touching = c.surface.left_out(Rejection::touching);
  EXPECT_NEAR(touching.area, 4e-4, 1e-12);
  EXPECT_NEAR(touching.force, 0, 1e-15);
  EXPECT_EQ(static_cast<std::size_t>(touching.count), c.surface.filtered.size());  // stored separately for display
  EXPECT_EQ(c.surface.left_out(Rejection::sliver).count, 0);
}

TEST(Intersect, GivesAnEmptySurfaceForBodiesApart) {
  const auto plane = make_simple_body(ShapeType::plane, dvec3(0)), box = make_simple_body(ShapeType::box, dvec3(0.01));
  const auto mat = make_simple_body(ShapeType::plane, dvec3(0), soft_material(1, 1));
  EXPECT_TRUE(touch(*slab(), *plane, at_height(0.02), Pose{}).surface.empty());
  EXPECT_TRUE(touch(*slab(), *box, at_height(1), Pose{}).surface.empty());
  EXPECT_TRUE(touch(*mat, *box, Pose{}, at_height(0.02)).surface.empty());
  EXPECT_FALSE(touch(*mat, *box, Pose{}, at_height(0.0)).surface.empty());
}

TEST(Intersect, GivesNormalsThatPushA) {
  const auto plane = make_simple_body(ShapeType::plane, dvec3(0));
  for (const ContactPolygon& p : touch(*slab(), *plane, at_height(0.005), Pose{}).surface.polygons) {
    EXPECT_NEAR(p.normal.z, 1, 1e-15);
    EXPECT_EQ(p.face, -1);
    EXPECT_GE(p.tet, 0);
  }
  for (const ContactPolygon& p : touch(*plane, *slab(), Pose{}, at_height(0.005)).surface.polygons)
    EXPECT_NEAR(p.normal.z, -1, 1e-15);
}

/// Each pair of tet and triangle occurs at most once, in the same order every time.
TEST(Intersect, GivesPolygonsInAFixedOrder) {
  const auto sphere = make_simple_body(ShapeType::sphere, dvec3(0.01, 0, 0), {}, 0.001);
  const Contact a = touch(*slab(), *sphere, Pose{}, at_height(0.004)),
                b = touch(*slab(), *sphere, Pose{}, at_height(0.004));
  ASSERT_GT(a.surface.polygons.size(), 100u);
  EXPECT_EQ(a.surface.vertices, b.surface.vertices);
  std::set<std::pair<int, int>> seen;
  for (const ContactPolygon& p : a.surface.polygons) {
    EXPECT_TRUE(seen.insert({p.face, p.tet}).second);
  }
}

TEST(Intersect, MergesNeighbouringVerticesWithoutMovingArea) {
  // The rigid edge passes 3e-9 m from a line of tet vertices, which gives strips of 1e-7 of a tet's size.
  const auto box = make_simple_body(ShapeType::box, dvec3(0.01, 0.013, 0.0015));
  const Pose pose{dquat(1, 0, 0, 0), dvec3(3e-9, 0, -0.0081)};
  const ContactSurface s = touch(*slab(), *box, Pose{}, pose).surface;
  const double area = 8 * 0.01 * 0.013 + 8 * 0.0015 * 0.023;
  EXPECT_NEAR(s.area(), area, 1e-12 * area);
  int close = 0, strips = 0;
  for (const ContactPolygon& p : s.polygons) {
    for (int i = 0; i < p.count; ++i) {
      const dvec3& a = s.vertices[static_cast<std::size_t>(p.first + i)];
      const dvec3& b = s.vertices[static_cast<std::size_t>(p.first + (i + 1) % p.count)];
      if (glm::distance(a, b) >= 5e-9) continue;
      // Such a short edge remains only in a polygon that would vanish without it.
      ++close;
      EXPECT_LT(p.area, 1e-10);
    }
    strips += p.area < 1e-10 ? 1 : 0;
  }
  EXPECT_GT(strips, 0);
  EXPECT_GT(close, 0);
}

TEST(Intersect, RejectsAndCountsSlivers) {
  const auto box = make_simple_body(ShapeType::box, dvec3(0.01, 0.013, 0.0015));
  const ContactSurface s = touch(*slab(), *box, Pose{}, {dquat(1, 0, 0, 0), dvec3(1e-16, 0, -0.0081)}).surface;
  EXPECT_GT(s.left_out(Rejection::sliver).count, 0);
  EXPECT_LT(s.left_out(Rejection::sliver).area, 1e-15);
}

/// A field that ends with its tets, like a field from a file of an earlier version.
TEST(Intersect, CountsTheHoleAtTheEndOfAField) {
  const auto whole = make_simple_body(ShapeType::sphere, dvec3(0.02, 0, 0), soft_material(1e5, 0.003));
  HydroBody pad = *whole;
  pad.geometry = SoftBody(std::get<SoftBody>(whole->geometry).field);
  const auto plane = make_simple_body(ShapeType::plane, dvec3(0)), box = make_simple_body(ShapeType::box, dvec3(0.005));
  EXPECT_EQ(touch(pad, *plane, at_height(0.018), Pose{}).surface.at_core(), 0);
  EXPECT_GT(touch(pad, *plane, at_height(0.016), Pose{}).surface.at_core(), 0);
  EXPECT_EQ(touch(pad, *box, at_height(0.023), Pose{}).surface.at_core(), 0);
  EXPECT_GT(touch(pad, *box, at_height(0.020), Pose{}).surface.at_core(), 0);
  EXPECT_EQ(touch(*whole, *plane, at_height(0.016), Pose{}).surface.at_core(), 0);
}

TEST(Intersect, AllocatesNothingAfterWarmUp) {
  const auto finger = make_mesh_body(make_fingertip(), soft_material(1e5, 0.002));
  const auto mat = make_simple_body(ShapeType::plane, dvec3(0), soft_material(1e5, 0.002));
  const auto plane = make_simple_body(ShapeType::plane, dvec3(0)), box = make_simple_body(ShapeType::box, dvec3(0.01));
  ContactSurface surface;
  IntersectWorkspace workspace;
  std::size_t polygons = 0;
  const auto run = [&] {
    const Pose tip_in{dquat(1, 0, 0, 0), dvec3(0, 0, -0.02)};
    intersect(*finger, *box, Pose{}, Pose{dquat(1, 0, 0, 0), dvec3(0.001, -0.015, 0.01)}, surface, workspace);
    polygons += surface.polygons.size();
    traction(surface, {0.5, 0.5}, {{0.01, 0, 0}, {0, 1, 0}});
    intersect(*plane, *finger, Pose{}, tip_in, surface, workspace);
    polygons += surface.polygons.size();
    intersect(*mat, *box, Pose{}, at_height(0.009), surface, workspace);
    polygons += surface.polygons.size();
  };
  run();
  ASSERT_GT(polygons, 100u);
  const long before = allocation_count();
  for (int i = 0; i < 10; ++i) run();
  EXPECT_EQ(allocation_count(), before);
}

}  // namespace
}  // namespace taxel
