// The traversal from tet to tet finds the same polygons as the tree form, one by one.
#include <gtest/gtest.h>

#include <map>

#include "core/base/rng.h"
#include "core/hydro/intersect.h"
#include "core/hydro/kernel/workspace.h"
#include "core/mesh/make/primitives.h"
#include "fixtures/hydro_bodies.h"
#include "fixtures/random_pose.h"
#include "fixtures/slab_field.h"

namespace taxel {
namespace {

constexpr double kSize = 0.01;

/// Returns a sphere with dents and bumps.
TriMesh lumpy_mesh(int level, std::uint64_t seed, double low) {
  const TriMesh sphere = make_icosphere(kSize, level);
  std::vector<dvec3> vertices = sphere.vertices();
  const CounterRng rng(seed);
  for (std::size_t v = 0; v < vertices.size(); ++v) vertices[v] *= low + 0.4 * rng.uniform(v);
  return {std::move(vertices), sphere.faces()};
}

struct PairCase {
  const char* name;
  HydroBodyPtr a, b;
  int poses;
  double reach;  ///< largest distance of the poses of b from a [m]
};

std::vector<PairCase> cases() {
  const Material soft = soft_material(1e5), other = soft_material(3e5), pad = soft_material(1e5, 0.25 * kSize);
  const auto sphere = make_simple_body(ShapeType::sphere, dvec3(kSize), soft, 0.35 * kSize);
  const auto coarse = make_simple_body(ShapeType::sphere, dvec3(0.9 * kSize), other, 0.6 * kSize);
  const auto padded = make_mesh_body(make_ellipsoid(kSize * dvec3(1.3, 1.0, 0.8), 0.4 * kSize), pad);
  const auto dented = make_mesh_body(lumpy_mesh(2, 7, 0.8), pad);
  EXPECT_GT(std::get<SoftBody>(dented->geometry).field->report().two_layer_faces, 0);  // prisms of all kinds
  const auto rigid_lumps = make_mesh_body(lumpy_mesh(3, 5, 0.6));
  const auto rigid_sphere = make_simple_body(ShapeType::sphere, dvec3(kSize), {}, 0.2 * kSize);
  const auto box = make_simple_body(ShapeType::box, kSize * dvec3(1, 0.8, 0.6));
  const auto soft_box = make_simple_body(ShapeType::box, kSize * dvec3(1, 0.8, 0.6), other);
  const auto rod = make_simple_body(ShapeType::ellipsoid, kSize * dvec3(2.0, 0.3, 0.3), soft, 0.25 * kSize);
  const auto plate = make_simple_body(ShapeType::box, kSize * dvec3(1, 0.8, 0.15), other);
  return {{"sphere in fine sphere", sphere, rigid_sphere, 2000, 1.6 * kSize},
          {"sphere in lumps", sphere, rigid_lumps, 2000, 1.4 * kSize},
          {"pad on lumps", padded, rigid_lumps, 1500, 1.5 * kSize},
          {"dented pad on sphere", dented, rigid_sphere, 1500, 1.5 * kSize},
          {"dented pad on box", dented, box, 1000, 1.3 * kSize},
          {"two spheres", sphere, coarse, 1000, 1.5 * kSize},
          {"pad and sphere", padded, coarse, 500, 1.5 * kSize},
          {"two pads", padded, dented, 500, 1.5 * kSize},
          {"sphere and soft box", sphere, soft_box, 500, 1.5 * kSize},
          {"rod through a soft plate", rod, plate, 1000, 1.3 * kSize},
          {"coplanar", make_slab(dvec2(2 * kSize), kSize, {4, 4, 2}, 1e7), soft_box, 500, 1.5 * kSize}};
}

using Key = std::tuple<int, int, int>;

/// Returns the area of each pair of tet and face. Areas smaller than a sliver by rounding are omitted.
std::map<Key, double> polygons(const HydroBody& a, const HydroBody& b, const Pose& X_WB, bool tree_form) {
  IntersectWorkspace workspace;
  workspace.kernel->tree_form = tree_form;
  ContactSurface surface;
  intersect(a, b, Pose{}, X_WB, surface, workspace);
  std::map<Key, double> areas;
  for (const ContactPolygon& p : surface.polygons) {
    if (p.tet < 0) continue;  // a depth piece, which is in no tet
    EXPECT_TRUE(areas.try_emplace({p.tet, p.tet_b, p.face}, p.area).second);
  }
  std::erase_if(areas, [](const auto& entry) { return entry.second < 1e-12 * kSize * kSize; });
  return areas;
}

/// Expects the same polygons from both, and adds 1 to `touching` if there are any.
void expect_equal(const PairCase& c, const Pose& X_WB, const std::string& what, int& touching) {
  const auto tree = polygons(*c.a, *c.b, X_WB, true), walk = polygons(*c.a, *c.b, X_WB, false);
  ASSERT_EQ(tree.size(), walk.size()) << c.name << " " << what;
  for (const auto& [key, area] : tree) {
    const auto found = walk.find(key);
    ASSERT_NE(found, walk.end()) << c.name << " " << what;
    ASSERT_NEAR(found->second, area, 1e-12 * kSize * kSize) << c.name << " " << what;
  }
  touching += tree.empty() ? 0 : 1;
}
void expect_equal(const PairCase& c, const Pose& X_WB, const std::string& what) {
  int touching = 0;
  expect_equal(c, X_WB, what, touching);
}

TEST(Walk, EqualsTheTreeFormPolygonByPolygon) {
  int total = 0, touching = 0;
  for (const PairCase& c : cases()) {
    for (int i = 0; i < c.poses; ++i) {
      const Pose X_WB = random_pose(21, i, c.reach);
      expect_equal(c, X_WB, "pose " + std::to_string(i), touching);
    }
    total += c.poses;
  }
  EXPECT_GE(total, 10000);
  EXPECT_GE(touching, total / 2);
}

/// Faces of the boxes in planes of the slab's tets, and moved along these planes by small steps.
TEST(Walk, EqualsTheTreeFormOnCoplanarFaces) {
  const auto slab = make_slab(dvec2(2 * kSize), kSize, {4, 4, 2}, 1e7);
  for (const Material& material : {Material{}, soft_material(3e5)}) {
    const PairCase c{"coplanar", slab, make_simple_body(ShapeType::box, 0.5 * kSize * dvec3(1, 1, 0.5), material), 0,
                     0};
    for (int i = 0; i < 200; ++i) {
      const dvec3 p(0.5 * kSize * (i % 3), 0.25 * kSize * (i % 5), -0.25 * kSize * (1 + i % 4));
      const Pose X_WB{dquat(1, 0, 0, 0), p + 1e-3 * kSize * (i / 20) * dvec3(1, 0, 0)};
      expect_equal(c, X_WB, "pose " + std::to_string(i));
    }
  }
}

/// Corners exactly in faces between tets. One tet holds the corner, and the triangle continues in another tet.
TEST(Walk, EqualsTheTreeFormWithCornersInSharedFaces) {
  // A flat octahedron much larger than the tets, with one corner above the middle.
  const double wide = 4 * kSize, high = 0.5 * kSize;
  const auto fan = std::make_shared<const TriMesh>(
      std::vector<dvec3>{{0, 0, high}, {wide, 0, 0}, {0, wide, 0}, {-wide, 0, 0}, {0, -wide, 0}, {0, 0, -wide}},
      std::vector<ivec3>{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}, {5, 2, 1}, {5, 3, 2}, {5, 4, 3}, {5, 1, 4}});
  const PairCase c{"fan", make_simple_body(ShapeType::box, kSize * dvec3(2, 2, 1), soft_material(1e5)),
                   make_body({ShapeType::mesh, dvec3(0), fan, 0}, {}, "fan"), 0, 0};
  for (int i = 0; i < 125; ++i) {
    const Pose X_WB{dquat(1, 0, 0, 0), 0.5 * kSize * dvec3(i % 5 - 2, i / 5 % 5 - 2, -2 + i / 25 * 0.5)};
    expect_equal(c, X_WB, "pose " + std::to_string(i));
  }
}

/// A few large tets, each of which meets hundreds of small ones; the workspace is kept from call to call.
TEST(Walk, EqualsTheTreeFormWhereOneTetMeetsHundreds) {
  const auto box = make_simple_body(ShapeType::box, kSize * dvec3(3, 3, 1), soft_material(2e5));
  const auto capsule = make_simple_body(ShapeType::capsule, kSize * dvec3(0.8, 2, 0), soft_material(5e4), 0.1 * kSize);
  const dquat lying = glm::angleAxis(0.5 * kPi, glm::normalize(dvec3(0.1, 1, 0.05)));
  IntersectWorkspace kept;
  for (int i = 0; i < 6; ++i) {
    const Pose above{lying, kSize * dvec3(0.1 * i, 0.03, 1.78 - 0.03 * i)};
    expect_equal({"under", box, capsule, 0, 0}, above, "pose " + std::to_string(i));
    expect_equal({"on top", capsule, box, 0, 0}, above.inverse(), "pose " + std::to_string(i));
    ContactSurface again;
    intersect(*capsule, *box, Pose{}, above.inverse(), again, kept);
    const ContactSurface fresh = touch(*capsule, *box, Pose{}, above.inverse()).surface;
    ASSERT_GT(fresh.polygons.size(), 1000u);
    EXPECT_EQ(again.vertices, fresh.vertices);
  }
}

}  // namespace
}  // namespace taxel
