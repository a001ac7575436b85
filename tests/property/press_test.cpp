// Rigid bodies pressed into a pad at many places, from 0.1 to 3 thicknesses deep: each press is felt, and the force
// grows.
#include <gtest/gtest.h>

#include <filesystem>

#include "core/base/rng.h"
#include "core/hydro/intersect.h"
#include "core/hydro/kernel/workspace.h"
#include "core/mesh/mesh_io.h"
#include "core/mesh/repair/repair.h"
#include "fixtures/depth_oracle.h"
#include "fixtures/rough_meshes.h"

namespace taxel {
namespace {

constexpr double kPadModulus = 5e4, kPadThickness = 0.002, kPadStiffness = kPadModulus / kPadThickness;
constexpr int kPlaces = 30;
/// Depths in units of the thickness.
constexpr std::array kParts{0.1, 0.3, 0.6, 0.9, 1.0, 1.2, 1.4, 1.7, 2.0, 2.5, 3.0};

struct Stamp {
  std::string name;
  HydroBodyPtr body;
  double reach;  ///< distance from the body's origin to its lowest point [m]
  TriMesh mesh;  ///< mesh for dense quadrature, with its lowest point at -mesh_reach
  double mesh_reach;
};

std::vector<Stamp> make_stamps() {
  const auto ball = make_simple_body(ShapeType::sphere, dvec3(0.004, 0, 0), {}, 0.0008);
  const auto plane = make_simple_body(ShapeType::plane, dvec3(0));
  const dvec3 half(0.006, 0.004, 0.006);
  return {{"ball", ball, 0.004, std::get<RigidMesh>(ball->geometry).index->mesh(), 0.004},
          {"plane", plane, 0, make_box(dvec3(0.1)), 0.1},
          {"box", make_simple_body(ShapeType::box, half), half.z, make_box(half), half.z}};
}

struct Place {
  dvec3 x, normal;
};

/// Returns random places, each in its own share of the area.
std::vector<Place> even_places(const TriMesh& skin, int count) {
  std::vector<double> area_to;
  double area = 0;
  for (int f = 0; f < skin.face_count(); ++f) {
    area += 0.5 * glm::length(glm::cross(skin.vertex(f, 1) - skin.vertex(f, 0), skin.vertex(f, 2) - skin.vertex(f, 0)));
    area_to.push_back(area);
  }
  const CounterRng rng(5);
  std::vector<Place> places;
  for (int i = 0; i < count; ++i) {
    const auto n = 3 * static_cast<std::uint64_t>(i);
    const double share = (i + rng.uniform(n)) / count * area;
    const auto f = static_cast<int>(std::upper_bound(area_to.begin(), area_to.end() - 1, share) - area_to.begin());
    const double u = std::sqrt(rng.uniform(n + 1)), v = rng.uniform(n + 2);
    places.push_back({(1 - u) * skin.vertex(f, 0) + u * (1 - v) * skin.vertex(f, 1) + u * v * skin.vertex(f, 2),
                      skin.face_normals()[static_cast<std::size_t>(f)]});
  }
  return places;
}

Material pad_material(FaceRule faces) {
  Material material = soft_material(kPadModulus, kPadThickness);
  material.faces = faces;
  return material;
}

/// All faces count, unless a test is of the rule of faces: dense quadrature knows no rule.
class Press {
 public:
  explicit Press(const TriMesh& mesh, FaceRule faces = FaceRule::all)
      : skin_(std::make_shared<const TriMesh>(extract_shells(mesh, outer_shells(mesh)))),
        body_(make_mesh_body(skin_.mesh(), pad_material(faces))),
        places_(even_places(skin_.mesh(), kPlaces)),
        stamps_(make_stamps()) {
    fine_.kernel->piece_size = {0.002, 0.1};
  }

  /// Presses each stamp at each place. At every third place, area and force are also compared with fine pieces.
  void run() {
    for (std::size_t i = 0; i < places_.size(); ++i) {
      for (const Stamp& stamp : stamps_) press(i, stamp);
    }
  }

