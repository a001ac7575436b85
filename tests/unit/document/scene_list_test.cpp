// Lists of jobs that run scenes: the keys of a scene, random starts, ids, and refused input.
#include <gtest/gtest.h>

#include <set>

#include "core/base/files.h"
#include "core/document/batch/job.h"
#include "core/document/batch/job_sources.h"
#include "fixtures/temp_folder.h"

namespace taxel::test {
namespace {

/// A folder with a scene and a table, and a reader that accepts all scenes.
class SceneList : public testing::Test {
 protected:
  SceneList() {
    write_file_atomically(folder_ / "hand.xml", "<mujoco/>");
    write_file_atomically(folder_ / "close.csv", "time,close\n0,0\n1,0.5\n");
  }
  JobList expand(const std::string& text) {
    JobSources sources({}, [&](const SceneJob& scene) {
      seen_.push_back(scene);
      return SceneFacts{{scene.file}};
    });
    return parse_job_list(text, "jobs.jsonl", folder_.path(), sources);
  }
  /// Returns the message of a line that gives no jobs.
  std::string broken(const std::string& line) {
    const JobList list = expand(line);
    return list.broken.size() == 1 && list.jobs.empty() ? list.broken[0].message : "accepted";
  }

  TempFolder folder_;
  std::vector<SceneJob> seen_;  // scenes that the reader has checked
};

TEST_F(SceneList, ReadsAllKeysOfAScene) {
  const JobList list = expand(
      R"({"scene": {"file": "hand.xml", "keyframe": 2, "controls": "close.csv", "seconds": 3, "record_interval": 0.02, )"
      R"("attach": [{"layout": "tip.yaml", "body": "tip", "others": "ball", "sisters": "keep"}], )"
      R"("moves": {"ball": {"x": 0.01, "turn_z_deg": 90}}, "geoms": {"ball": {"type": "box", "size": [1, 2, 3], )"
      R"("mass": 0.1, "friction": 0}}}, "task": "grasp"})");
  ASSERT_EQ(list.jobs.size(), 0U) << "tip.yaml is missing";
  const SceneJob scene = seen_.back();
  EXPECT_EQ(scene.file, (folder_ / "hand.xml").string());
  EXPECT_EQ(scene.controls, (folder_ / "close.csv").string());
  EXPECT_EQ(scene.keyframe, "2");
  EXPECT_EQ(scene.seconds, 3);
  EXPECT_EQ(scene.record_interval, 0.02);
  EXPECT_EQ(scene.attach, (std::vector<JobAttachment>{{(folder_ / "tip.yaml").string(), "", "tip", "ball", true}}));
  EXPECT_EQ(scene.moves, (std::vector<BodyMove>{{"ball", {0.01, 0, 0}, {0, 0, 90}}}));
  EXPECT_EQ(scene.geoms, (std::vector<GeomChange>{{"ball", "box", {1, 2, 3}, 0.1, 0.0}}));
  EXPECT_EQ(parse_scene_job(scene_job_to_json(scene), "/"), scene);
}

TEST_F(SceneList, DrawsStartsAndChoosesObjectsBySeed) {
  const std::string line =
      R"({"scene": {"file": "hand.xml", "seconds": 1}, "repeat": 40, "set": {"/scene/moves/ball/x": )"
      R"({"uniform": [-0.01, 0.01]}, "/scene/geoms/ball": {"choice": [{"type": "sphere", "size": [0.02]}, )"
      R"({"type": "box", "size": [0.02, 0.02, 0.02]}]}}})";
  const JobList list = expand(line);
  ASSERT_EQ(list.jobs.size(), 40U) << (list.broken.empty() ? "" : list.broken[0].message);
  std::set<double> places;
  std::set<std::string> types, keys;
  for (const Job& job : list.jobs) {
    ASSERT_EQ(job.error, "");
    const double x = job.scene->moves.at(0).shift_W.x;
    EXPECT_TRUE(x >= -0.01 && x <= 0.01);
    places.insert(x);
    types.insert(job.scene->geoms.at(0).type);
    keys.insert(job.layout_key);
    EXPECT_EQ(job.task, "hand");
  }
  EXPECT_EQ(places.size(), 40U);
  EXPECT_EQ(types, (std::set<std::string>{"box", "sphere"}));
  EXPECT_EQ(keys.size(), 2U) << "one for each compiled scene";
  EXPECT_EQ(group_jobs(list, 100).size(), 2U);
  EXPECT_EQ(expand(line).sha256, list.sha256);
  std::string other = line;
  other.insert(1, R"("seed": 3, )");
  EXPECT_NE(expand(other).jobs[0].scene->moves, list.jobs[0].scene->moves);
}

TEST_F(SceneList, HasIdsOfTheContentOfFiles) {
  const std::string line = R"({"scene": {"file": "hand.xml", "controls": "close.csv"}})";
  const std::string before = expand(line).jobs.at(0).id;
  write_file_atomically(folder_ / "other.xml", "<mujoco/>");
  EXPECT_EQ(expand(R"({"scene": {"file": "other.xml", "controls": "close.csv"}})").jobs.at(0).id, before);
  write_file_atomically(folder_ / "close.csv", "time,close\n0,0\n1,0.6\n");
  EXPECT_NE(expand(line).jobs.at(0).id, before);
  write_file_atomically(folder_ / "close.csv", "time,close\n0,0\n1,0.5\n");
  write_file_atomically(folder_ / "hand.xml", "<mujoco />");
  EXPECT_NE(expand(line).jobs.at(0).id, before);
}

TEST_F(SceneList, ChangesControlsWithinTheJob) {
  const JobList list =
      expand(R"({"scene": {"file": "hand.xml", "controls": {"time": [0, 1], "index close": [0, 0.5]}}, )"
             R"("set": {"/scene/controls/index close/1": {"values": [0.2, 0.4]}}})");
  ASSERT_EQ(list.jobs.size(), 2U);
  EXPECT_EQ(list.jobs[1].scene->table->values.at("index close"), (std::vector<double>{0, 0.4}));
}

TEST_F(SceneList, PutsThePointerOfABadValueFirst) {
  const auto scene = [&](const std::string& keys) {
    return broken("{\"scene\": {\"file\": \"hand.xml\"" + keys + "}}");
  };
  EXPECT_EQ(scene(""), "/scene/seconds: is missing: no table of controls or poses ends the run");
  EXPECT_EQ(scene(R"(, "secnds": 1)").substr(0, 14), "/scene/secnds:");
  EXPECT_EQ(scene(R"(, "seconds": 0)"), "/scene/seconds: must be a number greater than 0, is 0");
  EXPECT_EQ(scene(R"(, "seconds": 1, "geoms": {"b": {"type": "torus"}})"),
            "/scene/geoms/b/type: must be sphere, capsule, ellipsoid, cylinder or box, is \"torus\"");
  EXPECT_EQ(scene(R"(, "seconds": 1, "geoms": {"b": {"type": "box"}})"),
            "/scene/geoms/b: must have a size with the type");
  EXPECT_EQ(scene(R"(, "seconds": 1, "attach": [{"layout": "l", "geom": "a", "body": "b"}])"),
            "/scene/attach/0/body: excludes geom: name one of the two");
  EXPECT_EQ(scene(R"(, "controls": {"time": [0, 1], "a": [1]})"),
            "/scene/controls/a: must have a value for each of the 2 times, has 1");
  EXPECT_EQ(scene(R"(, "controls": {"time": [1, 1], "a": [1, 2]})"),
            "/scene/controls/time/1: must be later than the time before");
  EXPECT_EQ(scene(R"(, "controls": "close.csv", "policy": "p")"),
            "/scene/policy: excludes controls: both set the controls of actuators");
  EXPECT_NE(scene(R"(, "controls": "missing.csv")").find("missing.csv"), std::string::npos);
  EXPECT_EQ(broken(R"({"scene": "hand.xml", "scenario": {"kind": "press"}})"),
            "/scenario: excludes a scene, which has its own sensors and motions");
  EXPECT_EQ(broken(R"({"scene": {"file": "hand.xml", "seconds": 1}, "set": {"/scenario/depth": 1}})"),
            "/set/~1scenario~1depth: must begin with /scene/");
  EXPECT_EQ(broken(R"({"scene": {"file": "hand.xml", "seconds": 1}, "set": {"/scene/seconds": {"choice": []}}})"),
            "/set/~1scene~1seconds/choice: must have at least one value");
}

TEST_F(SceneList, IsRefusedForAProgramWithoutScenes) {
  JobSources sources;
  const JobList list =
      parse_job_list(R"({"scene": {"file": "hand.xml", "seconds": 1}})", "jobs.jsonl", folder_.path(), sources);
  ASSERT_EQ(list.broken.size(), 1U);
  EXPECT_EQ(list.broken[0].message, "/scene/file: names a scene, which this program does not run");
}

}  // namespace
}  // namespace taxel::test
