// Pressure fields on tets: planes, gradients, neighbours and quality.
#include "core/hydro/fields/pressure_field.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/base/rng.h"
#include "core/mesh/make/primitives.h"
#include "fixtures/field_checks.h"
#include "fixtures/slab_field.h"

namespace taxel {
namespace {

TEST(PressureField, HasValidPlanesGradientsAndNeighbours) {
  const PressureFieldPtr slab = make_slab_field({0.02, 0.03}, 0.01, {3, 2, 2}, 1e7);
  expect_sound(*slab);
  EXPECT_NEAR(field_volume(*slab), 4 * 0.02 * 0.03 * 0.01, 1e-18);
  EXPECT_EQ(slab->report().tets, 3 * 2 * 2 * 6);
  EXPECT_NEAR(slab->report().stiffness_cv, 0, 1e-6);
  EXPECT_NEAR(slab->max_pressure(), 1e5, 1e-9);
  for (const Tet& tet : slab->tets()) EXPECT_LE(glm::distance(tet.gradient, dvec3(0, 0, -1e7)), 1e-12 * 1e7);
}

TEST(PressureField, IsValidOnADistortedGrid) {
  const PressureFieldPtr slab = make_slab_field(dvec2(1), 1, ivec3(3), 1);
  std::vector<dvec3> vertices = slab->vertices();
  const CounterRng rng(9);
  for (std::size_t i = 0; i < 3 * vertices.size(); ++i)
    vertices[i / 3][static_cast<int>(i % 3)] += 0.1 * rng.uniform(i);
  std::vector<ivec4> tets;
  for (const Tet& tet : slab->tets()) tets.push_back(tet.vertices);
  expect_sound(PressureField(vertices, tets, slab->vertex_pressure(), {}));
}

TEST(PressureField, ReorientsAndCountsInvertedTets) {
  const std::vector<dvec3> x{dvec3(0), dvec3(1, 0, 0), dvec3(0, 1, 0), dvec3(0, 0, 1), dvec3(1, 1, 1)};
  const PressureField field(x, {{0, 1, 2, 3}, {2, 1, 3, 4}}, {0, 0, 0, 1, 1}, {});
  EXPECT_EQ(field.report().inverted, 1);
}

TEST(PressureField, CountsTetsWithConstantPressure) {
  const std::vector<dvec3> x{dvec3(0), dvec3(1, 0, 0), dvec3(0, 1, 0), dvec3(0, 0, 1), dvec3(1, 1, 1)};
  EXPECT_EQ(PressureField(x, {{0, 1, 2, 3}, {1, 2, 3, 4}}, {0, 2, 2, 2, 2}, {}).report().zero_gradient, 1);
}

std::string message_of(const std::vector<ivec4>& tets, const std::vector<double>& p) {
  const std::vector<dvec3> x{dvec3(0),       dvec3(1, 0, 0), dvec3(0, 1, 0),    dvec3(0, 0, 1),
                             dvec3(1, 1, 1), dvec3(2, 1, 1), dvec3(0.5, 0.5, 0)};
  try {
    const PressureField field(x, tets, p, {});
    return "";
  } catch (const Error& error) {
    return error.what();
  }
}

TEST(PressureField, NamesBadInput) {
  const std::vector<double> p(7, 0.0);
  EXPECT_EQ(message_of({{0, 1, 2, 3}}, p), "");
  EXPECT_NE(message_of({{0, 1, 2, 3}, {0, 1, 2, 6}}, p).find("tet 1"), std::string::npos);  // a flat tet
  EXPECT_NE(message_of({{0, 1, 2, 9}}, p).find("no vertex 9"), std::string::npos);
  EXPECT_NE(message_of({{0, 1, 2, 3}, {1, 2, 3, 4}, {1, 2, 3, 5}}, p).find("share one face"), std::string::npos);
  EXPECT_NE(message_of({{0, 1, 2, 3}}, {0, 0, -1, 0, 0, 0, 0}).find("vertex 2"), std::string::npos);
  EXPECT_NE(message_of({{0, 1, 2, 3}}, {0, 0}).find("2 pressures"), std::string::npos);
}

TEST(StarField, EqualsTheMedialAxisFieldOfASphere) {
  const PressureFieldPtr sphere = make_sphere_field(0.02, 1e5, 0.004);
  expect_sound(*sphere);
  EXPECT_NEAR(field_volume(*sphere), 4.0 / 3 * kPi * 8e-6, 1e-12);  // scaled to the true volume
  EXPECT_EQ(sphere->report().inverted, 0);
  EXPECT_LT(sphere->report().stiffness_cv, 0.01);
  EXPECT_EQ(sphere->max_pressure(), 1e5);
}

TEST(StarField, ReportsTheVariationOfItsStiffness) {
  const auto capsule = std::make_shared<const TriMesh>(make_capsule(0.01, 0.02, 0.002));
  const PressureFieldPtr field = make_star_field(capsule, 1e5);
  expect_sound(*field);
  EXPECT_EQ(field->report().inverted, 0);
  EXPECT_GT(field->report().stiffness_cv, 0.1);
  EXPECT_NEAR(field_volume(*field), capsule->volume(), 1e-10 * capsule->volume());
  // Tets below a dent that is not visible from the centroid are inverted.
  TriMesh ball = make_icosphere(0.01, 3);
  std::vector<dvec3> vertices = ball.vertices();
  for (dvec3& v : vertices) v.x = v.x > 0.004 ? -0.9 * v.x : v.x;
  EXPECT_GT(make_star_field(std::make_shared<const TriMesh>(vertices, ball.faces()), 1e5)->report().inverted, 0);
}

}  // namespace
}  // namespace taxel