  double deepest = 3;         ///< largest depth, in units of the thickness
  int falls = 0;              ///< presses with less force than the previous, shallower one (size or direction)
  int unexplained_falls = 0;  ///< falls that dense quadrature of (E/H) D does not confirm
  int unfelt = 0;             ///< presses of 0.1 thicknesses without force
  double largest_area_error = 0, largest_force_error = 0;  ///< largest relative errors beyond one thickness

 private:
  struct Push {
    double size, along;  ///< total force, and force along the press [N]
  };

  [[nodiscard]] Pose pose(const Place& place, double depth, double reach) const {
    const dvec3 z = -place.normal, x = any_perpendicular(z), y = glm::cross(z, x);
    return {glm::normalize(glm::quat_cast(dmat3(x, y, z))), place.x + (reach - depth) * place.normal};
  }

  Push push(const Stamp& stamp, const Place& place, double depth, IntersectWorkspace& workspace) {
    intersect(*body_, *stamp.body, Pose{}, pose(place, depth, stamp.reach), surface_, workspace);
    const dvec3 force = pressure_wrench(surface_).force;
    return {glm::length(force), glm::dot(force, -place.normal)};
  }

  /// Moves the place outward to the first contact of a stamp that comes from afar along the normal.
  Place first_touch(const Stamp& stamp, const Place& place) {
    const auto touches = [&](double height) {
      push(stamp, place, -height, workspace_);
      return !surface_.polygons.empty();
    };
    double height = skin_.mesh().bounds().diagonal() + 2 * stamp.reach;
    const double step = 0.2 * kPadThickness;
    while (height > -kPadThickness && !touches(height)) height -= step;
    double clear = height + step;
    for (int k = 0; k < 16; ++k) {
      const double middle = 0.5 * (height + clear);
      (touches(middle) ? height : clear) = middle;
    }
    return {place.x + height * place.normal, place.normal};
  }

  Push oracle(const Stamp& stamp, const Place& place, double depth) const {
    const double edge = stamp.name == "ball" ? 2e-4 : 4e-4;
    const dvec3 force =
        depth_oracle(skin_, kPadStiffness, stamp.mesh, pose(place, depth, stamp.mesh_reach), edge).force;
    return {glm::length(force), glm::dot(force, place.normal) * -1};
  }

  void press(std::size_t i, const Stamp& stamp) {
    const Place place = first_touch(stamp, places_[i]);
    Push before{0, 0};
    double depth_before = 0;
    for (const double part : kParts) {
      if (part > deepest) return;
      const double depth = part * kPadThickness;
      const Push now = push(stamp, place, depth, workspace_);
      const double area = surface_.area();
      if (depth_before == 0 && !(now.size > 0)) ++unfelt;
      if (!(now.size > before.size && now.along > before.along)) {
        ++falls;
        const Push exact_before = oracle(stamp, place, depth_before), exact = oracle(stamp, place, depth);
        const bool is_true = (now.size > before.size || exact.size <= exact_before.size) &&
                             (now.along > before.along || exact.along <= exact_before.along);
        if (!is_true) ++unexplained_falls;
        EXPECT_TRUE(is_true) << stamp.name << " at place " << i << ", " << part << " H deep: " << before.size
                             << " N to " << now.size << " N, by quadrature " << exact_before.size << " to "
                             << exact.size;
      }
      if (i % 3 == 0 && part > 1) {
        const Push exact = push(stamp, place, depth, fine_);
        largest_area_error = std::max(largest_area_error, std::abs(area / surface_.area() - 1));
        largest_force_error = std::max(largest_force_error, std::abs(now.size / exact.size - 1));
      }
      before = now;
      depth_before = depth;
    }
  }

