// Refinement of a pad's skin: the same surface, refined only where the pad is uneven, with a uniform field.
#include "core/base/math.h"
#include "core/hydro/pad/pad_field.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "core/base/error.h"
#include "core/mesh/mesh_io.h"
#include "core/mesh/repair/repair.h"
#include "fixtures/field_checks.h"
#include "fixtures/pad_meshes.h"
#include "fixtures/rough_meshes.h"

namespace taxel {
namespace {

constexpr double kModulus = 1e5;

double longest_edge(const TriMesh& mesh, int face) {
  double longest = 0;
  for (int c = 0; c < 3; ++c)
    longest = std::max(longest, glm::distance(mesh.vertex(face, c), mesh.vertex(face, (c + 1) % 3)));
  return longest;
}

double least_angle(const TriMesh& mesh) {
  double least = kPi;
  for (int f = 0; f < mesh.face_count(); ++f) {
    for (int c = 0; c < 3; ++c) {
      const dvec3& x = mesh.vertex(f, c);
      least = std::min(least, angle_between(mesh.vertex(f, (c + 1) % 3) - x, mesh.vertex(f, (c + 2) % 3) - x));
    }
  }
  return least;
}

/// Expects every face to be inside its original face, and the faces of an original face to have its area.
void expect_same_surface(const TriMesh& fine, const std::vector<int>& face_of, const TriMesh& mesh) {
  ASSERT_TRUE(fine.closed());
  ASSERT_EQ(face_of.size(), fine.faces().size());
  EXPECT_NEAR(fine.volume(), mesh.volume(), 1e-13 * mesh.volume());
  for (int v = 0; v < mesh.vertex_count(); ++v) EXPECT_EQ(fine.vertices()[at(v)], mesh.vertices()[at(v)]);
  std::vector<double> area(mesh.faces().size(), 0.0);
  for (int f = 0; f < fine.face_count(); ++f) {
    const int old = face_of[at(f)];
    area[at(old)] += fine.face_areas()[at(f)];
    EXPECT_LT(glm::distance(fine.face_normals()[at(f)], mesh.face_normals()[at(old)]), 1e-10);
    for (int c = 0; c < 3; ++c) {
      const double height = glm::dot(fine.vertex(f, c) - mesh.vertex(old, 0), mesh.face_normals()[at(old)]);
      EXPECT_NEAR(height, 0, 1e-15);
    }
  }
  for (std::size_t f = 0; f < area.size(); ++f) EXPECT_NEAR(area[f], mesh.face_areas()[f], 1e-12 * area[f]);
}

TEST(PadRefine, BisectsLongestEdgesUntilNoneIsTooLong) {
  for (const TriMesh& mesh :
       {make_box(dvec3(0.02, 0.03, 0.01)), make_rough_ball(1, 0.6, 3), make_wedge(), make_torus(0.02, 0.006, 12, 5)}) {
    const RefinedSkin fine = refine_skin(mesh, std::vector<char>(mesh.faces().size(), 1), 0.004, 1000000);
    EXPECT_GT(fine.mesh->face_count(), 2 * mesh.face_count());
    expect_same_surface(*fine.mesh, fine.face_of, mesh);
    for (int f = 0; f < fine.mesh->face_count(); ++f) EXPECT_LE(longest_edge(*fine.mesh, f), 0.004);
    // Rosenberg, Stenger (1975): no angle is less than half of the smallest angle before.
    EXPECT_GE(least_angle(*fine.mesh), 0.5 * least_angle(mesh) * (1 - 1e-9));
  }
}

/// The longest edge of a wanted face may be a shorter edge of the face on the other side, which must not be divided
/// there.
TEST(PadRefine, KeepsAnglesAlsoAroundTheWantedFaces) {
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    const TriMesh mesh = stretched(make_rough_ball(1, 0.6, seed), dvec3(1, 0.3, 0.6));
    for (std::size_t i = 0; i < 3; ++i) {
      std::vector<char> wanted(mesh.faces().size(), 0);
      for (std::size_t f = i; f < wanted.size(); f += 7) wanted[f] = 1;
      const RefinedSkin fine = refine_skin(mesh, wanted, 0.002, 1000000);
      expect_same_surface(*fine.mesh, fine.face_of, mesh);
      EXPECT_GE(least_angle(*fine.mesh), 0.5 * least_angle(mesh) * (1 - 1e-9));
    }
  }
}

/// Only wanted faces are refined, and faces around them that paths of longest edges reach.
TEST(PadRefine, LeavesUnwantedFacesThatAreFarAway) {
  const TriMesh mesh = make_of_cubes(0.01, 6, [](const ivec3&) { return true; });
  std::vector<char> wanted(mesh.faces().size(), 0);
  wanted[0] = 1;
  const RefinedSkin fine = refine_skin(mesh, wanted, 0.003, 1000000);
  expect_same_surface(*fine.mesh, fine.face_of, mesh);
  int untouched = 0;
  for (int f = 0; f < mesh.face_count(); ++f) untouched += fine.mesh->faces()[at(f)] == mesh.faces()[at(f)] ? 1 : 0;
  EXPECT_GE(untouched, mesh.face_count() - 20);
  int parts = 0;
  for (int f = 0; f < fine.mesh->face_count(); ++f) {
    if (fine.face_of[at(f)] == 0) {
      ++parts;
      EXPECT_LE(longest_edge(*fine.mesh, f), 0.003);
    }
  }
  EXPECT_GT(parts, 1);
}

TEST(PadRefine, StopsAtTheMaximumNumberOfFaces) {
  const TriMesh mesh = make_rough_ball(1, 0.6, 3);
  const RefinedSkin fine = refine_skin(mesh, std::vector<char>(80, 1), 1e-4, 301);
  EXPECT_EQ(fine.mesh->face_count(), 300);
  expect_same_surface(*fine.mesh, fine.face_of, mesh);
  double longest = 0, longest_before = 0;
  for (int f = 0; f < 300; ++f) longest = std::max(longest, longest_edge(*fine.mesh, f));
  for (int f = 0; f < 80; ++f) longest_before = std::max(longest_before, longest_edge(mesh, f));
  EXPECT_LT(longest, 0.8 * longest_before);  // the longest edges are divided first
}

TEST(PadRefine, LeavesUniformSkinUnchanged) {
  for (const auto& [mesh, thickness] :
       std::vector<std::pair<TriMeshPtr, double>>{{share(make_fingertip()), 0.002},
                                                  {share(make_fingertip()), 0.0005},
                                                  {share(make_icosphere(0.02, 0)), 0.001},
                                                  {share(make_icosphere(0.02, 2)), 0.0005},
                                                  {share(make_box(dvec3(0.02, 0.03, 0.01))), 0.001},
                                                  {share(make_l_block(0.02, 2)), 0.005},
                                                  {share(make_sharp_plate(0.03, 0.006, 0.015)), 0.002}})
    EXPECT_EQ(make_pad_field(mesh, kModulus, thickness)->report().refined_faces, 0);
}

TEST(PadRefine, IsMeasuredInThicknesses) {
  const TriMeshPtr wedge = share(make_wedge());
  const auto added = [&](double refine) {
    return make_pad_field(wedge, kModulus, 0.002, {}, PadLayering::automatic, refine)->report().refined_faces;
  };
  EXPECT_EQ(added(0), 0);
  EXPECT_EQ(added(100), 0);  // no edge is that long
  EXPECT_GT(added(4), 10);
  EXPECT_GT(added(2), 2 * added(4));
  EXPECT_THROW(added(-1), Error);
  EXPECT_THROW(added(std::nan("")), Error);
}

/// The report names faces by the numbers that the user knows.
TEST(PadRefine, KeepsTheNumbersOfTheFaces) {
  const TriMeshPtr mesh = share(stretched(make_rough_ball(1, 0.6, 3), dvec3(1, 0.15, 0.7)));
  std::vector<int> numbers;
  for (int f = 0; f < mesh->face_count(); ++f) numbers.push_back(1000 + f);
  const FieldReport report = make_pad_field(mesh, kModulus, 0.002, numbers)->report();
  EXPECT_GT(report.refined_faces, 100);
  ASSERT_GT(report.limited.faces, 0);
  EXPECT_GE(report.limited.worst_face, 1000);
  EXPECT_LT(report.limited.worst_face, 1000 + mesh->face_count());
  const int own = make_pad_field(mesh, kModulus, 0.002)->report().limited.worst_face;
  EXPECT_EQ(own, report.limited.worst_face - 1000);
}

/// Lengths that are copied from the coarse shape equal recomputed lengths.
TEST(PadRefine, CopiesLengthsFromTheCoarseShape) {
  const TriMeshPtr mesh = share(make_rough_ball(1, 0.6, 3));
  const MeshIndex index(mesh);
  const PadShape coarse(index, 0.002);
  const MeshIndex fine(refine_skin(*mesh, std::vector<char>(80, 1), 0.004, 5000).mesh);
  const PadShape with(fine, 0.002, &coarse), without(fine, 0.002);
  ASSERT_EQ(with.offset_count(), without.offset_count());
  for (int offset = 0; offset < with.offset_count(); ++offset) {
    EXPECT_EQ(with.collapsed(offset), without.collapsed(offset));
    EXPECT_NEAR(with.length(offset), without.length(offset), 0.02 * 0.002);
  }
}

/// Targets of the project for a pad on a coarse skin.
void expect_even(const TriMeshPtr& mesh, double thickness, double deviation) {
  const PressureFieldPtr field = make_pad_field(mesh, kModulus, thickness);
  const FieldReport& report = field->report();
  EXPECT_EQ(report.inverted, 0);
  EXPECT_EQ(report.zero_gradient, 0);
  EXPECT_LE(report.stiffness_cv, 0.01);
  EXPECT_LE(report.bare.area, 0.005 * mesh->area());
  EXPECT_NEAR(report.press_errors[0].mean, 1, 0.02);
  EXPECT_LE(report.press_errors[0].deviation, deviation);
  const double before = report.tets / 4.0, least = 3.0 * mesh->face_count();
  EXPECT_TRUE(before <= least || report.tets <= 20000) << report.tets;
  expect_sound(*field, 1e-10);  // very thin tets next to slivers
}

TEST(PadRefine, MakesCoarseSkinUniform) {
  const TriMeshPtr ball = share(make_rough_ball(1, 0.6, 1));
  const auto deviation = [&](double refine) {
    return make_pad_field(ball, kModulus, 0.002, {}, PadLayering::automatic, refine)
        ->report()
        .press_errors[0]
        .deviation;
  };
  EXPECT_GT(deviation(0), 0.03);
  EXPECT_LT(deviation(2), 0.005);
  expect_even(share(make_wedge()), 0.002, 0.005);
  expect_even(share(make_torus(0.02, 0.006, 12, 5)), 0.002, 0.005);
  expect_even(share(make_cylinder(0.01, 0.02, 0.01)), 0.002, 0.005);
}

/// Random closed meshes of 20 to 320 triangles, flat and tall.
TEST(PadRefine, MakesRandomMeshesUniform) {
  const CounterRng rng(17);
  for (std::uint64_t i = 0; i < 24; ++i) {
    const TriMesh ball = make_rough_ball(static_cast<int>(i % 3), 0.5, 100 + i);
    const dvec3 by(1, 0.2 + 0.8 * rng.uniform(2 * i), 0.4 + 0.6 * rng.uniform(2 * i + 1));
    SCOPED_TRACE(i);
    expect_even(share(stretched(ball, by)), 0.002, 0.05);
  }
}

struct Skin {
  const char* name;
  const char* file;
  double scale, deviation;
};

class PadOfARealSkin : public testing::TestWithParam<Skin> {};

TEST_P(PadOfARealSkin, IsUniform) {
  const std::filesystem::path file = std::filesystem::path(TAXEL_REAL_DATA) / GetParam().file;
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no " << file;
  const TriMeshPtr mesh = repair_mesh(load_mesh(file, dvec3(GetParam().scale)).mesh, {}, 0.002)->mesh;
  expect_even(share(extract_shells(*mesh, outer_shells(*mesh))), 0.002, GetParam().deviation);
}

INSTANTIATE_TEST_SUITE_P(Skins, PadOfARealSkin,
                         testing::Values(Skin{"Paper", "paper/ubi_tip_collision.stl", 0.001, 0.03},
                                         Skin{"Shadow", "meshes/shadow_f_distal_pst.stl", 0.001, 0.02},
                                         Skin{"Biotac", "meshes/shadow_f_distal_bt_sp.stl", 0.001, 0.01},
                                         Skin{"Ability", "skins/ability_thumb.glb", 1, 0.01},
                                         Skin{"Inspire", "skins/inspire_thumb.obj", 1, 0.01},
                                         Skin{"Allegro", "skins/allegro_tip.stl", 1, 0.01},
                                         Skin{"Dclaw", "skins/dclaw_tip.obj", 1, 0.01},
                                         Skin{"Digit", "skins/digit_holder.stl", 0.001, 0.03},
                                         Skin{"Flange", "skins/gripper_flange.stl", 0.001, 0.04},
                                         Skin{"Leap", "skins/leap_pip.stl", 1, 0.04}),
                         [](const auto& skin) { return std::string(skin.param.name); });

}  // namespace
}  // namespace taxel
