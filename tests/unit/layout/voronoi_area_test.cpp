// Voronoi areas on surfaces: known cells, and counts of many points.
#include "core/layout/sampling/voronoi_area.h"

#include <gtest/gtest.h>

#include "core/base/rng.h"
#include "core/layout/sampling/poisson_disk.h"
#include "core/layout/sampling/surface_sample.h"
#include "core/mesh/make/primitives.h"

namespace taxel {
namespace {

/// Returns the unit square in two triangles.
TriMesh square() {
  return {{dvec3(0), dvec3(1, 0, 0), dvec3(1, 1, 0), dvec3(0, 1, 0)}, {ivec3(0, 1, 2), ivec3(0, 2, 3)}};
}

SurfaceSample on_square(double x, double y) {
  return {dvec3(x, y, 0), dvec3(0, 0, 1), 0, 0.0};
}

TEST(VoronoiArea, IsASquareForCellsOfAGrid) {
  std::vector<SurfaceSample> samples;
  for (int i = 0; i < 16; ++i)
    for (int j = 0; j < 16; ++j) samples.push_back(on_square((i + 0.5) / 16, (j + 0.5) / 16));
  assign_voronoi_areas(square(), samples);
  for (const SurfaceSample& s : samples) EXPECT_NEAR(s.area, 1.0 / 256, 1e-15);
}

TEST(VoronoiArea, DividesTwoSamplesAtTheBisector) {
  std::vector<SurfaceSample> samples = {on_square(0.1, 0.5), on_square(0.5, 0.5)};
  assign_voronoi_areas(square(), samples);
  EXPECT_NEAR(samples[0].area, 0.3, 1e-15);
  EXPECT_NEAR(samples[1].area, 0.7, 1e-15);
}

TEST(VoronoiArea, GivesTheAreaToTheFirstOfCoincidentSamples) {
  std::vector<SurfaceSample> samples(40, on_square(0.5, 0.5));
  assign_voronoi_areas(square(), samples);
  EXPECT_NEAR(samples[0].area, 1.0, 1e-15);
  EXPECT_EQ(samples[1].area, 0.0);
}

// Two samples above, and one below between them. In space, the sample below would be the nearest one for the middle of
// the upper side as well.
TEST(VoronoiArea, IsNotSharedBetweenOppositeWalls) {
  const double h = 1e-4;
  const TriMesh plate = make_box(dvec3(1.0, 1.0, h));
  const auto sample = [&](double x, double side) {
    int face = 0;
    while (plate.face_normals()[static_cast<std::size_t>(face)].z * side < 0.5) ++face;
    return SurfaceSample{dvec3(x, 0, side * h), dvec3(0, 0, side), face, 0.0};
  };
  std::vector<SurfaceSample> samples = {sample(-0.5, 1), sample(0.5, 1), sample(0, -1)};
  assign_voronoi_areas(plate, samples);
  const double rims = 8.0 * h;
  EXPECT_NEAR(samples[0].area, 2.0, rims);
  EXPECT_NEAR(samples[1].area, 2.0, rims);
  EXPECT_NEAR(samples[2].area, 4.0, rims);
}

TEST(VoronoiArea, EqualsACountOfPoints) {
  const TriMesh mesh = make_ellipsoid(dvec3(0.01, 0.02, 0.015), 0.004);
  std::vector<SurfaceSample> samples = sample_surface(mesh, 40, 3);
  const SurfacePool pool = make_surface_pool(mesh, 200000, 99);
  std::vector<double> counted(samples.size(), 0.0);
  for (int i = 0; i < pool.size(); ++i) {
    const auto p = static_cast<std::size_t>(i);
    std::size_t owner = 0;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t s = 0; s < samples.size(); ++s) {
      const double d = glm::distance(samples[s].position, pool.positions[p]);
      if (glm::dot(samples[s].normal, pool.normals[p]) > 0 && d < nearest) nearest = d, owner = s;
    }
    counted[owner] += mesh.area() / pool.size();
  }
  for (std::size_t s = 0; s < samples.size(); ++s)
    EXPECT_NEAR(counted[s] / samples[s].area, 1.0, 0.02);  // 5000 points each
}

}  // namespace
}  // namespace taxel