  MeshIndex skin_;
  HydroBodyPtr body_;
  std::vector<Place> places_;
  std::vector<Stamp> stamps_;
  ContactSurface surface_;
  IntersectWorkspace workspace_, fine_;
};

/// Returns a real mesh in mm, repaired as in a layout, or null if the file is absent.
TriMeshPtr repaired_mesh(const std::string& name) {
  const std::filesystem::path path = std::filesystem::path(TAXEL_REAL_DATA) / name;
  if (!std::filesystem::exists(path)) return nullptr;
  return repair_mesh(load_mesh(path, dvec3(0.001)).mesh, {}, kPadThickness)->mesh;
}

/// Pressures p = (E/H) D that a facet of 0.04 H feels, parallel to the skin and 0.1 H below it.
struct Felt {
  int places = 0;  ///< places with D >= 0.05 H, farther than that from a sharp edge
  int unfelt = 0;  ///< places where less than half of the facet is in contact
  int exact = 0;   ///< places with a pressure within 5 % of (E/H) D
};

Felt felt_by_facets(const TriMesh& mesh, int count) {
  const MeshIndex skin(std::make_shared<const TriMesh>(extract_shells(mesh, outer_shells(mesh))));
  const auto pad = make_mesh_body(skin.mesh(), all_faces(soft_material(kPadModulus, kPadThickness)));
  const double depth = 0.1 * kPadThickness;
  const dvec3 half(0.2 * depth, 0.2 * depth, depth);
  const auto pin = make_simple_body(ShapeType::box, half);
  const TriMesh& faces = std::get<RigidMesh>(pin->geometry).index->mesh();
  Felt felt;
  ContactSurface surface;
  IntersectWorkspace workspace;
  for (const Place& place : even_places(skin.mesh(), count)) {
    const dvec3 below = place.x - depth * place.normal;
    const double D = -skin.signed_distance(below);
    if (D < 0.5 * depth) continue;
    ++felt.places;
    const dvec3 z = -place.normal, x = any_perpendicular(z), y = glm::cross(z, x);
    const Pose X{glm::normalize(glm::quat_cast(dmat3(x, y, z))), place.x};
    intersect(*pad, *pin, Pose{}, X, surface, workspace);
    double force = 0, area = 0;
    for (const ContactPolygon& p : surface.polygons) {
      if (p.face < 0 || faces.face_normals()[static_cast<std::size_t>(p.face)].z < 0.5) continue;
      force += p.pressure * p.area;
      area += p.area;
    }
    if (area < 2 * half.x * half.y) {
      ++felt.unfelt;
    } else if (std::abs(force / area - kPadStiffness * D) <= 0.05 * kPadStiffness * D) {
      ++felt.exact;
    }
  }
  return felt;
}

/// Small triangles can be in gaps between the tets below a rough skin. Ten of these facets once had no contact.
TEST(Press, FeelsASmallFacetBetweenTheTets) {
  const Felt felt = felt_by_facets(make_rough_ball(3, 0.4, 7), 2000);
  EXPECT_GT(felt.places, 1900);
  EXPECT_EQ(felt.unfelt, 0);
}

/// Blades across a rough skin, of which the corners are outside and the tets below have gaps up to the skin.
TEST(Press, FeelsABladeThroughARoughSkin) {
  const TriMesh ball = make_rough_ball(3, 0.4, 7);
  const MeshIndex skin(std::make_shared<const TriMesh>(ball));
  const auto pad = make_mesh_body(ball, all_faces(soft_material(kPadModulus, kPadThickness)));
  const double half = 0.15 * kPadThickness;
  const auto blade = make_simple_body(ShapeType::box, dvec3(half, half, 0.1 * half));
  const TriMesh& faces = std::get<RigidMesh>(blade->geometry).index->mesh();
  ContactSurface surface;
  IntersectWorkspace workspace;
  double area = 0, expected = 0;
  int gaps = 0;
  for (const Place& place : even_places(ball, 1000)) {
    const dvec3 y = any_perpendicular(place.normal), z = glm::cross(place.normal, y);
    const Pose X{glm::normalize(glm::quat_cast(dmat3(place.normal, y, z))), place.x};
    intersect(*pad, *blade, Pose{}, X, surface, workspace);
    for (const ContactPolygon& p : surface.polygons) gaps += p.tet < 0 ? 1 : 0;
    const double oracle = depth_oracle(skin, kPadStiffness, faces, X, 0.1 * half).area;
    area += surface.area();
    expected += oracle;
  }
  EXPECT_GT(gaps, 200);
  EXPECT_NEAR(area, expected, 0.002 * expected);
}

TEST(Press, GivesASmallFacetItsDepthOnTheFinger) {
  const Felt felt = felt_by_facets(make_fingertip(), 1000);
  EXPECT_EQ(felt.places, 1000);
  EXPECT_EQ(felt.exact, 1000);
}

TEST(Press, GivesASmallFacetItsDepthOnRealSkins) {
  for (const char* name : {"paper/ubi_tip_collision.stl", "meshes/shadow_f_distal_pst.stl", "skins/gripper_flange.stl",
                           "skins/digit_holder.stl"}) {
    const TriMeshPtr mesh = repaired_mesh(name);
    if (!mesh) GTEST_SKIP() << "the real meshes are absent: " << TAXEL_REAL_DATA;
    const Felt felt = felt_by_facets(*mesh, 2000);
    EXPECT_EQ(felt.unfelt, 0) << name;
    EXPECT_GT(felt.exact, 0.95 * felt.places) << name;
  }
}

TEST(Press, HasAGrowingForceEverywhereOnTheFinger) {
  Press press(make_fingertip());
  press.run();
  EXPECT_EQ(press.falls, 0);
  EXPECT_EQ(press.unfelt, 0);
  EXPECT_LT(press.largest_area_error, 0.005);
  EXPECT_LT(press.largest_force_error, 0.02);
}

/// Deeper than 2.5 thicknesses a body is past the middle of the finger at some places: the gradient leads back there,
/// and the rule leaves out faces that dense quadrature counts.
TEST(Press, GrowsWithTheRuleOfFacesUpToTheMiddleOfTheFinger) {
  Press press(make_fingertip(), FaceRule::along_gradient);
  press.deepest = 2.5;
  press.run();
  EXPECT_EQ(press.falls, 0);
  EXPECT_EQ(press.unfelt, 0);
  EXPECT_LT(press.largest_force_error, 0.01);
}

/// At a thin lip of the skin a ball goes through. The field itself pushes less there, which quadrature confirms.
TEST(Press, HasTheForceOfTheFieldOnTheShadowFingertip) {
  const TriMeshPtr mesh = repaired_mesh("meshes/shadow_f_distal_pst.stl");
  if (!mesh) GTEST_SKIP() << "the real meshes are absent: " << TAXEL_REAL_DATA;
  Press press(*mesh);
  press.run();
  EXPECT_EQ(press.unexplained_falls, 0);
  EXPECT_LT(press.falls, 40);
  EXPECT_EQ(press.unfelt, 0);
  EXPECT_LT(press.largest_area_error, 0.005);
  EXPECT_LT(press.largest_force_error, 0.02);
}

TEST(Press, HasTheForceOfTheFieldOnThePapersFinger) {
  const TriMeshPtr mesh = repaired_mesh("paper/ubi_tip_collision.stl");
  if (!mesh) GTEST_SKIP() << "the real meshes are absent: " << TAXEL_REAL_DATA;
  Press press(*mesh);
  press.run();
  EXPECT_EQ(press.unexplained_falls, 0);
  EXPECT_LT(press.falls, 15);
  EXPECT_EQ(press.unfelt, 0);
  EXPECT_LT(press.largest_area_error, 0.005);
  EXPECT_LT(press.largest_force_error, 0.02);
}

}  // namespace
}  // namespace taxel
