// Batches of scenes: rows of all sensors, starts, shapes and controls; the same bytes with any number of workers.
#include <gtest/gtest.h>

#include <atomic>
#include <map>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/document/batch/job.h"
#include "core/document/batch/job_sources.h"
#include "core/run/batch/scene_episode.h"
#include "core/run/batch/shard.h"
#include "core/sim/batch/job_package.h"
#include "core/sim/batch/run_batch.h"
#include "core/sim/batch/scene_jobs.h"
#include "core/sim/scene/changed_geoms.h"
#include "fixtures/complaint.h"
#include "fixtures/temp_folder.h"

namespace taxel::test {
namespace {

namespace fs = std::filesystem;

/// A fingertip on a slide over a free box on the floor.
constexpr const char* kScene = "\"scene\": {\"file\": \"" TAXEL_SOURCE_DIR "/assets/scenes/press.xml\"";

/// Returns the line of a list, with more keys of the scene and of the job.
std::string line_of(const std::string& scene, const std::string& job = "") {
  return std::string("{") + kScene + ", " + scene + "}" + job + "}\n";
}

class SceneBatch : public testing::Test {
 protected:
  JobList list_of(const std::string& text) {
    JobList list = parse_job_list(text, "jobs.jsonl", folder_.path(), sources_);
    for (const BrokenLine& line : list.broken) broken_.push_back(line.message);
    return list;
  }
  /// Runs a list, and returns the shards.
  std::vector<Shard> run(const JobList& list, const std::string& name, int workers = 1, int group = 16,
                         const JobPolicy& policy = {}) {
    BatchSettings settings;
    settings.folder = folder_ / name;
    settings.workers = workers;
    settings.format = {true, false, group, 0};
    settings.policy = policy;
    result_ = run_batch(list, sources_, settings, {});
    std::vector<Shard> shards;
    for (const JobGroup& one : group_jobs(list, static_cast<std::size_t>(group)))
      shards.emplace_back(settings.folder / shard_name(one.id));
    return shards;
  }
  [[nodiscard]] std::map<std::string, std::string> files_of(const std::string& name) const {
    std::map<std::string, std::string> files;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder_ / name)) {
      const std::string file = fs::relative(entry.path(), folder_ / name).string();
      if (entry.is_regular_file() && !file.starts_with(".batch")) files[file] = read_file(entry.path());
    }
    return files;
  }

  TempFolder folder_;
  SceneChecker checker_;
  JobSources sources_{{}, [this](const SceneJob& scene) { return checker_.check(scene); }};
  std::vector<std::string> broken_;
  BatchResult result_;
};

TEST_F(SceneBatch, RecordsSensorsBodiesJointsAndActions) {
  const JobList list = list_of(
      line_of(R"("record_interval": 0.01, "controls": {"time": [0, 0.2], "actuator 0": [0, -0.02]}, "seconds": 0.4)"));
  ASSERT_EQ(list.jobs.size(), 1U) << broken_.front();
  const Shard shard = std::move(run(list, "out").front());
  ASSERT_EQ(shard.head().outcomes.at(0).error, "");
  const std::int64_t rows = shard.head().outcomes.at(0).rows;
  EXPECT_EQ(rows, 41);
  const auto column = [&](const std::string& name) { return shard.rows(name, 0, rows); };
  EXPECT_NEAR(column("timestamp").values[40], 0.4, 1e-12);
  EXPECT_EQ(column("observation.tactile.fingertip").width, 12U);
  EXPECT_EQ(column("action").values[0], 0);
  EXPECT_NEAR(column("action").values[10], -0.01, 1e-12) << "the table is linear";
  EXPECT_EQ(column("action").values[40], -0.02);
  EXPECT_EQ(column("observation.pose.box").width, 7U);
  EXPECT_NEAR(column("observation.pose.box").values[2], 0.02, 1e-9) << "the box begins on the floor";
  EXPECT_EQ(column("observation.state").values[0], 0);
  EXPECT_LT(column("observation.state").values[40], -0.001) << "the slide moves down";
  const EpisodeScene& scene = *shard.head().scene;
  EXPECT_EQ(scene.sensors, std::vector<std::string>{"fingertip"});
  EXPECT_EQ(scene.state, std::vector<std::string>{"slide"});
  EXPECT_EQ(scene.state_unit, "m");
  EXPECT_EQ(scene.action, std::vector<std::string>{"actuator 0"});
  EXPECT_EQ(scene.layouts.at(0).taxel_ids.size(), 12U);
  EXPECT_GT(shard.head().outcomes.at(0).summary.peak, 100);
  EXPECT_EQ(shard.head().outcomes.at(0).summary.peak_sensor, "fingertip");
}

