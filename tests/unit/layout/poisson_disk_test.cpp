// Samples on meshes: exact count, on the surface, uniform, and the same bytes on any number of threads.
#include "core/layout/sampling/poisson_disk.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cstring>
#include <thread>

#include "app/validate/sample_score.h"
#include "core/base/error.h"
#include "core/base/files.h"
#include "core/mesh/make/primitives.h"
#include "core/mesh/mesh_io.h"
#include "core/mesh/query/closest_point.h"

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

/// Expects the properties that hold on any mesh and for any count.
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

TEST(PoissonDisk, GivesTheExactCountOnEveryShape) {
  for (const TriMesh& mesh : {make_box(dvec3(0.01, 0.02, 0.0001)), make_icosphere(2.0, 2), fingertip()})
    for (const int count : {1, 2, 3, 4, 7, 50, 333}) expect_valid(mesh, sample_surface(mesh, count, 5), count);
  EXPECT_TRUE(sample_surface(fingertip(), 0, 5).empty());
}

TEST(PoissonDisk, SamplesOpenMeshesAndSlivers) {
  const TriMesh one({dvec3(0), dvec3(1, 0, 0), dvec3(0, 1, 0)}, {ivec3(0, 1, 2)});
  for (const int count : {1, 5, 500}) expect_valid(one, sample_surface(one, count, 1), count);
  const TriMesh sliver({dvec3(0), dvec3(1, 0, 0), dvec3(0.5, 1e-7, 0)}, {ivec3(0, 1, 2)});
  expect_valid(sliver, sample_surface(sliver, 40, 1), 40);
}

struct Evenness {
  const char* name;
  TriMesh mesh;
  int count;
  double rho_min, area_cv, gap;
};

void expect_even(const Evenness& c) {
  const SampleScore score = score_samples(c.mesh, sample_surface(c.mesh, c.count, 42));
  EXPECT_GE(score.rho_min, c.rho_min) << c.name << c.count;
  EXPECT_GE(score.rho_5_percent, 0.85) << c.name << c.count;
  EXPECT_GE(score.rho_mean, 0.90) << c.name << c.count;
  EXPECT_LE(score.area_cv, c.area_cv) << c.name << c.count;
  EXPECT_LE(score.gap, c.gap) << c.name << c.count;
}

// Targets of the project for smooth and creased shapes, with a small and a large count.
TEST(PoissonDisk, GivesUniformSamples) {
  const TriMesh box = make_box(dvec3(0.01, 0.008, 0.015)), thin = make_box(dvec3(0.01, 0.01, 0.0002));
  for (const int count : {1000, 6000}) {
    expect_even({"fingertip", fingertip(), count, 0.78, 0.10, 1.5});
    expect_even({"sphere", make_icosphere(0.01, 4), count, 0.78, 0.10, 1.5});
    expect_even({"box", box, count, 0.78, 0.13, 2.0});
    expect_even({"thin box", thin, count, 0.78, 0.13, 2.0});
  }
}

TEST(PoissonDisk, GivesUniformSamplesOnRealFingers) {
  const std::filesystem::path folder = std::filesystem::path(TAXEL_REAL_DATA) / "meshes";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "the real meshes are absent: " << folder;
  const TriMesh biotac = *load_mesh(folder / "shadow_f_distal_bt_sp.stl", dvec3(0.001)).mesh;
  for (const int count : {1000, 6000}) expect_even({"BioTac", biotac, count, 0.78, 0.13, 2.0});

  // The sockets have walls thinner than the spacing. Points that are near in space are far apart along the surface
  // there, and parts that face away from all samples are far from each sample. The bounds of 5 % and of the mean limit
  // the rest.
  const TriMesh whole = *load_mesh(folder / "shadow_f_distal_pst.stl", dvec3(0.001)).mesh;
  const TriMesh shadow = extract_shells(whole, outer_shells(whole));
  const SampleScore score = score_samples(shadow, sample_surface(shadow, 6000, 42));
  EXPECT_GE(score.rho_5_percent, 0.85);
  EXPECT_GE(score.rho_mean, 0.90);
  EXPECT_LE(score.area_cv, 0.13);
}

