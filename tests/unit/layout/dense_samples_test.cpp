// Samples whose density differs between parts of a surface: distances, evenness, exact shares, and what does not
// change.
#include "core/layout/sampling/poisson_disk.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/mesh/make/primitives.h"
#include "core/mesh/mesh_io.h"

namespace taxel {
namespace {

constexpr double kDensity = 1e6;  // of the whole surface

double ideal_spacing(double density) {
  return std::sqrt(2.0 / (std::sqrt(3.0) * density));
}

struct Case {
  const char* name;
  TriMesh mesh;
  DenseDisc disc;
};

std::vector<Case> cases() {
  const TriMesh finger = *load_mesh(std::filesystem::path(TAXEL_SOURCE_DIR) / "assets/meshes/fingertip.obj").mesh;
  return {{"plate", make_box(dvec3(0.03, 0.03, 0.005)), {dvec3(0, 0, 0.005), dvec3(0, 0, 1), 0.006, -0.1, 0}},
          {"at an edge", make_box(dvec3(0.03, 0.03, 0.01)), {dvec3(0.029, 0, 0.01), dvec3(0, 0, 1), 0.006, -0.1, 0}},
          {"ball", make_icosphere(0.02, 4), {dvec3(0, 0, 0.02), dvec3(0, 0, 1), 0.006, -0.1, 0}},
          {"finger", finger, {dvec3(0.0086195, 0.0004629, 0.0131657), dvec3(0.999, -0.0327, 0.0315), 0.006, -0.1, 0}}};
}

std::vector<SurfaceSample> usual_samples(const TriMesh& mesh) {
  return sample_surface(mesh, sample_count(kDensity, mesh.area()), 42);
}

DenseSampling at_density(DenseDisc disc, double density) {
  disc.density = density;
  return {kDensity, {disc}, 42, SampleQuality::polished};
}

bool in_field(const SurfaceSample& s, const DenseDisc& disc) {
  return glm::distance(s.position, disc.center) <= disc.radius && glm::dot(s.normal, disc.normal) > 0.7;
}

/// Returns the distance of each sample to the nearest other one on the same wall, by comparing all pairs.
std::vector<double> nearest_distances(const std::vector<SurfaceSample>& samples) {
  std::vector<double> nearest(samples.size(), 1e9);
  for (std::size_t i = 0; i < samples.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      if (glm::dot(samples[i].normal, samples[j].normal) < -1e-6) continue;
      const double d = glm::distance(samples[i].position, samples[j].position);
      nearest[i] = std::min(nearest[i], d);
      nearest[j] = std::min(nearest[j], d);
    }
  return nearest;
}

// In the part, samples are as far apart as on a whole surface of this density; elsewhere as before; and across the edge
// of the part no closer than half of that: each is in the Voronoi cell of a usual sample.
TEST(DenseSamples, KeepTheDistanceOfEachDensity) {
  for (const Case& c : cases())
    for (const double factor : {1.7, 4.0, 16.0}) {
      const auto samples = add_dense_samples(c.mesh, usual_samples(c.mesh), at_density(c.disc, factor * kDensity));
      const std::vector<double> nearest = nearest_distances(samples);
      const double own = ideal_spacing(factor * kDensity), usual = ideal_spacing(kDensity);
      const double far = c.disc.radius + 3 * usual;
      double least_own = 1, least_usual = 1, least = 1, mean = 0, shares = 0;
      int inside = 0;
      for (std::size_t i = 0; i < samples.size(); ++i) {
        least = std::min(least, nearest[i] / own);
        if (in_field(samples[i], c.disc)) {
          least_own = std::min(least_own, nearest[i] / own);
          mean += nearest[i] / own;
          ++inside;
          EXPECT_EQ(samples[i].share, kDensity * samples[i].area);
          shares += samples[i].share;
        } else if (glm::distance(samples[i].position, c.disc.center) > far) {
          least_usual = std::min(least_usual, nearest[i] / usual);
          EXPECT_EQ(samples[i].share, 1);
        }
      }
      EXPECT_GE(least, 0.45) << c.name << factor << ": at the edge of the part";
      EXPECT_GE(least_own, 0.8) << c.name << factor;
      EXPECT_GE(mean / inside, 0.88) << c.name << factor;
      EXPECT_NEAR(shares / inside, 1 / factor, 0.06 / factor) << c.name << factor;
      EXPECT_GE(least_usual, 0.75) << c.name << factor;
    }
}

// The number of samples of a field, and the area that their shares stand for, against the area of the disc on a plate.
TEST(DenseSamples, HaveTheDensityOfTheTaxelInItsField) {
  const Case plate = std::move(cases().front());
  const double area = kPi * plate.disc.radius * plate.disc.radius;
  for (const double factor : {1.7, 4.0, 16.0, 64.0}) {
    const auto samples =
        add_dense_samples(plate.mesh, usual_samples(plate.mesh), at_density(plate.disc, factor * kDensity));
    double count = 0, shares = 0, areas = 0, all = 0;
    for (const SurfaceSample& s : samples) {
      all += s.area;
      if (!in_field(s, plate.disc)) continue;
      ++count, shares += s.share, areas += s.area;
    }
    EXPECT_NEAR(count, factor * kDensity * area, 0.04 * factor * kDensity * area) << factor;
    EXPECT_NEAR(shares, kDensity * area, 0.04 * kDensity * area) << factor;
    EXPECT_NEAR(areas, area, 0.04 * area) << factor;
    EXPECT_NEAR(all, plate.mesh.area(), 1e-9 * plate.mesh.area());
  }
}

bool equal(const SurfaceSample& a, const SurfaceSample& b) {
  return a.position == b.position && a.normal == b.normal && a.face == b.face && a.share == b.share;
}

void expect_same(const std::vector<SurfaceSample>& a, const std::vector<SurfaceSample>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_TRUE(equal(a[i], b[i])) << i;
    EXPECT_EQ(a[i].area, b[i].area) << i;
  }
}

// All samples of the layout whose cells do not reach into the disc are the same bits in the same order, with the same
// areas. The new ones lie in the cells of the others, by comparing all pairs, and represent their area.
TEST(DenseSamples, ReplaceSamplesCellByCell) {
  for (const Case& c : cases()) {
    const auto before = usual_samples(c.mesh);
    const auto after = add_dense_samples(c.mesh, before, at_density(c.disc, 4 * kDensity));
    const double reach = c.disc.radius + 0.75 * ideal_spacing(kDensity);
    const auto is_replaced = [&](const SurfaceSample& s) {
      return glm::distance(s.position, c.disc.center) <= reach && glm::dot(s.normal, c.disc.normal) >= -0.1;
    };
    std::size_t next = 0;
    double replaced = 0, added = 0;
    for (const SurfaceSample& s : before) {
      if (is_replaced(s)) {
        replaced += s.area;
        continue;
      }
      ASSERT_LT(next, after.size());
      EXPECT_TRUE(equal(s, after[next])) << c.name << " " << next;
      EXPECT_EQ(s.area, after[next].area) << c.name << " " << next;
      ++next;
    }
    EXPECT_GT(next, before.size() / 4);
    for (std::size_t i = next; i < after.size(); ++i) {
      EXPECT_EQ(after[i].share, kDensity * after[i].area);
      added += after[i].area;
      const auto farther = [&](const SurfaceSample& a, const SurfaceSample& b) {
        const auto away = [&](const SurfaceSample& s) {
          return glm::distance(s.position, after[i].position) + (glm::dot(s.normal, after[i].normal) > -1e-9 ? 0 : 1e3);
        };
        return away(a) < away(b);
      };
      EXPECT_TRUE(is_replaced(*std::min_element(before.begin(), before.end(), farther))) << c.name << " " << i;
    }
    EXPECT_NEAR(added, replaced, 1e-9 * replaced) << c.name;
  }
}

TEST(DenseSamples, DoNotChangeForDiscsThatAreNotDenser) {
  const Case plate = std::move(cases().front());
  const auto before = usual_samples(plate.mesh);
  for (const DenseSampling& how : {DenseSampling{kDensity, {}, 1, {}}, at_density(plate.disc, kDensity)})
    expect_same(before, add_dense_samples(plate.mesh, before, how));
}

// Far parts do not depend on each other; where two parts overlap, the densest counts.
TEST(DenseSamples, DependOnlyOnDiscsThatOverlap) {
  const Case plate = std::move(cases().front());
  DenseDisc left = plate.disc, right = plate.disc, second = plate.disc;
  left.center.x = -0.012, right.center.x = 0.012, second.center.x = 0.006;
  left.density = right.density = 4 * kDensity, second.density = 9 * kDensity;
  const auto usual = usual_samples(plate.mesh);
  const auto one = add_dense_samples(plate.mesh, usual, {kDensity, {left}, 42, {}});
  const auto three = add_dense_samples(plate.mesh, usual, {kDensity, {right, second, left}, 42, {}});
  const auto of_left = [&](const SurfaceSample& s) { return in_field(s, left); };
  std::vector<SurfaceSample> a, b;
  std::copy_if(one.begin(), one.end(), std::back_inserter(a), of_left);
  std::copy_if(three.begin(), three.end(), std::back_inserter(b), of_left);
  EXPECT_GT(a.size(), 400U);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_TRUE(equal(a[i], b[i])) << i;
  for (const SurfaceSample& s : three) {
    if (in_field(s, second)) {
      EXPECT_NEAR(s.share, 1 / 9.0, 0.4 / 9);
    }
    if (in_field(s, right) && glm::distance(s.position, second.center) > 0.0085) {
      EXPECT_NEAR(s.share, 0.25, 0.4 / 4);
    }
  }
}

TEST(DenseSamples, AreTheSameOnAnyNumberOfThreads) {
  const Case finger = std::move(cases().back());
  const auto usual = usual_samples(finger.mesh);
  const auto all = add_dense_samples(finger.mesh, usual, at_density(finger.disc, 16 * kDensity));
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const auto single = add_dense_samples(finger.mesh, usual, at_density(finger.disc, 16 * kDensity));
  expect_same(all, single);
}

TEST(DenseSamples, RefuseMoreThanTheLargestNumber) {
  const Case plate = std::move(cases().front());
  EXPECT_THROW(add_dense_samples(plate.mesh, usual_samples(plate.mesh), at_density(plate.disc, 1e12)), Error);
}

}  // namespace
}  // namespace taxel