TEST_F(SceneBatch, GivesTheWrenchAboutTheOriginOfTheMesh) {
  const JobList list = list_of(line_of(R"("controls": {"time": [0, 0.2], "actuator 0": [0, -0.02]}, "seconds": 0.4)"));
  const Shard shard = std::move(run(list, "out").front());
  const std::int64_t rows = shard.head().outcomes.at(0).rows;
  const std::vector<double> force = shard.rows("observation.force.fingertip", rows - 1, 1).values,
                            torque = shard.rows("observation.torque.fingertip", rows - 1, 1).values;
  EXPECT_GT(force[2], 0.05) << "the box pushes up";
  // The finger's origin is at y = 22 mm and its pad touches the box near y = 0 or below: a force up in front of the
  // origin turns about -x.
  EXPECT_LT(torque[0] / force[2], 0);
  EXPECT_GT(torque[0] / force[2], -0.05);
}

TEST_F(SceneBatch, PlacesBodiesAndChangesShapes) {
  const JobList list = list_of(
      line_of(R"("seconds": 0.01, "moves": {"box": {"x": 0.003, "z": 0.2, "turn_z_deg": 90}})") +
      line_of(
          R"("seconds": 1, "geoms": {"box": {"type": "sphere", "size": [0.03]}}, "moves": {"box": {"y": 0.1, "z": 0.05}})"));
  ASSERT_EQ(list.jobs.size(), 2U) << broken_.front();
  const std::vector<Shard> shards = run(list, "out");
  ASSERT_EQ(shards.size(), 2U) << "two compiled scenes";
  const std::vector<double> moved = shards[0].rows("observation.pose.box", 0, 1).values;
  EXPECT_NEAR(moved[0], 0.003, 1e-12);
  EXPECT_NEAR(moved[2], 0.22, 1e-12);
  EXPECT_NEAR(moved[3], std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(moved[6], std::sqrt(0.5), 1e-12);
  const std::int64_t last = shards[1].head().outcomes.at(0).rows - 1;
  EXPECT_NEAR(shards[1].rows("observation.pose.box", last, 1).values[2], 0.03, 1e-3) << "a sphere lies at its radius";
}

TEST_F(SceneBatch, HasTheSameBytesWithAnyNumberOfWorkersAndAnyOrder) {
  const JobList list =
      list_of(line_of(R"("controls": {"time": [0, 0.1], "actuator 0": [0, -0.02]}, "seconds": 0.15)",
                      R"(, "repeat": 6, "set": {"/scene/moves/box/x": {"uniform": [-0.004, 0.004]}})"));
  run(list, "one", 1, 2);
  run(list, "two", 2, 2);
  EXPECT_EQ(files_of("one"), files_of("two"));
  run(list, "single", 1, 1);  // each job in a group of its own
  std::vector<double> together, alone;
  for (const Shard& shard : run(list, "one", 1, 2)) {
    for (const double value : shard.rows("observation.tactile.fingertip", 0, 32).values) together.push_back(value);
  }
  for (const Shard& shard : run(list, "single", 1, 1))
    for (const double value : shard.rows("observation.tactile.fingertip", 0, 16).values) alone.push_back(value);
  EXPECT_EQ(together, alone) << "an earlier run in the same simulator leaves nothing behind";
}

TEST_F(SceneBatch, LetsAPolicyActOnTheRowsThatItRecords) {
  const JobList list = list_of(line_of(R"("policy": "press harder", "seconds": 0.3)"));
  ASSERT_EQ(list.jobs.size(), 1U) << broken_.front();
  std::vector<std::vector<double>> seen;
  std::vector<double> times;
  const JobPolicy policy = [&](const Job& job, const EpisodeScene&, const Episode& row) {
    EXPECT_EQ(job.scene->policy, "press harder");
    for (const EpisodeColumn& column : row.columns) {
      if (column.name == "observation.tactile.fingertip") seen.push_back(column.values);
      if (column.name == "timestamp") times.push_back(column.values.front());
    }
    return std::vector<double>{-0.0005 * static_cast<double>(times.size())};
  };
  const Shard shard = std::move(run(list, "out", 1, 16, policy).front());
  ASSERT_EQ(shard.head().outcomes.at(0).error, "");
  ASSERT_EQ(times.size(), 31U);
  const std::vector<double> recorded = shard.rows("observation.tactile.fingertip", 0, 31).values;
  std::vector<double> all;
  for (const std::vector<double>& row : seen) all.insert(all.end(), row.begin(), row.end());
  EXPECT_EQ(all, recorded);
  EXPECT_EQ(shard.rows("timestamp", 0, 31).values, times);
  EXPECT_EQ(shard.rows("action", 0, 3).values, (std::vector<double>{-0.0005, -0.001, -0.0015}));
}

TEST_F(SceneBatch, RefusesNamesThatAreNotInTheScene) {
  const auto message = [&](const std::string& scene) {
    broken_.clear();
    list_of(line_of(scene));
    return broken_.empty() ? "accepted" : broken_.front();
  };
  EXPECT_EQ(
      message(R"("seconds": 1, "moves": {"bax": {"x": 1}})"),
      "/scene/moves/bax: is no body with a free joint and no mocap body: there are \"box\"; did you mean \"box\"?");
  EXPECT_EQ(message(R"("seconds": 1, "geoms": {"box": {"size": [1]}})"),
            "/scene/geoms/box/size: must have 3 numbers for a box, has 1");
  EXPECT_EQ(message(R"("seconds": 1, "record_interval": 0.0015)"),
            "/scene/record_interval: must be a whole number of time steps of 0.001 s, is 0.0015 s: a row would lie "
            "between two steps");
  EXPECT_EQ(message(R"("seconds": 1, "keyframe": "open")"), "/scene/keyframe: has no keyframe");
  EXPECT_EQ(message(R"("controls": {"time": [0], "slide": [1]})"),
            "/scene/controls/slide: is no actuator: there are \"actuator 0\"");
  const JobList list = list_of(line_of(R"("policy": "p", "seconds": 0.1)"));
  EXPECT_EQ(run(list, "out").front().head().outcomes.at(0).error,
            "/scene/policy: is called by taxel.batch(jobs, out, policy=...) in Python alone");
  try {
    list_of(line_of(R"("seconds": 1)") + R"({"scenario": {"kind": "press"}, "layout": ")" TAXEL_SOURCE_DIR
                                         R"(/assets/layouts/fingertip.taxels.json"})");
    FAIL();
  } catch (const Error& e) {
    EXPECT_EQ(e.where(), "line 1");
  }
}