TEST(PoissonDisk, GivesAPreviewTheExactCountWithoutClosePairs) {
  for (const TriMesh& mesh : {fingertip(), make_icosphere(0.01, 4), make_box(dvec3(0.01, 0.01, 0.0002))}) {
    for (const int count : {1, 2, 50, 3000}) {
      const auto samples = sample_surface(mesh, count, 42, nullptr, SampleQuality::preview);
      expect_valid(mesh, samples, count);
      if (count < 1000) continue;
      const SampleScore score = score_samples(mesh, samples);
      EXPECT_GE(score.rho_min, 0.55) << count;
      EXPECT_GE(score.rho_mean, 0.74) << count;
      EXPECT_LE(score.gap, 2.2) << count;
    }
  }
}

TEST(PoissonDisk, GivesTheSameBytesOnAnyNumberOfThreads) {
  const TriMesh mesh = fingertip();
  std::vector<std::string> hashes;
  for (const std::size_t threads : {1U, 2U, 8U}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    hashes.push_back(sha256_hex(bytes_of(sample_surface(mesh, 3000, 42)) +
                                bytes_of(sample_surface(mesh, 3000, 42, nullptr, SampleQuality::preview))));
  }
  EXPECT_EQ(hashes[0], hashes[1]);
  EXPECT_EQ(hashes[0], hashes[2]);
}

TEST(PoissonDisk, DependsOnTheSeed) {
  const TriMesh mesh = fingertip();
  const std::string first = bytes_of(sample_surface(mesh, 500, 1));
  EXPECT_EQ(bytes_of(sample_surface(mesh, 500, 1)), first);
  EXPECT_NE(bytes_of(sample_surface(mesh, 500, 2)), first);
}

// The bytes are the same on every machine. The hash must not change, because another hash means that every reading
// changes.
TEST(PoissonDisk, KeepsTheGoldenHashOnOurFingertip) {
  EXPECT_EQ(sha256_hex(bytes_of(sample_surface(fingertip(), 2000, 42))),
            "53e1c6935d7164a125cff2ebbed729a235647614f0f8c087eaab07efb9294936");
}

TEST(PoissonDisk, RefusesCountsBeyondTheLimits) {
  const TriMesh mesh = make_box(dvec3(1));
  EXPECT_THROW(sample_surface(mesh, -1, 1), Error);
  EXPECT_THROW(sample_surface(mesh, kMaxSamples + 1, 1), Error);
  EXPECT_EQ(sample_count(1e7, 1.7e-3), 17000);
  EXPECT_EQ(sample_count(1.0, 0.4), 0);
  EXPECT_EQ(sample_count(1.0, 0.5), 1) << "a half is rounded up";
  EXPECT_EQ(sample_count(100, 0.1249), 12);
  EXPECT_EQ(sample_count(100, 0.1251), 13);
  EXPECT_EQ(sample_count(1e7, 1.00000004), kMaxSamples) << "the limit itself";
  EXPECT_THROW(sample_count(1e7, 1.00000006), Error) << "one more than the limit";
  EXPECT_THROW(sample_count(1e12, 1.0), Error);
  EXPECT_THROW(sample_count(std::numeric_limits<double>::quiet_NaN(), 1.0), Error);
  EXPECT_THROW(sample_count(-1.0, 1.0), Error);
}

// Cancelled after the start, by a thread that sees the progress advance.
TEST(PoissonDisk, StopsSoonAfterItIsCancelled) {
  for (const SampleQuality quality : {SampleQuality::preview, SampleQuality::polished}) {
    Progress progress;
    progress.cancel();
    EXPECT_THROW(sample_surface(fingertip(), 1000, 1, &progress, quality), Cancelled);
  }
  Progress progress;
  std::jthread watcher([&](const std::stop_token& done) {
    while (progress.fraction() < 0.4 && !done.stop_requested()) std::this_thread::yield();
    progress.cancel();
  });
  EXPECT_THROW(sample_surface(fingertip(), 30000, 1, &progress), Cancelled);
  EXPECT_GE(progress.fraction(), 0.4);
  EXPECT_LT(progress.fraction(), 0.9);
}

TEST(PoissonDisk, ReportsGrowingProgress) {
  Progress progress;
  std::vector<double> seen;
  std::jthread watcher([&](const std::stop_token& done) {
    while (!done.stop_requested()) {
      if (seen.empty() || progress.fraction() != seen.back()) seen.push_back(progress.fraction());
      std::this_thread::yield();
    }
  });
  sample_surface(fingertip(), 20000, 1, &progress);
  watcher.request_stop();
  watcher.join();
  EXPECT_GT(seen.size(), 5U);
  EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
}

}  // namespace
}  // namespace taxel
