// Samples on surfaces where distances in space mislead: walls back to back, sheets above each other, sharp edges. The
// distances along these surfaces are known, because the surfaces can be flattened by hand.
#include <gtest/gtest.h>

#include "app/validate/sample_score.h"
#include "core/layout/sampling/poisson_disk.h"
#include "core/mesh/make/primitives.h"

namespace taxel {
namespace {

double densest(const TriMesh& mesh, std::size_t count) {
  return std::sqrt(2.0 * mesh.area() / (std::sqrt(3.0) * static_cast<double>(count)));
}

/// Returns the smallest of all distances.
template <class Distance>
double least_distance(const std::vector<SurfaceSample>& samples, const Distance& distance) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < samples.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) least = std::min(least, distance(samples[i], samples[j]));
  return least;
}

TriMesh joined(const std::vector<TriMesh>& parts) {
  std::vector<dvec3> vertices;
  std::vector<ivec3> faces;
  for (const TriMesh& part : parts) {
    for (const ivec3& f : part.faces()) faces.push_back(f + ivec3(static_cast<int>(vertices.size())));
    vertices.insert(vertices.end(), part.vertices().begin(), part.vertices().end());
  }
  return {std::move(vertices), std::move(faces)};
}

TriMesh moved(const TriMesh& mesh, const dvec3& by) {
  std::vector<dvec3> vertices = mesh.vertices();
  for (dvec3& v : vertices) v += by;
  return {std::move(vertices), mesh.faces()};
}

// Two rectangles that meet at an edge of 30 degrees. Flattened, they are one square: the distance from the edge is x.
TEST(SampleWalls, KeepTheirDistanceOverASharpEdge) {
  const double angle = kPi / 6.0, size = 0.01;
  const dvec3 along(0, 2.0 * size, 0), a(size, 0, 0), b(size * std::cos(angle), 0, size * std::sin(angle));
  const TriMesh wedge({dvec3(0), along, a, a + along, b, b + along},
                      {ivec3(0, 1, 2), ivec3(1, 3, 2), ivec3(0, 4, 1), ivec3(1, 4, 5)});
  const auto flat = [&](const SurfaceSample& s) {
    const double from_edge = glm::length(dvec2(s.position.x, s.position.z));
    return dvec2(s.face < 2 ? -from_edge : from_edge, s.position.y);
  };
  for (const SampleQuality quality : {SampleQuality::preview, SampleQuality::polished}) {
    const auto samples = sample_surface(wedge, 1000, 42, nullptr, quality);
    const double least = least_distance(
        samples, [&](const SurfaceSample& s, const SurfaceSample& t) { return glm::distance(flat(s), flat(t)); });
    EXPECT_GE(least / densest(wedge, samples.size()), quality == SampleQuality::polished ? 0.78 : 0.55);
  }
}

// A plate with a thickness of a fifth of the spacing. The path from wall to wall leads around the rim.
TEST(SampleWalls, KeepTheirDistanceAroundTheRimOfAThinPlate) {
  const double half = 0.01, t = 0.0001;
  const TriMesh plate = make_box(dvec3(half, half, 0.5 * t));
  for (const SampleQuality quality : {SampleQuality::preview, SampleQuality::polished}) {
    const auto samples = sample_surface(plate, 2000, 42, nullptr, quality);
    const double least = least_distance(samples, [&](const SurfaceSample& a, const SurfaceSample& b) {
      // On one wall, or on the rim.
      if (!(a.normal.z * b.normal.z < -0.5)) return glm::distance(a.position, b.position);
      double way = std::numeric_limits<double>::infinity();  // path over one of the four sides of the rim
      for (const int axis : {0, 1})
        for (const double side : {-1.0, 1.0}) {
          const double across = 2.0 * half - side * (a.position[axis] + b.position[axis]) + t;
          const double beside = a.position[1 - axis] - b.position[1 - axis];
          way = std::min(way, glm::length(dvec2(across, beside)));
        }
      return way;
    });
    EXPECT_GE(least / densest(plate, samples.size()), quality == SampleQuality::polished ? 0.74 : 0.55);
  }
}

// Walls back to back and sheets above each other do not affect each other: each is as uniform as alone.
TEST(SampleWalls, AreUniformOnEachOfStackedPlates) {
  const TriMesh plate = make_box(dvec3(0.01, 0.01, 0.0001));
  const std::vector<TriMesh> plates = {plate, moved(plate, dvec3(0, 0, 0.0003))};
  const TriMesh stack = joined(plates);
  const auto samples = sample_surface(stack, 4000, 42);
  for (std::size_t k = 0; k < plates.size(); ++k) {
    std::vector<SurfaceSample> own;
    for (const SurfaceSample& s : samples)
      if (stack.shell_of_face()[static_cast<std::size_t>(s.face)] == static_cast<int>(k)) own.push_back(s);
    EXPECT_NEAR(static_cast<double>(own.size()), 2000.0, 20.0);
    const SampleScore score = score_samples(plates[k], own);
    EXPECT_GE(score.rho_min, 0.75);
    EXPECT_GE(score.rho_mean, 0.90);
    EXPECT_LE(score.area_cv, 0.11);
    EXPECT_LE(score.gap, 2.0);
  }
}

}  // namespace
}  // namespace taxel
