// Data of one model share what never changes, as long as one of them exists.
#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "core/layout/file/layout_json.h"
#include "core/mesh/mesh_io.h"
#include "core/sensor/sensor_cache.h"
#include "core/sim/plugin/shared/owned_objects.h"
#include "core/sim/plugin/shared/shared_parts.h"
#include "fixtures/sensor_scene.h"

namespace taxel::test {
namespace {

using IntCache = WeakCache<int, int>;

TEST(WeakCache, MakesAValueOnceAsLongAsItIsUsed) {
  IntCache cache;
  int made = 0;
  const auto make = [&] { return std::make_shared<const int>(++made); };
  IntCache::Pointer first = cache.get(1, make);
  EXPECT_EQ(cache.get(1, make), first);
  EXPECT_EQ(*cache.get(2, make), 2);
  first.reset();
  EXPECT_EQ(*cache.get(1, make), 3);
}

TEST(WeakCache, ForgetsKeysWithoutAValue) {
  IntCache cache;
  for (int key = 0; key < 100; ++key) cache.get(key, [&] { return std::make_shared<const int>(key); });
  EXPECT_LE(cache.size(), 2U);
}

TEST(WeakCache, TriesAgainAfterAnException) {
  IntCache cache;
  EXPECT_THROW(cache.get(1, []() -> IntCache::Pointer { throw Error("no value"); }), Error);
  EXPECT_EQ(*cache.get(1, [] { return std::make_shared<const int>(5); }), 5);
}

TEST(WeakCache, LetsOneOfSeveralThreadsMakeAValue) {
  IntCache cache;
  std::atomic<int> made{0};
  std::vector<IntCache::Pointer> found(8);
  std::vector<std::thread> threads;
  for (IntCache::Pointer& one : found)
    threads.emplace_back([&] { one = cache.get(1, [&] { return std::make_shared<const int>(++made); }); });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(made, 1);
  for (const IntCache::Pointer& one : found) EXPECT_EQ(one, found[0]);
}

TEST(OwnedObjects, AreFoundByTheirOwnerOnly) {
  OwnedObjects objects;
  const int owner = 0, copy_of_owner = 0;
  int object = 0;
  const std::uint64_t number = objects.add(&owner, &object);
  EXPECT_NE(number, 0U);
  EXPECT_EQ(objects.find(&owner, number), &object);
  EXPECT_EQ(objects.find(&copy_of_owner, number), nullptr);
  EXPECT_EQ(objects.remove(&copy_of_owner, number), nullptr);
  EXPECT_EQ(objects.remove(&owner, number), &object);
}

TEST(OwnedObjects, AreNotFoundByALaterOwnerAtTheSameAddress) {
  OwnedObjects objects;
  const int owner = 0;
  int object = 0, later = 0;
  const std::uint64_t number = objects.add(&owner, &object);
  objects.remove(&owner, number);
  EXPECT_EQ(objects.find(&owner, number), nullptr);
  EXPECT_EQ(objects.remove(&owner, number), nullptr);
  EXPECT_EQ(objects.find(&owner, objects.add(&owner, &later)), &later);
  EXPECT_EQ(objects.find(&owner, number), nullptr);
}

TEST(OwnedObjects, RefuseAnyOtherNumber) {
  OwnedObjects objects;
  const int owner = 0;
  int object = 0;
  const std::uint64_t number = objects.add(&owner, &object);
  const std::vector<std::uint64_t> all_wrong{0, 1, number + 1, number + 1000, number + (1ULL << 32), ~0ULL};
  for (const std::uint64_t wrong : all_wrong) EXPECT_EQ(objects.find(&owner, wrong), nullptr) << wrong;
}

TEST(OwnedObjects, MayBeAddedAndFoundByThreadsAtOnce) {
  OwnedObjects objects;
  std::atomic<int> mistakes{0};
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t)
    threads.emplace_back([&] {
      std::vector<int> all(500);
      std::vector<std::uint64_t> numbers;
      for (int round = 0; round < 3; ++round) {
        numbers.clear();
        for (int& one : all) numbers.push_back(objects.add(&one, &one));
        for (std::size_t i = 0; i < all.size(); ++i) mistakes += objects.find(&all[i], numbers[i]) != &all[i];
        for (std::size_t i = 0; i < all.size(); ++i) mistakes += objects.remove(&all[i], numbers[i]) != &all[i];
      }
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(mistakes, 0);
}

constexpr const char* kSharedWorld =
    R"(<asset><mesh name='ball' file='ball.obj'/><mesh name='stone' file='stone.obj'/></asset>
  <worldbody><body pos='0 0 0.019'><freejoint/><geom name='ball' type='mesh' mesh='ball' contype='0' conaffinity='0'/></body>
  <geom name='stone' type='mesh' mesh='stone' pos='0 0 -.02' contype='0' conaffinity='0'/></worldbody></mujoco>)";

class SharedParts : public testing::Test {
 protected:
  void SetUp() override {
    s.add_sensor("ball", make_sphere(0.02, 0.008), {FieldKind::star, 5e4, 0, 5, 0.5});
    save_mesh(s.folder / "stone.obj", make_sphere(0.0205, 0.008));
  }
  void compile_shared() {
    s.compile("<mujoco>" + sensor_extension("ball", key("others", "stone")) + kSharedWorld);
    ASSERT_NE(s.model, nullptr) << s.error;
  }
  SensorScene s;
};

TEST_F(SharedParts, AreThoseOfOtherDataOfTheModel) {
  compile_shared();
  const DataHandle other(mj_makeData(s.model.get()));
  const HydroInstance& theirs = *find_sensor(*other, 0);
  EXPECT_EQ(theirs.model(), s.sensor().model());
  EXPECT_EQ(theirs.touched()[0].body, s.sensor().touched()[0].body);
  EXPECT_NE(&theirs, &s.sensor());
}

TEST_F(SharedParts, GiveTheSameReadingsInOtherData) {
  compile_shared();
  const DataHandle other(mj_makeData(s.model.get()));
  s.step(20);
  for (int step = 0; step < 20; ++step) mj_step(s.model.get(), other.get());
  EXPECT_GT(s.data->sensordata[0], 0);
  EXPECT_EQ(s.data->sensordata[0], other->sensordata[0]);
}

TEST_F(SharedParts, AreTakenFromTheCacheOfAProgramThatCompilesTheLayoutItself) {
  SensorCache cache;
  SensorBuild how;
  how.cache = &cache;
  const std::filesystem::path file = s.folder / "ball.taxels.json";
  const LoadedMesh mesh = load_mesh(s.folder / "ball.obj");
  const SensorModelPtr mine = build_sensor_model(read_layout(file), mesh.mesh, mesh.sha256, file.string(), how);
  {
    const PartsFromCache parts(cache);
    compile_shared();
    EXPECT_EQ(s.sensor().model()->skin, mine->skin);
    s.step(20);
  }
  const double reading = s.data->sensordata[0];
  EXPECT_GT(reading, 0);
  s.data.reset();
  compile_shared();
  EXPECT_NE(s.sensor().model()->skin, mine->skin);
  s.step(20);
  EXPECT_EQ(s.data->sensordata[0], reading);
}

TEST_F(SharedParts, AreFreedWithTheLastData) {
  compile_shared();
  const std::weak_ptr<const SensorModel> model = s.sensor().model();
  const std::weak_ptr<const HydroBody> body = s.sensor().touched()[0].body;
  DataHandle other(mj_makeData(s.model.get()));
  s.data.reset();
  EXPECT_FALSE(model.expired());
  other.reset();
  EXPECT_TRUE(model.expired());
  EXPECT_TRUE(body.expired());
}

TEST_F(SharedParts, AreNewAfterAFileHasChanged) {
  compile_shared();
  const SensorModelPtr before = s.sensor().model();
  Layout layout = read_layout(s.folder / "ball.taxels.json");
  layout.taxels[0].radius *= 0.5;
  write_layout(s.folder / "ball.taxels.json", layout);
  const DataHandle of_layout(mj_makeData(s.model.get()));
  const SensorModelPtr after = find_sensor(*of_layout, 0)->model();
  EXPECT_EQ(after->layout.taxels[0].radius, layout.taxels[0].radius);
  save_mesh(s.folder / "ball.obj", make_sphere(0.0201, 0.008));
  const DataHandle of_mesh(mj_makeData(s.model.get()));
  EXPECT_GT(find_sensor(*of_mesh, 0)->model()->mesh->bounds().hi.z, 0.02005);
  EXPECT_NE(before, after);
  EXPECT_EQ(find_sensor(*of_mesh, 0)->warnings().size(), 1U);  // the mesh of the model is another one now
  EXPECT_TRUE(find_sensor(*of_layout, 0)->warnings().empty());
}

TEST_F(SharedParts, MayBeMadeByThreadsAtOnce) {
  compile_shared();
  s.data.reset();
  std::vector<DataHandle> all(4);
  std::vector<std::thread> threads;
  for (DataHandle& data : all)
    threads.emplace_back([&] {
      data.reset(mj_makeData(s.model.get()));
      for (int step = 0; step < 5; ++step) mj_step(s.model.get(), data.get());
    });
  for (std::thread& thread : threads) thread.join();
  for (const DataHandle& data : all) {
    EXPECT_EQ(find_sensor(*data, 0)->model(), find_sensor(*all[0], 0)->model());
    EXPECT_EQ(data->sensordata[0], all[0]->sensordata[0]);
  }
}

}  // namespace
}  // namespace taxel::test
