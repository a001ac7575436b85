// Pads of one and two layers of prisms: the same volume, shared faces, and the improvement by the second layer.
#include "core/base/math.h"
#include "core/hydro/pad/pad_field.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "core/base/rng.h"
#include "core/mesh/mesh_io.h"
#include "fixtures/field_checks.h"
#include "fixtures/pad_checks.h"
#include "fixtures/pad_meshes.h"

namespace taxel {
namespace {

constexpr double kModulus = 1e5;

struct Layered {
  PressureFieldPtr field;
  int middles = 0, faces = 0;
};

/// Returns a pad in which every offset vector requests a middle vertex with this probability.
Layered layered_at_random(const TriMeshPtr& mesh, double thickness, double probability) {
  const MeshIndex index(mesh);
  const PadShape shape(index, thickness);
  const CounterRng rng(5);
  std::vector<char> asked(at(shape.offset_count()));
  for (std::size_t offset = 0; offset < asked.size(); ++offset)
    asked[offset] = rng.uniform(offset) < probability ? 1 : 0;
  const PadLayers layers(shape, index, asked);
  std::vector<dvec3> vertices = mesh->vertices();
  for (int offset = 0; offset < shape.offset_count(); ++offset) vertices.push_back(shape.inner_position(offset));
  for (const int offset : layers.offsets()) {
    EXPECT_EQ(layers.middle(offset), static_cast<int>(vertices.size()));
    vertices.push_back(shape.moved(offset, layers.height(offset)));
    EXPECT_NEAR(-index.signed_distance(vertices.back()), layers.depth(offset), 1e-12);
  }
  const PadDepths depths = pad_depths(*mesh, shape, thickness);
  std::vector<double> pressure = pad_pressures(index, shape, layers, depths, kModulus, thickness);
  return {std::make_shared<const PressureField>(std::move(vertices), layers.tets(), std::move(pressure), FieldReport{}),
          static_cast<int>(layers.offsets().size()), layers.two_layer_faces()};
}

/// Returns meshes for all shapes of pads: convex and not, smooth and sharp, split normals, thin walls, collapsed
/// corners.
std::vector<std::pair<TriMeshPtr, double>> hard_meshes() {
  return {{share(make_torus(0.02, 0.006, 40, 16)), 0.006},
          {share(make_spool()), 0.003},
          {share(make_l_block(0.005, 8)), 0.003},
          {share(make_l_block(0.001, 10)), 0.0025},
          {share(make_notched_cube(0.005, 8)), 0.003},
          {share(make_thimble(0.008, 0.015, 0.0025, 0.002)), 0.002},
          {share(make_sharp_plate(0.03, 0.006, 0.004)), 0.002}};
}

/// A prism that is divided at any place fits its neighbours. The only open faces of tets are those of the skin and of
/// the rigid core, as with one layer, and the tets fill the same volume.
TEST(PadLayers, ShareFacesWhereverAPrismIsDivided) {
  for (const auto& [mesh, thickness] : hard_meshes()) {
    const PressureFieldPtr one = make_pad_field(mesh, kModulus, thickness, {}, PadLayering::one);
    EXPECT_EQ(one->report().two_layer_faces, 0);
    for (const double probability : {0.02, 0.3, 1.0}) {
      const auto [field, middles, faces] = layered_at_random(mesh, thickness, probability);
      EXPECT_GT(middles, 0);
      EXPECT_GE(faces, middles);
      EXPECT_EQ(field->report().inverted, 0);
      EXPECT_EQ(field->report().zero_gradient, 0);
      expect_sound(*field, 1e-12);
      EXPECT_EQ(boundary_faces(*field), boundary_faces(*one));
      EXPECT_NEAR(field_volume(*field), field_volume(*one), 1e-12 * field_volume(*one));
    }
  }
}

TEST(PadLayers, AreExactOnFlatFaces) {
  const TriMeshPtr block = share(make_of_cubes(0.005, 6, [](const ivec3&) { return true; }));
  const PressureFieldPtr one = make_pad_field(block, kModulus, 0.004, {}, PadLayering::one);
  for (const double probability : {0.1, 1.0}) {
    const Layered pad = layered_at_random(block, 0.004, probability);
    EXPECT_GT(pad.middles, 20);
    const Fidelity good = fidelity(*pad.field, MeshIndex(block), kModulus, 0.004, 5000);
    EXPECT_EQ(good.filled, fidelity(*one, MeshIndex(block), kModulus, 0.004, 5000).filled);
    EXPECT_LT(good.worst, 1e-12);
  }
}

double error_of(const TriMeshPtr& mesh, double thickness, PadLayering layering, int points = 20000) {
  const PressureFieldPtr field = make_pad_field(mesh, kModulus, thickness, {}, layering);
  return fidelity(*field, MeshIndex(mesh), kModulus, thickness, points).rms;
}

/// On a smooth skin one layer is sufficient: its error falls with the square of the edge length, and a second layer
/// does not help.
TEST(PadLayers, NeedOneLayerBelowASmoothSkin) {
  const TriMeshPtr coarse = share(make_torus(0.02, 0.006, 30, 12)), fine = share(make_torus(0.02, 0.006, 60, 24));
  const double one = error_of(fine, 0.002, PadLayering::one, 5000), two = error_of(fine, 0.002, PadLayering::two, 5000);
  EXPECT_GT(std::log2(error_of(coarse, 0.002, PadLayering::one, 5000) / one), 1.9);
  EXPECT_GT(std::log2(error_of(coarse, 0.002, PadLayering::two, 5000) / two), 1.9);
  EXPECT_NEAR(two, one, 0.1 * one);
  const PressureFieldPtr field = make_pad_field(fine, kModulus, 0.002);
  EXPECT_EQ(field->report().two_layer_faces, 0);
  EXPECT_EQ(field->tets().size(), 3 * fine->faces().size());
}

/// A concave edge whose pieces are too short for split normals. The stiffness at the skin needs a small pressure at the
/// inner vertices, the distance to the skin a large one. One layer keeps its error for any fineness of the mesh.
TEST(PadLayers, FollowTheDistanceBelowShortConcaveEdgesWithTwo) {
  const TriMeshPtr coarse = share(make_l_block(0.001, 10)), fine = share(make_l_block(0.0005, 20));
  constexpr double kThickness = 0.0025;
  const double one = error_of(fine, kThickness, PadLayering::one);
  EXPECT_GT(one, 0.95 * error_of(coarse, kThickness, PadLayering::one));
  EXPECT_LT(error_of(fine, kThickness, PadLayering::automatic), 0.67 * one);
  EXPECT_LT(error_of(coarse, kThickness, PadLayering::automatic), 0.78 * one);
  const PressureFieldPtr field = make_pad_field(fine, kModulus, kThickness);
  EXPECT_LT(field->report().stiffness_cv, 1e-3);
  EXPECT_GT(field->report().two_layer_faces, 100);
  EXPECT_LT(field->tets().size(), 1.05 * 3 * static_cast<double>(fine->face_count()));
}

/// Fillets of less than 1 mm below a pad of 2 mm.
TEST(PadLayers, ImproveTheShadowFingertipWithTwo) {
  const std::filesystem::path file = std::filesystem::path(TAXEL_REAL_DATA) / "meshes/shadow_f_distal_pst.stl";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no " << file;
  const LoadedMesh loaded = load_mesh(file, dvec3(0.001));
  const TriMeshPtr mesh = share(extract_shells(*loaded.mesh, outer_shells(*loaded.mesh)));
  EXPECT_LT(error_of(mesh, 0.002, PadLayering::automatic), 0.75 * error_of(mesh, 0.002, PadLayering::one));
  const PressureFieldPtr field = make_pad_field(mesh, kModulus, 0.002);
  const int of_prisms = field->report().tets - 3 * field->report().caps;
  EXPECT_LT(of_prisms, 1.03 * 3 * (mesh->face_count() + field->report().refined_faces));
}

TEST(PadLayers, ReportAnEstimateOfTheError) {
  const TriMeshPtr block = share(make_l_block(0.0005, 20)), torus = share(make_torus(0.02, 0.006, 30, 12));
  for (const PadLayering layering : {PadLayering::one, PadLayering::automatic}) {
    const FieldReport report = make_pad_field(block, kModulus, 0.0025, {}, layering)->report();
    const double error = error_of(block, 0.0025, layering);
    EXPECT_NEAR(report.depth_error_rms, error, 0.3 * error);
    EXPECT_GT(report.depth_error_mean, 0);
    EXPECT_LT(report.depth_error_mean, report.depth_error_rms);
  }
  const double error = error_of(torus, 0.002, PadLayering::one, 5000);
  EXPECT_NEAR(make_pad_field(torus, kModulus, 0.002)->report().depth_error_rms, error, 0.05 * error);
}

}  // namespace
}  // namespace taxel
