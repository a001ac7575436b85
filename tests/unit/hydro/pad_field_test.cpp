// Pads on meshes: stiffness, volume and folds on smooth, sharp and concave shapes.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <filesystem>

#include "core/base/error.h"
#include "core/base/math.h"
#include "core/base/rng.h"
#include "core/hydro/fields/pressure_field.h"
#include "core/mesh/make/primitives.h"
#include "core/mesh/mesh_io.h"
#include "core/mesh/query/closest_point.h"
#include "fixtures/field_checks.h"
#include "fixtures/pad_checks.h"
#include "fixtures/pad_meshes.h"
#include "fixtures/rough_meshes.h"

namespace taxel {
namespace {

constexpr double kModulus = 1e5;

/// Returns the fraction of the skin that has tets below it.
double covered(const PressureField& field, double skin) {
  double area = 0;
  for (const Tet& tet : field.tets()) {
    for (int i = 0; i < 4; ++i) {
      if (!field.is_skin(tet, i)) continue;
      const dvec3& a = field.vertices()[at(tet.vertices[(i + 1) % 4])];
      area += 0.5 * glm::length(glm::cross(field.vertices()[at(tet.vertices[(i + 2) % 4])] - a,
                                           field.vertices()[at(tet.vertices[(i + 3) % 4])] - a));
    }
  }
  return area / skin;
}

/// Returns the fraction of the pad that two tets fill.
double overlap(const PressureField& field) {
  const CounterRng rng(3);
  const Aabb& box = field.bounds();
  int filled = 0, twice = 0;
  const Bvh tree = tree_of_tets(field);
  for (std::uint64_t i = 0; i < 60000; ++i) {
    const dvec3 x = box.lo + box.extent() * dvec3(rng.uniform(3 * i), rng.uniform(3 * i + 1), rng.uniform(3 * i + 2));
    int inside = 0;
    tree.visit(
        [&](const Aabb& node) {
          return node.overlaps({x, x});
        },
        [&](int t) {
          const Tet& tet = field.tets()[at(t)];
          bool in = true;
          for (std::size_t k = 0; k < 4; ++k) in = in && glm::dot(tet.normal[k], x) + tet.offset[k] > 0;
          inside += in ? 1 : 0;
        });
    filled += inside > 0 ? 1 : 0;
    twice += inside > 1 ? 1 : 0;
  }
  EXPECT_GT(filled, 100);
  return static_cast<double>(twice) / filled;
}

/// Faces without a neighbour have either no pressure at all three corners, if they are on the skin, or a pressure at
/// all three.
void expect_open_at_skin_and_core_only(const PressureField& field, int skin_faces) {
  int skin = 0;
  for (const Tet& tet : field.tets()) {
    for (int i = 0; i < 4; ++i) {
      if (tet.neighbour[i] >= 0) continue;
      int without = 0;
      for (int k = 1; k < 4; ++k) without += field.vertex_pressure()[at(tet.vertices[(i + k) % 4])] == 0 ? 1 : 0;
      EXPECT_TRUE(without == 0 || without == 3);
      skin += without == 3 ? 1 : 0;
    }
  }
  EXPECT_EQ(skin, skin_faces);
}

/// Expects the stiffness E/H where nothing limits the pad.
void expect_good_pad(const TriMeshPtr& mesh, double thickness, double stiffness_cv, double bare = 0,
                     PadLayering layering = PadLayering::automatic) {
  // Other layerings than the automatic one may be uneven. Their skin is not refined.
  const double refine = layering == PadLayering::automatic ? kDefaultRefine : 0.0;
  const PressureFieldPtr field = make_pad_field(mesh, kModulus, thickness, {}, layering, refine);
  const FieldReport& report = field->report();
  EXPECT_EQ(report.inverted, 0);
  EXPECT_EQ(report.zero_gradient, 0);
  EXPECT_LE(report.stiffness_cv, stiffness_cv);
  EXPECT_GE(covered(*field, mesh->area()), 1 - bare - 1e-9);
  EXPECT_EQ(report.bare.faces == 0, bare == 0);
  EXPECT_LE(report.bare.area, bare * mesh->area());
  EXPECT_LE(field->max_pressure(), kModulus);
  expect_sound(*field, bare > 0 ? 1e-11 : 1e-13);
  // Neighbouring prisms, and the fillers of the gaps between diverging prisms, share their sides. Only the skin and the
  // rigid core are open.
  if (bare == 0) expect_open_at_skin_and_core_only(*field, mesh->face_count() + report.refined_faces);
  EXPECT_LT(overlap(*field), 2e-3);
  double area = 0, mean = 0;
  for (const Tet& tet : field->tets()) {
    for (int i = 0; i < 4; ++i) {
      if (!field->is_skin(tet, i)) continue;
      area += 1;
      mean += glm::length(tet.gradient);
    }
  }
  EXPECT_NEAR(mean / area, kModulus / thickness, 0.03 * kModulus / thickness);
}

TEST(PadField, HasTheStiffnessOfAnElastomerOnSmoothShapes) {
  expect_good_pad(share(make_fingertip()), 0.002, 0.01);
  expect_good_pad(share(make_icosphere(0.02, 3)), 0.004, 0.01);
  expect_good_pad(share(make_capsule(0.01, 0.02, 0.002)), 0.003, 0.01);
}

TEST(PadField, IsMitredAtSharpEdges) {
  expect_good_pad(share(make_box(dvec3(0.02, 0.03, 0.01))), 0.003, 1e-6);
  expect_good_pad(share(make_cylinder(0.01, 0.02, 0.002)), 0.002, 0.01);
  // The rigid core of a box is the box less H on every side, so the pad's volume is exact.
  const PressureFieldPtr field = make_pad_field(share(make_box(dvec3(0.02))), kModulus, 0.005);
  EXPECT_NEAR(field->max_pressure(), kModulus, 1e-9 * kModulus);
  Aabb core;
  for (std::size_t v = 8; v < 16; ++v) core.include(field->vertices()[v]);
  EXPECT_NEAR(core.lo.x, -0.015, 1e-12);
  EXPECT_NEAR(core.hi.z, 0.015, 1e-12);
}

TEST(PadField, HasNoGapsOnAConcaveShape) {
  expect_good_pad(share(make_spool()), 0.003, 0.06);
}

TEST(PadField, IsGoodOnRingsNotchesCupsAndRims) {
  expect_good_pad(share(make_torus(0.02, 0.006, 80, 32)), 0.002, 0.01);
  expect_good_pad(share(make_torus(0.02, 0.006, 80, 32)), 0.006, 0.01);
  expect_good_pad(share(make_l_block(0.005, 8)), 0.003, 1e-6);
  expect_good_pad(share(make_l_block(0.02, 2)), 0.005, 1e-6);
  expect_good_pad(share(make_thimble(0.008, 0.015, 0.0025, 0.001)), 0.002, 0.02);
  expect_good_pad(share(make_sharp_plate(0.03, 0.006, 0.002)), 0.002, 0.01);
  expect_good_pad(share(make_sharp_plate(0.03, 0.002, 0.002)), 0.001, 0.01);
}

double depth_error(const TriMeshPtr& mesh, double thickness) {
  return fidelity(*make_pad_field(mesh, kModulus, thickness), MeshIndex(mesh), kModulus, thickness, 20000).rms;
}

/// Below a concave edge, points of equal depth are on an arc, which additional inner vertices follow. One inner vertex
/// per skin vertex leaves 0.97 % on the step and 1.1 % on the cube.
TEST(PadField, SplitsNormalsAtSharpConcaveEdges) {
  const TriMeshPtr step = share(make_l_block(0.005, 8)), cube = share(make_notched_cube(0.005, 8));
  expect_good_pad(cube, 0.003, 1e-6);
  EXPECT_LT(depth_error(step, 0.003), 0.004);
  EXPECT_LT(depth_error(cube, 0.003), 0.006);
  EXPECT_GT(make_pad_field(step, kModulus, 0.003)->vertices().size(), 2 * step->vertices().size());
}

TEST(PadField, IsThinnerWhereTheBodyIsThin) {
  const TriMeshPtr plate = share(make_cylinder(0.02, 0.001, 0.002));
  const PressureFieldPtr field = make_pad_field(plate, kModulus, 0.004);
  EXPECT_GT(field->report().thickness_limited_fraction, 0.95);
  EXPECT_EQ(field->report().inverted, 0);
  EXPECT_LT(field->report().stiffness_cv, 0.06);  // the gradient stays E/H
  EXPECT_LT(overlap(*field), 2e-3);
  // E times the half thickness over H, less the margin to the medial axis.
  EXPECT_LE(field->max_pressure(), kModulus * 0.001 / 0.004 * 1.01);
  EXPECT_GE(field->max_pressure(), kModulus * 0.001 / 0.004 * 0.8);
}

/// A block with a pit from below, whose tip is 1.5 mm under the middle of a large face. The pad has enough room at all
/// corners of this face, but not in its middle.
TEST(PadField, StaysOnItsSideOfAWallBelowLargeFaces) {
  const TriMesh box = make_box(dvec3(0.02, 0.02, 0.005));
  std::vector<dvec3> vertices = box.vertices();
  std::vector<ivec3> faces;
  for (int f = 0; f < box.face_count(); ++f) {
    const ivec3 face = box.faces()[at(f)];
    if (box.face_normals()[at(f)].z > -0.5 || vertices.size() > 8) {
      faces.push_back(face);
      continue;
    }
    const dvec3 middle = (box.vertex(f, 0) + box.vertex(f, 1) + box.vertex(f, 2)) / 3.0;
    for (int c = 0; c < 3; ++c) faces.emplace_back(face[c], face[(c + 1) % 3], 8);
    vertices.emplace_back(middle.x, middle.y, 0.0035);
  }
  const TriMeshPtr block = share({vertices, faces});
  ASSERT_TRUE(block->closed());
  for (const double refine : {0.0, 2.0}) {
    const PressureFieldPtr field = make_pad_field(block, kModulus, 0.004, {}, PadLayering::automatic, refine);
    EXPECT_EQ(field->report().inverted, 0);
    EXPECT_LT(field->report().stiffness_cv, 0.01);
    // 0.4 and 2.6 % if only the corners are considered.
    EXPECT_LT(overlap(*field), refine > 0 ? 0.008 : 0.001);
  }
}

TEST(PadField, IsTheSameEveryTime) {
  const TriMeshPtr mesh = share(make_spool());
  const PressureFieldPtr a = make_pad_field(mesh, kModulus, 0.003), b = make_pad_field(mesh, kModulus, 0.003);
  EXPECT_EQ(a->vertices(), b->vertices());
  EXPECT_EQ(a->vertex_pressure(), b->vertex_pressure());
}

TEST(PadField, DoesNotDependOnTheNumberOfThreads) {
  for (const TriMeshPtr& mesh :
       {share(make_spool()), share(make_l_block(0.005, 8)), share(make_thimble(0.008, 0.015, 0.0025, 0.001)),
        share(make_rough_ball(2, 0.6, 2)), share(make_wedge())}) {
    const PressureFieldPtr many = make_pad_field(mesh, kModulus, 0.003);
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const PressureFieldPtr single = make_pad_field(mesh, kModulus, 0.003);
    EXPECT_EQ(many->vertices(), single->vertices());
    EXPECT_EQ(many->vertex_pressure(), single->vertex_pressure());
    ASSERT_EQ(many->tets().size(), single->tets().size());
    for (std::size_t t = 0; t < many->tets().size(); ++t)
      EXPECT_EQ(many->tets()[t].vertices, single->tets()[t].vertices);
  }
}

void expect_good_pad_on_file(const char* name, double scale, double thickness, double stiffness_cv, double bare = 0) {
  const std::filesystem::path file = std::filesystem::path(TAXEL_REAL_DATA) / "meshes" / name;
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no " << file;
  const LoadedMesh loaded = load_mesh(file, dvec3(scale));
  const TriMeshPtr mesh = share(extract_shells(*loaded.mesh, outer_shells(*loaded.mesh)));
  for (const PadLayering layering : {PadLayering::automatic, PadLayering::one, PadLayering::two})
    expect_good_pad(mesh, thickness, stiffness_cv, bare, layering);
}

TEST(PadField, IsGoodOnTheShadowFingertip) {
  expect_good_pad_on_file("shadow_f_distal_pst.stl", 0.001, 0.002, 0.02, 1e-4);
}
TEST(PadField, IsGoodOnTheBiotacFingertip) {
  expect_good_pad_on_file("shadow_f_distal_bt_sp.stl", 0.001, 0.002, 0.01);
}
TEST(PadField, IsGoodOnAPlate) {
  expect_good_pad_on_file("plate_8in_col.stl", 1, 0.002, 0.01);
}
TEST(PadField, IsGoodOnSpot) {
  expect_good_pad_on_file("spot/spot_triangulated.obj", 0.1, 0.005, 0.02);
}

std::string message_of(const TriMesh& mesh, double modulus, double thickness) {
  try {
    make_pad_field(share(mesh), modulus, thickness);
    return "";
  } catch (const Error& error) {
    return error.what();
  }
}

TEST(PadField, RefusesBadInput) {
  const TriMesh box = make_box(dvec3(1));
  EXPECT_EQ(message_of(box, 1, 0.1), "");
  EXPECT_NE(message_of(box, 0, 0.1).find("modulus"), std::string::npos);
  EXPECT_NE(message_of(box, 1, 0).find("thickness"), std::string::npos);
  EXPECT_NE(message_of(box, 1, std::nan("")).find("thickness"), std::string::npos);
  std::vector<ivec3> faces = box.faces();
  faces.pop_back();
  EXPECT_NE(message_of({box.vertices(), faces}, 1, 0.1).find("open"), std::string::npos);
  faces = box.faces();
  for (ivec3& f : faces) std::swap(f.x, f.y);
  EXPECT_NE(message_of({box.vertices(), faces}, 1, 0.1).find("inside out"), std::string::npos);
}

}  // namespace
}  // namespace taxel
