// A data set in the window: its episodes are listed, one is opened and repeats its rows bit for bit, and broken data
// sets are refused.
#include <gtest/gtest.h>

#include "script_lines.h"

namespace taxel::test {
namespace {

constexpr const char* kJobs =
    R"({"scenario": {"kind": "press", "hold": 0, "clearance": 0.0002, "tilt_deg": 20, "shape": "plate"}, "set": )"
    R"({"/layout/sampling/density": {"values": [1e5, 2e5]}, "/scenario/depth": {"values": [0.0003, 0.0008]}}})"
    "\n"
    R"({"scenario": {"kind": "press", "hold": 0, "clearance": 0.0002, "tilt_deg": 20}, "set": )"
    R"({"/layout/sampling/density": 1e5, "/scenario/finger_mass": {"values": [0.03, 1e-15]}}})"
    "\n";

/// Writes a data set with five episodes of two layouts, and one failed job.
void write_set(const StudioProgram& studio, const std::string& name, const std::vector<std::string>& more = {}) {
  write_text(studio.folder() / "jobs.jsonl", kJobs);
  std::vector<std::string> arguments{"batch", "jobs.jsonl", "--out", name, "--quiet"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const Outcome outcome = run_program(TAXEL_PROGRAM, arguments, studio.folder());
  ASSERT_EQ(outcome.status, 1) << outcome.err;  // one job fails
}

const std::string kOpenEpisode = press("Data set/Open in the studio");

std::string drop_folder(const std::string& file) {
  return R"({"event": "drop", "files": [")" + file + R"("]})";
}

std::string messages_of(const Json& state) {
  return state["messages"].dump();
}

TEST(DataSetPanel, ListsEpisodesAndFailedJobsAndFiltersThem) {
  const StudioProgram studio;
  write_set(studio, "out");
  studio.play({kIdle, kIdle, dump("all.json"), press("Data set/Filter episodes"), type("0.8"), kIdle, dump("deep.json"),
               key("a", kCtrl), type("inertia"), kIdle, press("Data set/Failed job 5"), kIdle, dump("failed.json"),
               kOpenEpisode, kIdle, dump("same.json")},
              {"out"});
  const Json all = studio.state("all.json")["data_set"];
  EXPECT_EQ(all["episodes"], 5);
  EXPECT_EQ(all["failed"], 1);
  EXPECT_EQ(all["bits"], 32);
  EXPECT_EQ(all["parameters"], Json({"Density (1/mm\u00b2)", "Depth (mm)", "Finger mass (g)"}));
  ASSERT_EQ(all["listed"].size(), 6U);
  EXPECT_NE(all["listed"][5].get<std::string>().find("inertia"), std::string::npos);
  EXPECT_EQ(all["curves"]["episode"], 0);
  EXPECT_GT(all["curves"]["rows"].get<int>(), 5);
  EXPECT_GT(all["curves"]["largest"].get<double>(), 0);
  EXPECT_EQ(studio.state("deep.json")["data_set"]["listed"].size(), 2U);
  const Json failed = studio.state("failed.json");
  EXPECT_EQ(failed["data_set"]["chosen"], 5);
  EXPECT_EQ(studio.state("same.json")["document"], failed["document"]) << "the button of a failed job is disabled";
}

/// Opens the third episode, whose layout is not that of the first one, and waits for the end of its run.
class Replayed : public testing::TestWithParam<int> {};

TEST_P(Replayed, EqualsTheEpisode) {
  const StudioProgram studio;
  write_set(studio, "out", GetParam() == 64 ? std::vector<std::string>{"--float64"} : std::vector<std::string>{});
  studio.play({kIdle, kIdle, press("Data set/Episode 4"), kIdle, kOpenEpisode, kIdle, at_frame(900), dump("run.json"),
               R"({"do": "screenshot", "file": "replay.png"})"},
              {"out/meta/info.json"});
  const Json state = studio.state("run.json"), replay = state["data_set"]["replay"];
  EXPECT_EQ(state["data_set"]["bits"], GetParam());
  EXPECT_EQ(state["document"]["layout"]["sampling"]["density"], 2e5);
  EXPECT_EQ(state["scenario"]["running"]["depth"], 0.0008);
  EXPECT_EQ(replay["episode"], 4);
  EXPECT_GT(replay["of"].get<int>(), 10);
  EXPECT_EQ(replay["rows"], replay["of"]);
  EXPECT_EQ(replay["different"], 0);
  EXPECT_EQ(replay["largest"], 0);
  const std::string text = replay["text"];
  EXPECT_EQ(text.find("The replay equals episode 4"), 0U) << text;
  EXPECT_EQ(text.find("bit for bit") != std::string::npos, GetParam() == 64) << text;
}

INSTANTIATE_TEST_SUITE_P(Bits, Replayed, testing::Values(32, 64));

TEST(DataSetPanel, OpensADroppedFolderNextToTheDocument) {
  const StudioProgram studio;
  write_set(studio, "out");
  studio.play({kIdle, drop_folder((studio.folder() / "out").string()), kIdle, kIdle, dump("both.json")}, {kLayoutFile});
  const Json both = studio.state("both.json");
  EXPECT_EQ(both["data_set"]["episodes"], 5);
  EXPECT_EQ(both["document"]["file"], kLayoutFile) << "the document stays";
  EXPECT_EQ(both["data_set"]["replay"], nullptr);
}

TEST(DataSetPanel, ComparesNoEditedDocument) {
  const StudioProgram studio;
  write_set(studio, "out", {"--float64"});
  studio.play({kIdle, kIdle, kOpenEpisode, kIdle, at_frame(600), kLayoutMode, kIdle, key("a"), key("Delete"), kIdle,
               dump("edited.json"), key("z", kCtrl), kIdle, key("2", kCtrl), kIdle, key("r", kCtrl), at_frame(1500),
               dump("undone.json")},
              {"out"});
  const std::string edited = studio.state("edited.json")["data_set"]["replay"]["text"];
  EXPECT_NE(edited.find("the document was edited"), std::string::npos) << edited;
  const Json undone = studio.state("undone.json")["data_set"]["replay"];
  EXPECT_EQ(undone["rows"], undone["of"]);
  EXPECT_EQ(undone["different"], 0);
}

TEST(DataSetPanel, AsksBeforeAnEpisodeReplacesUnsavedEdits) {
  const StudioProgram studio;
  write_set(studio, "out");
  studio.play(
      {kIdle, kLayoutMode, kIdle, key("a"), key("Delete"), kIdle, drop_folder((studio.folder() / "out").string()),
       kIdle, kIdle, dump("set.json"), kOpenEpisode, kIdle, dump("asked.json")},
      {kLayoutFile});
  EXPECT_EQ(studio.state("set.json")["data_set"]["episodes"], 5) << "a data set leaves no document";
  const Json asked = studio.state("asked.json");
  EXPECT_EQ(asked["document"]["file"], kLayoutFile);
  EXPECT_NE(asked["widgets"].dump().find("Discard"), std::string::npos);
}

/// A data set whose files are broken one after the other.
class BrokenDataSet : public testing::Test {
 protected:
  void SetUp() override { write_set(studio_, "out"); }
  [[nodiscard]] std::filesystem::path file(const std::string& name) const { return studio_.folder() / "out" / name; }
  [[nodiscard]] std::filesystem::path mesh() const {
    return std::filesystem::directory_iterator(file("meta/meshes"))->path();
  }
  /// Opens the data set at the start. Returns the messages on stderr, without a run of the program that succeeded.
  [[nodiscard]] std::string refusal() const {
    const Outcome outcome = studio_.run({kIdle, kIdle}, {"out"});
    EXPECT_NE(outcome.status, 0);
    return outcome.err;
  }
  /// Opens the first episode on top of a document. Returns the messages.
  [[nodiscard]] std::string refused_episode() const {
    studio_.play({kIdle, drop_folder(file("").string()), kIdle, kIdle, kOpenEpisode, kIdle, dump("left.json")},
                 {kLayoutFile});
    const Json left = studio_.state("left.json");
    EXPECT_EQ(left["document"]["file"], kLayoutFile) << "the document stays";
    return messages_of(left);
  }

  StudioProgram studio_;
};

TEST_F(BrokenDataSet, IsRefusedWithFileAndRemedy) {
  Json head = Json::parse(file_text(file("meta/taxel.json")));
  head["version"] = 2;
  write_text(file("meta/taxel.json"), head.dump());
  EXPECT_NE(refusal().find("out/meta/taxel.json: /version: is 2, this program reads version 1: update this program"),
            std::string::npos);
  head["version"] = 1;
  head["episodes"] = 9;
  write_text(file("meta/taxel.json"), head.dump());
  EXPECT_NE(refusal().find("/episodes: is 9, but meta/episodes/chunk-000/file-000.parquet has 5 rows"),
            std::string::npos);
  std::filesystem::remove(file("meta/layouts.parquet"));
  EXPECT_NE(refusal().find("out/meta/layouts.parquet: no such file"), std::string::npos);
  std::filesystem::remove_all(file("meta"));
  EXPECT_NE(refusal().find("the batch is not finished"), std::string::npos);
}

TEST_F(BrokenDataSet, NamesTheMeshThatIsMissingOrWasChanged) {
  const std::filesystem::path path = mesh();
  write_text(path, file_text(path) + "# changed\n");
  EXPECT_NE(refused_episode().find("was changed since the data set was written"), std::string::npos);
  std::filesystem::remove(path);
  EXPECT_NE(refused_episode().find("no such file: the layout of episode 0 has this mesh"), std::string::npos);
}

TEST_F(BrokenDataSet, NamesTheObjectOfTheScenarioThatIsMissing) {
  std::filesystem::remove_all(file(""));
  std::filesystem::copy_file(kMeshFile, studio_.folder() / "object.obj");
  write_text(studio_.folder() / "jobs.jsonl",
             R"({"scenario": {"kind": "press", "hold": 0, "clearance": 0.0002, "object": "object.obj"}, )"
             R"("set": {"/layout/sampling/density": 1e5}})");
  const Outcome outcome =
      run_program(TAXEL_PROGRAM, {"batch", "jobs.jsonl", "--out", "out", "--quiet"}, studio_.folder());
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  std::filesystem::remove(studio_.folder() / "object.obj");
  const std::string refused = refused_episode();
  EXPECT_NE(refused.find("scenario of episode 0: /object: "), std::string::npos) << refused;
  EXPECT_NE(refused.find("object.obj: no such file; put the file there to play the episode"), std::string::npos);
}

TEST_F(BrokenDataSet, ShowsWhyTheRowsCannotBeRead) {
  const std::string rows = file_text(file("data/chunk-000/file-000.parquet"));
  write_text(file("data/chunk-000/file-000.parquet"), rows.substr(0, rows.size() / 2));
  studio_.play({kIdle, kIdle, dump("cut.json")}, {"out"});
  const Json curves = studio_.state("cut.json")["data_set"]["curves"];
  EXPECT_NE(curves["problem"].get<std::string>().find("file-000.parquet"), std::string::npos) << curves;
}

}  // namespace
}  // namespace taxel::test
