// The plugin library in a program that is linked to nothing but MuJoCo, as a user's program is: data of the robot hand
// that grasps a ball are made, copied and freed, in one thread and while other threads step. The sanitizers run the
// same tests.
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <thread>
#include <vector>

namespace {

struct Deleter {
  void operator()(mjModel* m) const { mj_deleteModel(m); }
  void operator()(mjData* d) const { mj_deleteData(d); }
};
using ModelHandle = std::unique_ptr<mjModel, Deleter>;
using DataHandle = std::unique_ptr<mjData, Deleter>;
using Readings = std::vector<double>;
constexpr int kSteps = 60;

class PluginLibrary : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    mj_loadPluginLibrary(TAXEL_PLUGIN);
    char reason[2000] = "";
    model_.reset(mj_loadXML(TAXEL_SOURCE_DIR "/assets/scenes/hand_grasps_ball.xml", nullptr, reason, sizeof reason));
    ASSERT_NE(model_, nullptr) << reason;
  }
  static void TearDownTestSuite() { model_.reset(); }

  static const mjModel* model() { return model_.get(); }

  /// Returns new data whose fingers hold the ball.
  static DataHandle make_data() {
    DataHandle data(mj_makeData(model()));
    mj_resetDataKeyframe(model(), data.get(), 0);
    return data;
  }

  /// Returns the readings of all steps, one step after another.
  static Readings run(mjData& data, int steps) {
    Readings all;
    for (int n = 0; n < steps; ++n) {
      mj_step(model(), &data);
      all.insert(all.end(), data.sensordata, data.sensordata + model()->nsensordata);
    }
    return all;
  }

  /// Returns data with the state of others and with their numbers for the plugin, as Python's pickle makes them.
  static DataHandle copy_bytes(const mjData& data) {
    DataHandle copy = make_data();
    copy_state(data, *copy);
    for (int i = 0; i < model()->nplugin; ++i) {
      mjp_getPluginAtSlot(model()->plugin[i])->destroy(copy.get(), i);
      copy->plugin_data[i] = data.plugin_data[i];
    }
    return copy;
  }
  static void copy_state(const mjData& from, mjData& to) {
    std::vector<double> state(static_cast<std::size_t>(mj_stateSize(model(), mjSTATE_INTEGRATION)));
    mj_getState(model(), &from, state.data(), mjSTATE_INTEGRATION);
    mj_setState(model(), &to, state.data(), mjSTATE_INTEGRATION);
  }

 private:
  static inline ModelHandle model_;
};

TEST_F(PluginLibrary, ReadsTheGraspOfAllFingers) {
  const Readings readings = run(*make_data(), 20);
  EXPECT_GT(*std::max_element(readings.begin(), readings.end()), 1000);
}

TEST_F(PluginLibrary, LeavesNothingBehindAfterAThousandData) {
  const DataHandle kept = make_data();  // the others share its parts
  const Readings expected = run(*kept, 1);
  for (int n = 0; n < 1000; ++n) ASSERT_EQ(run(*make_data(), 1), expected) << n;
}

TEST_F(PluginLibrary, BuildsSharedPartsAgainAfterTheirLastDataAreFreed) {
  const Readings expected = run(*make_data(), 1);
  for (int n = 0; n < 3; ++n) EXPECT_EQ(run(*make_data(), 1), expected);
}

TEST_F(PluginLibrary, FreesManyDataInAnyOrder) {
  std::vector<DataHandle> all(64);
  for (DataHandle& data : all) data = make_data();
  for (std::size_t k = 0; k < all.size(); ++k) all[k * 37 % all.size()].reset();
  EXPECT_EQ(run(*make_data(), 2), run(*make_data(), 2));
}

TEST_F(PluginLibrary, ContinuesCopiesOfDataLikeTheOriginal) {
  const DataHandle original = make_data();
  run(*original, 5);
  const DataHandle copy(mj_copyData(nullptr, model(), original.get()));
  const DataHandle over_another = make_data();
  run(*over_another, 3);
  mj_copyData(over_another.get(), model(), original.get());
  DataHandle source(mj_copyData(nullptr, model(), original.get()));
  const DataHandle of_copy(mj_copyData(nullptr, model(), source.get()));
  source.reset();
  const Readings expected = run(*original, 5);
  for (mjData* one : {copy.get(), over_another.get(), of_copy.get()}) EXPECT_EQ(run(*one, 5), expected);
}

TEST_F(PluginLibrary, GivesBytewiseCopiesSensorsOfTheirOwn) {
  DataHandle original = make_data();
  run(*original, 5);
  const DataHandle copy = copy_bytes(*original);
  const DataHandle of_copy(mj_copyData(nullptr, model(), copy.get()));  // before the first step of its source
  const DataHandle late = copy_bytes(*original);
  const DataHandle unused = copy_bytes(*original);  // is freed without a step
  const Readings expected = run(*original, 5);
  original.reset();
  for (mjData* one : {copy.get(), of_copy.get(), late.get()}) EXPECT_EQ(run(*one, 5), expected);
}

TEST_F(PluginLibrary, StartsAgainAfterAReset) {
  const DataHandle data = make_data();
  const Readings expected = run(*data, 5);
  mj_resetData(model(), data.get());
  mj_resetDataKeyframe(model(), data.get(), 0);
  EXPECT_EQ(run(*data, 5), expected);
}

TEST_F(PluginLibrary, GivesTheBytesOfALoopInThreadsWhileOthersMakeAndFreeData) {
  const Readings expected = run(*make_data(), kSteps);
  std::vector<Readings> found(3);
  std::atomic<bool> has_ended = false;
  std::vector<std::thread> threads;
  std::thread making([&] {
    std::vector<DataHandle> kept(5);
    for (std::size_t n = 0; !has_ended; ++n) {
      kept[n % kept.size()] = make_data();
      if (n % kept.size() != 0) mj_copyData(kept[n % kept.size()].get(), model(), kept[0].get());
      run(*kept[n % kept.size()], 1);
    }
  });
  for (Readings& one : found)
    threads.emplace_back([&one] {
      run(*make_data(), 1);
      one = run(*make_data(), kSteps);  // each thread makes and frees its own data
    });
  for (std::thread& thread : threads) thread.join();
  has_ended = true;
  making.join();
  for (const Readings& one : found) EXPECT_EQ(one, expected);
}

TEST_F(PluginLibrary, StepsDataInOneThreadAfterAnother) {
  const Readings expected = run(*make_data(), 12);
  const DataHandle data = make_data();
  Readings found;
  for (int n = 0; n < 12; ++n)
    std::thread([&] {
      const Readings step = run(*data, 1);
      found.insert(found.end(), step.begin(), step.end());
    }).join();
  EXPECT_EQ(found, expected);
}

TEST_F(PluginLibrary, BuildsSharedPartsOnceForThreadsThatMakeTheFirstData) {
  const ModelHandle other(mj_copyModel(nullptr, model()));
  std::vector<std::thread> threads;
  std::vector<Readings> found(3);
  for (Readings& one : found)
    threads.emplace_back([&] {
      const DataHandle data(mj_makeData(other.get()));
      mj_step(other.get(), data.get());
      one.assign(data->sensordata, data->sensordata + other->nsensordata);
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(found[1], found[0]);
  EXPECT_EQ(found[2], found[0]);
}

}  // namespace
