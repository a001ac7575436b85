// Samples on meshes: exact count, on the surface, even, the same bytes on any number of threads.
#include "core/layout/poisson_disk.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cstring>

#include "core/base/error.h"
#include "core/base/hash.h"
#include "core/base/rng.h"
#include "core/layout/sample_spread.h"
#include "core/mesh/closest_point.h"
#include "core/mesh/mesh_io.h"
#include "core/mesh/primitives.h"
#include "unit/layout/sample_score.h"

namespace taxel {
namespace {

TriMesh fingertip() {
  return *load_mesh(std::filesystem::path(TAXEL_SOURCE_DIR) / "assets/meshes/fingertip.obj").mesh;
}

std::string bytes_of(const std::vector<SurfaceSample>& samples) {
  std::string bytes;
  const auto add = [&](const auto& value) { bytes.append(reinterpret_cast<const char*>(&value), sizeof value); };
  for (const SurfaceSample& s : samples) {
    for (int i = 0; i < 3; ++i) add(s.position[i]), add(s.normal[i]);
    add(s.face);
    add(s.area);
  }
  return bytes;
}

/// What must hold on any mesh and for any count.
void expect_valid(const TriMesh& mesh, const std::vector<SurfaceSample>& samples, int count) {
  ASSERT_EQ(static_cast<int>(samples.size()), count);
  const double rounding = 1e-12 * mesh.bounds().diagonal();
  double total = 0.0;
  for (const SurfaceSample& s : samples) {
    ASSERT_GE(s.face, 0);
    ASSERT_LT(s.face, mesh.face_count());
    ASSERT_EQ(s.normal, mesh.face_normals()[static_cast<std::size_t>(s.face)]);
    const dvec3 &a = mesh.vertex(s.face, 0), &b = mesh.vertex(s.face, 1), &c = mesh.vertex(s.face, 2);
    ASSERT_NEAR(glm::dot(s.position - a, s.normal), 0.0, rounding);
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
      ASSERT_GE(glm::dot(glm::cross(glm::normalize(to - from), s.position - from), s.normal), -rounding);
    ASSERT_GE(s.area, 0.0);
    total += s.area;
  }
  ASSERT_NEAR(total / mesh.area(), 1.0, 1e-12);
}

TEST(PoissonDisk, CountIsExactOnEveryShape) {
  for (const TriMesh& mesh : {make_box(dvec3(0.01, 0.02, 0.0001)), make_icosphere(2.0, 2), fingertip()})
    for (const int count : {1, 2, 3, 4, 7, 50, 333}) expect_valid(mesh, sample_surface(mesh, count, 5), count);
  EXPECT_TRUE(sample_surface(fingertip(), 0, 5).empty());
}

TEST(PoissonDisk, OpenMeshesAndSliversAreSampled) {
  const TriMesh one({dvec3(0), dvec3(1, 0, 0), dvec3(0, 1, 0)}, {ivec3(0, 1, 2)});
  for (const int count : {1, 5, 500}) expect_valid(one, sample_surface(one, count, 1), count);
  const TriMesh sliver({dvec3(0), dvec3(1, 0, 0), dvec3(0.5, 1e-7, 0)}, {ivec3(0, 1, 2)});
  expect_valid(sliver, sample_surface(sliver, 40, 1), 40);
}

// Targets of the project for its own finger and for smooth and creased shapes; one count small, one large.
TEST(PoissonDisk, SamplesAreEven) {
  struct Case {
    const char* name;
    TriMesh mesh;
    int count;
    double rho_min, area_cv;
  };
  const Case cases[] = {{"fingertip", fingertip(), 1000, 0.78, 0.10},
                        {"fingertip", fingertip(), 6000, 0.78, 0.10},
                        {"sphere", make_icosphere(0.01, 4), 1000, 0.78, 0.10},
                        {"sphere", make_icosphere(0.01, 4), 6000, 0.78, 0.10},
                        {"box", make_box(dvec3(0.01, 0.008, 0.015)), 1000, 0.75, 0.13},
                        {"thin box", make_box(dvec3(0.01, 0.01, 0.0002)), 2000, 0.75, 0.13}};
  for (const Case& c : cases) {
    const std::vector<SurfaceSample> samples = sample_surface(c.mesh, c.count, 42);
    const SampleScore score = score_samples(c.mesh, samples);
    EXPECT_GE(score.rho_min, c.rho_min) << c.name << c.count;
    EXPECT_GE(score.rho_5_percent, 0.85) << c.name << c.count;
    EXPECT_GE(score.rho_mean, 0.90) << c.name << c.count;
    EXPECT_LE(score.area_cv, c.area_cv) << c.name << c.count;
    EXPECT_NEAR(score.area_sum / c.mesh.area(), 1.0, 1e-12);
  }
}

TEST(PoissonDisk, SameBytesOnAnyNumberOfThreads) {
  const TriMesh mesh = fingertip();
  std::vector<std::string> hashes;
  for (const std::size_t threads : {1U, 2U, 8U}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    hashes.push_back(sha256_hex(bytes_of(sample_surface(mesh, 3000, 42))));
  }
  EXPECT_EQ(hashes[0], hashes[1]);
  EXPECT_EQ(hashes[0], hashes[2]);
}

TEST(PoissonDisk, TheSeedDecides) {
  const TriMesh mesh = fingertip();
  const std::string first = bytes_of(sample_surface(mesh, 500, 1));
  EXPECT_EQ(bytes_of(sample_surface(mesh, 500, 1)), first);
  EXPECT_NE(bytes_of(sample_surface(mesh, 500, 2)), first);
}

// The same bytes on every machine: the hash stands here for good, and a change of it is a change of every reading.
TEST(PoissonDisk, GoldenHashOnOurFingertip) {
  EXPECT_EQ(sha256_hex(bytes_of(sample_surface(fingertip(), 2000, 42))),
            "432669e8e22b06a4cd34ed414745e7e36806220c1075d20c51472bc8e9f09f98");
}

TEST(PoissonDisk, CountsBeyondTheLimitsAreRefused) {
  const TriMesh mesh = make_box(dvec3(1));
  EXPECT_THROW(sample_surface(mesh, -1, 1), Error);
  EXPECT_THROW(sample_surface(mesh, kMaxSamples + 1, 1), Error);
  EXPECT_EQ(sample_count(1e7, 1.7e-3), 17000);
  EXPECT_EQ(sample_count(1.0, 0.4), 0);
  EXPECT_THROW(sample_count(1e12, 1.0), Error);
  EXPECT_THROW(sample_count(std::numeric_limits<double>::quiet_NaN(), 1.0), Error);
  EXPECT_THROW(sample_count(-1.0, 1.0), Error);
}

TEST(PoissonDisk, CanBeCancelled) {
  Progress progress;
  progress.cancel();
  EXPECT_THROW(sample_surface(fingertip(), 1000, 1, &progress), Cancelled);
}

TEST(ClimbToHole, FindsTheCircumcentreOfATriangle) {
  const std::vector<dvec2> triangle = {dvec2(0, 0), dvec2(1, 0), dvec2(0.4, 0.9)};
  const dvec2 hole = climb_to_hole(triangle, dvec2(0.2, 0.1), 2.0);
  const double r = glm::distance(hole, triangle[0]);
  EXPECT_NEAR(glm::distance(hole, triangle[1]), r, 1e-14);
  EXPECT_NEAR(glm::distance(hole, triangle[2]), r, 1e-14);
}

TEST(ClimbToHole, NeverComesNearerAndEndsAtALocalMaximum) {
  const CounterRng rng(3);
  std::uint64_t next = 0;
  for (int round = 0; round < 300; ++round) {
    std::vector<dvec2> others;
    for (int i = 0; i < 25; ++i) {
      const double x = rng.uniform(next++), y = rng.uniform(next++);
      others.emplace_back(2.0 * x - 1.0, 2.0 * y - 1.0);
    }
    const auto clearance = [&](const dvec2& x) {
      double least = 1e9;
      for (const dvec2& q : others) least = std::min(least, glm::distance(x, q));
      return least;
    };
    const double start_x = rng.uniform(next++), start_y = rng.uniform(next++);
    const dvec2 start(0.2 * start_x, 0.2 * start_y);
    const dvec2 hole = climb_to_hole(others, start, 0.5);
    EXPECT_GE(clearance(hole), clearance(start) - 1e-12);
    if (glm::distance(hole, start) > 0.4) continue;  // may have been stopped on the way
    const double step = 1e-4;
    for (int k = 0; k < 16; ++k) {
      const double angle = k * kPi / 8;
      EXPECT_LT(clearance(hole + step * dvec2(std::cos(angle), std::sin(angle))), clearance(hole) + 1e-9) << round;
    }
  }
}

}  // namespace
}  // namespace taxel
