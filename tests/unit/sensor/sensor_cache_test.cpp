// The cache of parts of sensor models: models with and without the cache are equal.
#include "core/sensor/sensor_cache.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "core/layout/file/layout_json.h"
#include "core/mesh/mesh_io.h"
#include "core/sensor/rays/tet_table.h"
#include "core/sensor/sensor_model.h"

namespace taxel {
namespace {

const std::filesystem::path kFile =
    std::filesystem::path(TAXEL_SOURCE_DIR) / "assets" / "layouts" / "fingertip.taxels.json";

struct Finger {
  Layout layout = read_layout(kFile);
  LoadedMesh mesh = load_mesh(mesh_path(layout, kFile), layout.mesh.scale);
  [[nodiscard]] SensorModelPtr build(const SensorBuild& how) const {
    return build_sensor_model(layout, mesh.mesh, mesh.sha256, "finger", how);
  }
};

template <class T>
bool same_bytes(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

void expect_same(const SensorModel& a, const SensorModel& b) {
  ASSERT_EQ(a.samples.size(), b.samples.size());
  for (std::size_t i = 0; i < a.samples.size(); ++i) {
    ASSERT_EQ(a.samples[i].position, b.samples[i].position);
    ASSERT_EQ(a.samples[i].area, b.samples[i].area);
  }
  ASSERT_EQ(a.rays.size(), b.rays.size());
  for (std::size_t r = 0; r < a.rays.size(); ++r) {
    ASSERT_EQ(a.rays[r].sample, b.rays[r].sample);
    ASSERT_EQ(a.rays[r].origin, b.rays[r].origin);
    ASSERT_EQ(a.rays[r].max_depth, b.rays[r].max_depth);
  }
  EXPECT_TRUE(same_bytes(a.readout_table.ray_of_entry, b.readout_table.ray_of_entry));
  EXPECT_EQ(a.taxels_of_sample, b.taxels_of_sample);
  ASSERT_EQ(a.ray_tables.tets->tet_count(), b.ray_tables.tets->tet_count());
  for (int t = 0; t < a.ray_tables.tets->tet_count(); ++t) {
    const auto p = a.ray_tables.tets->rays_of(t), q = b.ray_tables.tets->rays_of(t);
    ASSERT_EQ(p.size(), q.size());
    ASSERT_EQ(0, std::memcmp(p.data(), q.data(), p.size_bytes()));
  }
}

TEST(SensorCache, ReassignsTheSamplesAfterAnEditOfTaxels) {
  Finger finger;
  finger.layout.sampling.density = 2e6;
  SensorCache cache;
  SensorBuild how;
  how.cache = &cache;
  const SensorModelPtr before = finger.build(how);
  finger.layout.taxels[3].center += dvec3(0.0005, 0, -0.001);
  finger.layout.taxels.pop_back();
  const SensorModelPtr after = finger.build(how);
  EXPECT_EQ(after->body, before->body);
  EXPECT_EQ(after->skin, before->skin);
  expect_same(*after, *finger.build({}));
  EXPECT_NE(after->rays.size(), before->rays.size());
}

TEST(SensorCache, MakesOtherSamplesForOtherParameters) {
  Finger finger;
  finger.layout.sampling.density = 1e6;
  SensorCache cache;
  const SensorSkinPtr skin = cache.skin(finger.mesh.mesh, Shells::outer);
  const auto same_content = std::make_shared<const TriMesh>(finger.mesh.mesh->vertices(), finger.mesh.mesh->faces());
  EXPECT_EQ(cache.skin(same_content, Shells::outer), skin);
  const auto samples = [&](int count, std::uint64_t seed, SampleQuality quality) {
    return cache.samples(cache.sampled(skin, {}), count, seed, quality, nullptr);
  };
  const SampleSetPtr first = samples(500, 1, SampleQuality::polished);
  EXPECT_EQ(samples(500, 1, SampleQuality::polished), first);
  EXPECT_NE(samples(501, 1, SampleQuality::polished), first);
  EXPECT_NE(samples(500, 2, SampleQuality::polished), first);
  EXPECT_NE(samples(500, 1, SampleQuality::preview), first);
  EXPECT_EQ(samples(500, 1, SampleQuality::polished), first);  // still in the cache

  std::vector<dvec3> vertices = finger.mesh.mesh->vertices();
  vertices[0].x += 1e-9;
  EXPECT_NE(cache.skin(std::make_shared<const TriMesh>(vertices, finger.mesh.mesh->faces()), Shells::outer), skin);
  EXPECT_NE(cache.skin(finger.mesh.mesh, Shells::all), skin);
}

TEST(SensorCache, ReplacesAPreviewByAPolishedBuild) {
  Finger finger;
  finger.layout.sampling.density = 2e6;
  SensorCache cache;
  SensorBuild how;
  how.cache = &cache;
  how.quality = SampleQuality::preview;
  const SensorModelPtr preview = finger.build(how);
  how.quality = SampleQuality::polished;
  const SensorModelPtr polished = finger.build(how);
  EXPECT_EQ(preview->quality, SampleQuality::preview);
  EXPECT_EQ(polished->quality, SampleQuality::polished);
  EXPECT_EQ(preview->samples.size(), polished->samples.size());
  EXPECT_EQ(preview->body, polished->body);
  expect_same(*polished, *finger.build({}));
  for (int k = 0; k < preview->taxel_count(); ++k) {
    const auto i = static_cast<std::size_t>(k);
    const auto count = [&](const SensorModel& m) { return m.fields.first[i + 1] - m.fields.first[i]; };
    EXPECT_NEAR(count(*preview), count(*polished), 0.1 * count(*polished)) << k;
  }
}

TEST(SensorCache, MakesNoPreviewIfPolishedSamplesAreCached) {
  Finger finger;
  finger.layout.sampling.density = 1e6;
  SensorCache cache;
  SensorBuild how;
  how.cache = &cache;
  const SensorModelPtr polished = finger.build(how);
  how.quality = SampleQuality::preview;
  const SensorModelPtr again = finger.build(how);
  EXPECT_EQ(again->quality, SampleQuality::polished);
  expect_same(*again, *polished);
  finger.layout.sampling.seed += 1;
  EXPECT_EQ(finger.build(how)->quality, SampleQuality::preview) << "of other samples";
}

TEST(SensorCache, NamesTheFileInCachedProblemsOfAMesh) {
  const Finger finger;
  SensorCache cache;
  SensorBuild how;
  how.cache = &cache;
  const LoadedMesh large = load_mesh(mesh_path(finger.layout, kFile), dvec3(1e3));  // a fingertip of tens of metres
  Layout layout = finger.layout;
  layout.mesh.scale = dvec3(1e3);
  layout.taxels.clear();
  layout.material.thickness = 0;
  layout.sampling.density = 1;
  for (const char* file : {"one.json", "other.json"}) {
    const SensorModelPtr model = build_sensor_model({file, layout, large}, how);
    const auto found = std::find_if(model->problems.begin(), model->problems.end(),
                                    [](const Problem& p) { return p.code == "mesh_units"; });
    ASSERT_NE(found, model->problems.end());
    EXPECT_EQ(found->file, file);
  }
}

TEST(SensorCache, KeepsNoIncompleteSamplesOfACancelledBuild) {
  Finger finger;
  finger.layout.sampling.density = 2e6;
  SensorCache cache;
  Progress progress;
  progress.cancel();
  SensorBuild how(&progress);
  how.cache = &cache;
  EXPECT_THROW(static_cast<void>(finger.build(how)), Cancelled);
  how.progress = nullptr;
  expect_same(*finger.build(how), *finger.build({}));
}

}  // namespace
}  // namespace taxel