TEST_F(SceneBatch, IsRefusedByReadersOfScenariosAndByOtherMachines) {
  const JobList list = list_of(line_of(R"("seconds": 0.01)"));
  run(list, "out");
  EXPECT_EQ(complaint_of([&] { read_batch_index(folder_ / "out"); }),
            (folder_ / "out/batch.json").string() +
                ": /runs: is scenes: read a batch of scenes in Python, by python -m taxel.data_set");
  EXPECT_EQ(complaint_of([&] { pack_group(list, group_jobs(list, 1).front(), {}, sources_); }),
            "a group of scenes cannot be packed: the files of a scene do not travel");
}

TEST(SceneColumns, HaveNamesWithoutSlashes) {
  SimScene scene;
  for (const char* name : {"world", "left/ball", "left_ball"}) scene.controls.bodies.push_back({name});
  scene.controls.bodies[1].free = scene.controls.bodies[2].free = true;
  SceneColumns columns(scene, "key", "hand.xml", false);
  SceneRow row;
  row.bodies.resize(3);
  columns.add(row);
  std::vector<std::string> names;
  for (const EpisodeColumn& column : columns.episode().columns) names.push_back(column.name);
  EXPECT_EQ(names,
            (std::vector<std::string>{"timestamp", "observation.pose.left_ball", "observation.pose.left_ball_2"}));
}

TEST(ChangeGeoms, NamesTheGeomThatIsNotThereAndTheMassWithoutEffect) {
  const std::string xml =
      "<mujoco><worldbody><body name='b'><freejoint/><inertial pos='0 0 0' mass='1' diaginertia='1 1 1'/>"
      "<geom name='ball' size='0.1'/></body></worldbody></mujoco>";
  const auto complaint = [&](const GeomChange& change) {
    CompiledScene scene = compile_scene(xml, {}, "scene.xml");
    return complaint_of([&] { change_geoms(scene, {change}, "scene.xml"); });
  };
  EXPECT_EQ(complaint({"bell", "", {0.2}, {}, {}}),
            "/geoms/bell: is no geom of the scene: there are \"ball\"; did you mean \"ball\"?");
  EXPECT_EQ(complaint({"ball", "", {}, 0.5, {}}),
            "/geoms/ball/mass: has no effect: the body has an <inertial> in the scene");
  EXPECT_EQ(complaint({"ball", "capsule", {0.2, 0.1}, {}, 0.3}), "accepted");
}

}  // namespace
}  // namespace taxel::test
