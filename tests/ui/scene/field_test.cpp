// Receptive fields as pieces of the skin, by straight and geodesic distance, and their coverage of the skin.
#include <gtest/gtest.h>

#include "core/mesh/make/primitives.h"
#include "ui/scene/geometry/field_patch.h"

namespace taxel::ui {
namespace {

/// Returns a model with a layout on a skin, as complete as receptive fields need it.
SensorModel model_on(TriMesh mesh, std::vector<Taxel> taxels, Metric metric = Metric::euclidean, double angle = 45) {
  SensorModel model;
  model.mesh = std::make_shared<const TriMesh>(std::move(mesh));
  model.skin = std::make_shared<const MeshIndex>(model.mesh);
  model.layout.taxels = std::move(taxels);
  model.layout.receptive_field = {metric, angle};
  return model;
}

Taxel taxel_at(const dvec3& center, const dvec3& normal, double radius) {
  Taxel taxel;
  taxel.center = center;
  taxel.normal = normal;
  taxel.radius = radius;
  return taxel;
}

TriMesh square(double half) {
  return TriMesh({{-half, -half, 0}, {half, -half, 0}, {half, half, 0}, {-half, half, 0}}, {{0, 1, 2}, {0, 2, 3}});
}

/// Returns an L-shaped surface: the floor z = 0 for x > 0, and a wall x = 0 for z > 0.
TriMesh fold(double size) {
  return TriMesh({{0, -size, 0}, {size, -size, 0}, {size, size, 0}, {0, size, 0}, {0, -size, size}, {0, size, size}},
                 {{0, 1, 2}, {0, 2, 3}, {0, 3, 5}, {0, 5, 4}});
}

double boundary_length(const FieldPatch& patch) {
  double sum = 0;
  for (const RingPiece& piece : patch.boundary) sum += glm::length(piece.b - piece.a);
  return sum;
}

TEST(FieldPatch, IsTheSameDiscOnAPlaneForBothMetrics) {
  const double r = 0.2;
  const SensorModel model = model_on(square(1), {taxel_at({0.13, -0.2, 0}, {0, 0, 1}, r)});
  for (const FieldPart part : {FieldPart::euclidean, FieldPart::geodesic}) {
    const FieldPatch patch = taxel_patches(model, part)[0];
    EXPECT_NEAR(patch.area, kPi * r * r, 0.01 * kPi * r * r);
    EXPECT_NEAR(boundary_length(patch), 2 * kPi * r, 0.01 * 2 * kPi * r);
    for (const SkinPiece& piece : patch.pieces) {
      EXPECT_GE(glm::cross(piece.b - piece.a, piece.c - piece.a).z, 0);  // same winding as the face
    }
  }
  EXPECT_NEAR(taxel_patches(model, FieldPart::euclidean_only)[0].area, 0, 1e-3 * kPi * r * r);
}

TEST(FieldPatch, IsASmallerDiscForACentreAboveAPlane) {
  const double r = 0.2, h = 0.12;
  const SensorModel model = model_on(square(1), {taxel_at({0, 0, h}, {0, 0, 1}, r)});
  EXPECT_NEAR(taxel_patches(model, FieldPart::euclidean)[0].area, kPi * (r * r - h * h), 0.02 * kPi * r * r);
  EXPECT_NEAR(taxel_patches(model, FieldPart::geodesic)[0].area, kPi * r * r, 0.01 * kPi * r * r);
}

TEST(FieldPatch, CrossesAGapOnlyByStraightDistance) {
  // A thin plate: its lower face is 0.02 away straight through the plate, and far away along the surface around its
  // rim. Both distances are perpendicular to the normal.
  const double r = 0.1, thick = 0.02;
  const SensorModel model = model_on(make_box({0.5, 0.5, 0.5 * thick}), {taxel_at({0, 0, 0.5 * thick}, {1, 0, 0}, r)},
                                     Metric::euclidean, 100);
  const double upper = kPi * r * r, lower = kPi * (r * r - thick * thick);
  EXPECT_NEAR(taxel_patches(model, FieldPart::euclidean)[0].area, upper + lower, 0.02 * upper);
  EXPECT_NEAR(taxel_patches(model, FieldPart::geodesic)[0].area, upper, 0.01 * upper);
  EXPECT_NEAR(taxel_patches(model, FieldPart::euclidean_only)[0].area, lower, 0.02 * upper);
}

TEST(FieldPatch, IsTheUnfoldedDiscAcrossAFoldIfGeodesic) {
  const double r = 0.3, d = 0.1;  // distance from the edge
  const SensorModel model = model_on(fold(1), {taxel_at({d, 0, 0}, {0, 0, 1}, r)}, Metric::geodesic, 180);
  // Unfolded, the wall continues the floor, so the geodesic field is the whole disc. By straight distance the wall is
  // cut by a circle about (0, 0, 0).
  EXPECT_NEAR(taxel_patches(model, FieldPart::geodesic)[0].area, kPi * r * r, 0.01 * kPi * r * r);
  const double segment = r * r * std::acos(d / r) - d * std::sqrt(r * r - d * d);
  const double straight = kPi * r * r - segment + 0.5 * kPi * (r * r - d * d);
  EXPECT_NEAR(taxel_patches(model, FieldPart::euclidean)[0].area, straight, 0.01 * straight);
  EXPECT_NEAR(taxel_patches(model, FieldPart::euclidean_only)[0].area, straight - kPi * r * r, 0.01 * straight);
}

TEST(FieldPatch, StaysWithinTheAngle) {
  const SensorModel model = model_on(fold(1), {taxel_at({0.1, 0, 0}, {0, 0, 1}, 0.3)});
  const FieldPatch patch = taxel_patches(model, FieldPart::euclidean)[0];
  EXPECT_FALSE(patch.pieces.empty());
  for (const SkinPiece& piece : patch.pieces) EXPECT_LT(piece.face, 2);
}

TEST(Coverage, EqualsTheAreaOfOneDiscInASquare) {
  const double r = 0.5;
  for (const Metric metric : {Metric::euclidean, Metric::geodesic}) {
    const Coverage coverage = make_coverage(model_on(square(1), {taxel_at({0, 0, 0}, {0, 0, 1}, r)}, metric));
    EXPECT_GE(coverage.pieces.size(), 40'000u);
    EXPECT_NEAR(coverage.area, 4, 1e-12);
    EXPECT_NEAR(coverage.uncovered(), 4 - kPi * r * r, 0.004);
    EXPECT_EQ(coverage.shared(), 0);
    EXPECT_NEAR(coverage.overlap(), 1, 1e-12);
    double sum = 0;
    for (const double a : coverage.area_of_overlap) sum += a;
    EXPECT_NEAR(sum, coverage.area, 1e-9);
  }
}

TEST(Coverage, IsSharedInTheLensOfTwoDiscs) {
  const double r = 0.4, apart = 0.4;
  const Coverage coverage =
      make_coverage(model_on(square(1), {taxel_at({-0.2, 0, 0}, {0, 0, 1}, r), taxel_at({0.2, 0, 0}, {0, 0, 1}, r)}));
  const double lens = 2 * r * r * std::acos(apart / (2 * r)) - 0.5 * apart * std::sqrt(4 * r * r - apart * apart);
  EXPECT_NEAR(coverage.shared(), lens, 0.004);
  EXPECT_NEAR(coverage.uncovered(), 4 - 2 * kPi * r * r + lens, 0.006);
  EXPECT_NEAR(coverage.overlap(), 2 * kPi * r * r / (2 * kPi * r * r - lens), 0.005);
}

TEST(Coverage, CountsSubtaxelsOfOneTaxelOnce) {
  Taxel taxel = taxel_at({0, 0, 0}, {0, 0, 1}, 1);
  taxel.subtaxels = {{{-0.1, 0, 0}, {0, 0, 1}, 0.3}, {{0.1, 0, 0}, {0, 0, 1}, 0.3}};
  EXPECT_EQ(make_coverage(model_on(square(1), {taxel})).shared(), 0);
}

TEST(Coverage, IsZeroWithoutTaxels) {
  const Coverage coverage = make_coverage(model_on(square(1), {}), 100);
  EXPECT_NEAR(coverage.uncovered(), 4, 1e-12);
  EXPECT_EQ(coverage.overlap(), 0);
}

}  // namespace
}  // namespace taxel::ui
