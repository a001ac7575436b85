// Samples on disk: the same bits as without them, and made again where a file is damaged or of another version.
#include "core/sensor/stored_samples.h"

#include <gtest/gtest.h>

#include <cstring>

#include "core/base/error.h"
#include "core/layout/file/layout_json.h"
#include "core/mesh/mesh_io.h"
#include "core/sensor/sensor_model.h"
#include "fixtures/surroundings.h"
#include "fixtures/temp_folder.h"

namespace taxel {
namespace {

namespace fs = std::filesystem;

std::vector<std::pair<std::string, std::string>> variable(const std::string& value) {
  return {{kSampleCacheVariable, value}};
}

/// A folder of samples on disk that this process uses until the end of the object.
struct OnDisk {
  test::TempFolder folder;
  test::Surroundings surroundings{{{"XDG_CACHE_HOME", folder.path().string()}, {kSampleCacheVariable, "100"}}};
  DiskCache cache = *sample_cache();
  OnDisk() { keep_samples_on_disk(); }
  ~OnDisk() {
    const test::Surroundings off(variable("off"));
    keep_samples_on_disk();
  }
};

struct StoredFinger {
  Layout layout;
  LoadedMesh mesh;
  explicit StoredFinger(double density) {
    const fs::path file = fs::path(TAXEL_SOURCE_DIR) / "assets" / "layouts" / "fingertip.taxels.json";
    layout = read_layout(file);
    layout.sampling.density = density;
    mesh = load_mesh(mesh_path(layout, file), layout.mesh.scale);
  }
  [[nodiscard]] SensorModelPtr build() const { return build_sensor_model(layout, mesh.mesh, "", "finger"); }
};

using Samples = std::vector<SurfaceSample>;

void expect_same_bits(const Samples& a, const Samples& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_EQ(0, std::memcmp(&a[i].position, &b[i].position, sizeof(dvec3))) << i;
    ASSERT_EQ(0, std::memcmp(&a[i].normal, &b[i].normal, sizeof(dvec3))) << i;
    ASSERT_EQ(0, std::memcmp(&a[i].area, &b[i].area, sizeof(double))) << i;
    ASSERT_EQ(0, std::memcmp(&a[i].share, &b[i].share, sizeof(double))) << i;
    ASSERT_EQ(a[i].face, b[i].face) << i;
  }
}

TEST(StoredSamples, AreThoseOfACompilationWithoutThem) {
  StoredFinger finger(2e6);
  finger.layout.taxels[0].density = 2e7;
  const SensorModelPtr alone = finger.build();
  const OnDisk disk;
  const SensorModelPtr first = finger.build();
  EXPECT_EQ(disk.cache.content().values, 2U) << "usual and dense samples";
  const SensorModelPtr second = finger.build();
  EXPECT_EQ(disk.cache.content().values, 2U);
  for (const SensorModelPtr& model : {first, second}) {
    expect_same_bits(model->samples, alone->samples);
    ASSERT_EQ(model->rays.size(), alone->rays.size());
    EXPECT_EQ(model->sampled_area, alone->sampled_area);
  }
}

Samples refuse() {
  throw Error("made although they are on disk");
}

TEST(StoredSamples, AreFoundByAllArguments) {
  const StoredFinger finger(2e6);
  const OnDisk disk;
  const TriMesh& mesh = *finger.mesh.mesh;
  const Samples samples = sample_surface(mesh, 1500, 42);
  const auto make = [&] { return samples; };
  stored_samples(mesh, 1500, 42, SampleQuality::polished, make);
  expect_same_bits(stored_samples(mesh, 1500, 42, SampleQuality::polished, refuse), samples);
  EXPECT_THROW(stored_samples(mesh, 1501, 42, SampleQuality::polished, refuse), Error);
  EXPECT_THROW(stored_samples(mesh, 1500, 43, SampleQuality::polished, refuse), Error);
  EXPECT_THROW(stored_samples(mesh, 1500, 42, SampleQuality::preview, refuse), Error);
  std::vector<dvec3> moved = mesh.vertices();
  moved[0].x += 1e-12;
  EXPECT_THROW(stored_samples({moved, mesh.faces()}, 1500, 42, SampleQuality::polished, refuse), Error);

  const DenseSampling how{2e6, {{{0, -0.006, 0.015}, {0, -1, 0}, 0.003, 0.7, 2e7}}, 42, SampleQuality::polished};
  stored_dense_samples(mesh, samples, how, make);
  expect_same_bits(stored_dense_samples(mesh, samples, how, refuse), samples);
  DenseSampling other = how;
  other.discs[0].radius = 0.004;
  EXPECT_THROW(stored_dense_samples(mesh, samples, other, refuse), Error);
  Samples fewer = samples;
  fewer.pop_back();
  EXPECT_THROW(stored_dense_samples(mesh, fewer, how, refuse), Error);
}

TEST(StoredSamples, AreMadeAgainWhereAFileIsDamaged) {
  const StoredFinger finger(2e6);
  const SensorModelPtr alone = finger.build();
  const OnDisk disk;
  ASSERT_NE(finger.build(), nullptr);
  ASSERT_EQ(disk.cache.content().values, 1U);
  const fs::path file = fs::directory_iterator(disk.cache.folder())->path();
  std::string bytes = read_file(file);
  bytes[bytes.size() / 2] ^= 4;
  for (const std::string& damaged : {bytes, bytes.substr(0, 1000), std::string("taxel cache 2\n")}) {
    write_file_atomically(file, damaged);
    expect_same_bits(finger.build()->samples, alone->samples);
    EXPECT_NE(read_file(file), damaged);
  }
}

TEST(StoredSamples, AreNotKeptIfTheyAreFewOrTurnedOff) {
  const OnDisk disk;
  ASSERT_NE(StoredFinger(2e5).build(), nullptr);
  EXPECT_EQ(disk.cache.content().values, 0U) << "a few hundred samples";
  const test::Surroundings off(variable("off"));
  EXPECT_FALSE(sample_cache());
  keep_samples_on_disk();
  ASSERT_NE(StoredFinger(2e6).build(), nullptr);
  EXPECT_EQ(disk.cache.content().values, 0U);
}

TEST(StoredSamples, RefuseAVariableThatIsNoNumber) {
  for (const char* wrong : {"of", "-1", "1.5", "10 MB", "99999999999999999999"}) {
    const test::Surroundings set(variable(wrong));
    try {
      sample_cache();
      ADD_FAILURE() << wrong;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find(kSampleCacheVariable), std::string::npos) << error.what();
    }
  }
  const test::Surroundings none(variable(""));
  EXPECT_EQ(sample_cache()->max_bytes(), 1'000'000'000U);
}

TEST(StoredSamples, HaveAnotherVersionWhereSamplesChange) {
  const StoredFinger finger(2e6);
  const TriMesh& mesh = *finger.mesh.mesh;
  const Samples samples = sample_surface(mesh, 1500, 42);
  const DenseSampling how{2e6, {{{0, -0.006, 0.015}, {0, -1, 0}, 0.003, 0.7, 2e7}}, 42, SampleQuality::polished};
  std::string bytes;
  for (const Samples& all : {samples, add_dense_samples(mesh, samples, how)})
    for (const SurfaceSample& s : all) {
      bytes.append(reinterpret_cast<const char*>(&s.position), sizeof(dvec3));
      bytes.append(reinterpret_cast<const char*>(&s.area), sizeof(double));
    }
  EXPECT_EQ(kSamplesVersion, 1);
  EXPECT_EQ(sha256_hex(bytes), "b7eb3d492321b5a190b1bd7ea23c3c84d5b5f2a8163b4023d87a9521499ad241")
      << "raise kSamplesVersion, and put the new version and hash here";
}

}  // namespace
}  // namespace taxel
