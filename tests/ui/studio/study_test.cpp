// Parameter studies in the window: run in a worker and shown side by side. A click loads the values of a run into the
// document.
#include <gtest/gtest.h>

#include "scenario_lines.h"

namespace taxel::test {
namespace {

Lines entered(const std::string& field, const std::string& text) {
  return {press("Study/" + field), kIdle, key("a", kCtrl), type(text), key("Enter"), kIdle};
}

const Lines kStudyPanel{kIdle, key("Space"), press("Panels"), kIdle, press("Study"), kIdle};

TEST(StudyPanel, ShowsRunsAndLoadsOneByAClick) {
  const StudioProgram studio;
  studio.play(
      joined({kStudyPanel,
              entered("Vary from", "0.5"),
              entered("Vary to", "1 mm"),
              entered("Vary values", "2"),
              {press("Study/Run study"), kIdle, kIdle, dump("run.json"), R"({"do": "screenshot", "file": "study.png"})",
               press("Study/Run 1"), kIdle, key("Space"), kIdle, dump("loaded.json")}}),
      coarse_fingertip(studio, "1500x2600"));
  const Json run = studio.state("run.json")["study"];
  ASSERT_EQ(run["runs"].size(), 2U);
  EXPECT_EQ(run["problem"], "");
  EXPECT_EQ(run["runs"][0]["values"], Json({0.0005}));
  EXPECT_EQ(run["runs"][1]["rows"], 241);
  EXPECT_GT(run["runs"][1]["largest"].get<double>(), run["runs"][0]["largest"].get<double>());
  const Json loaded = studio.state("loaded.json")["scenario"];
  EXPECT_EQ(loaded["edited"]["depth"], 0.001);
  EXPECT_EQ(loaded["running"], loaded["edited"]);
}

/// Returns lines that press a button of the panel, type a path into the dialog and press Enter.
Lines with_path(const std::string& button, const std::string& path) {
  return {press("Study/" + button), kIdle, type(path), key("Enter"), kIdle, kIdle, kIdle};
}

TEST(StudyPanel, WritesItsRunsAsABatchAndOpensThem) {
  const StudioProgram studio;
  studio.play(joined({kStudyPanel,
                      entered("Vary from", "0.5"),
                      entered("Vary to", "1 mm"),
                      entered("Vary values", "2"),
                      {press("Study/Save as batch..."), kIdle, dump("disabled.json"), press("Study/Run study"), kIdle,
                       kIdle, dump("run.json")},
                      with_path("Save as batch...", "written"),
                      {dump("saved.json")},
                      with_path("Save as batch...", (studio.folder() / "written").string()),
                      {dump("twice.json")},
                      with_path("Open study...", "written/batch.json"),
                      {dump("opened.json"), R"({"do": "screenshot", "file": "opened.png"})"},
                      with_path("Open study...", "coarse.taxels.json"),
                      {dump("no_batch.json")}}),
              coarse_fingertip(studio, "1500x2600"));
  const auto messages = [&](const std::string& file) { return studio.state(file)["messages"].dump(); };
  EXPECT_EQ(studio.state("disabled.json")["widgets"].dump().find("\"Folder\""), std::string::npos)
      << "no study was run";
  EXPECT_NE(messages("saved.json").find("Wrote 2 runs as a batch"), std::string::npos);
  EXPECT_NE(messages("twice.json").find("of this study already"), std::string::npos);
  const Json run = studio.state("run.json")["study"], opened = studio.state("opened.json")["study"];
  ASSERT_EQ(run["runs"].size(), 2U);
  EXPECT_EQ(opened["runs"], run["runs"]) << "values, rows and the largest readings";
  EXPECT_EQ(opened["problem"], "");
  EXPECT_NE(messages("no_batch.json").find("is no batch"), std::string::npos);
  EXPECT_EQ(studio.state("no_batch.json")["study"]["runs"], run["runs"]) << "the runs stay";
}

/// A folder with a study of two runs.
class WrittenStudy : public testing::Test {
 protected:
  void SetUp() override {
    studio_.play(joined({kStudyPanel,
                         entered("Vary from", "0.5"),
                         entered("Vary to", "1 mm"),
                         entered("Vary values", "2"),
                         {press("Study/Run study"), kIdle, kIdle},
                         with_path("Save as batch...", "written"),
                         {dump("written.json")}}),
                 coarse_fingertip(studio_, "1500x2600"));
    runs_ = studio_.state("written.json")["study"]["runs"];
    ASSERT_EQ(runs_.size(), 2U);
  }
  [[nodiscard]] std::string drop_folder() const {
    return R"({"event": "drop", "files": [")" + (studio_.folder() / "written").string() + R"("]})";
  }

  StudioProgram studio_;
  Json runs_;
};

TEST_F(WrittenStudy, OpensWithoutADocument) {
  for (const char* file : {"written", "written/batch.json"}) {
    studio_.play({kIdle, kIdle, kIdle, dump("alone.json")}, {file});
    const Json alone = studio_.state("alone.json");
    EXPECT_EQ(alone["study"]["runs"], runs_);
    EXPECT_NE(alone["widgets"].dump().find("\"Run 1\""), std::string::npos) << "the runs are drawn";
    EXPECT_EQ(alone["messages"], Json::array());
  }
}

TEST_F(WrittenStudy, OpensNextToAnEditedLayoutIfDropped) {
  studio_.play({kIdle, kLayoutMode, kIdle, key("a"), key("Delete"), kIdle, drop_folder(), kIdle, kIdle, kIdle,
                dump("dropped.json")},
               {kLayoutFile});
  const Json dropped = studio_.state("dropped.json");
  EXPECT_EQ(dropped["study"]["runs"], runs_);
  EXPECT_EQ(dropped["document"]["file"], kLayoutFile) << "the document stays";
  EXPECT_EQ(dropped["widgets"].dump().find("Discard"), std::string::npos) << "no question about unsaved edits";
}

TEST_F(WrittenStudy, SaysWhereItIsIfNothingCanBeSimulated) {
  studio_.play({kIdle, drop_folder(), kIdle, kIdle, kIdle, dump("mesh.json")}, {kMeshFile});
  const Json mesh = studio_.state("mesh.json");
  EXPECT_EQ(mesh["study"]["runs"], runs_);
  EXPECT_NE(mesh["messages"].dump().find("are in the panel Study of ANALYSE"), std::string::npos) << mesh["messages"];
}

TEST_F(WrittenStudy, IsRefusedWithTheRemedyIfItIsNotFinished) {
  std::filesystem::remove(studio_.folder() / "written/batch.json");
  const Outcome outcome = studio_.run({kIdle, kIdle, kIdle}, {"written"});
  EXPECT_NE(outcome.status, 0);
  EXPECT_NE(outcome.err.find("the batch is not finished"), std::string::npos) << outcome.err;
}

TEST_F(WrittenStudy, IsRefusedIfItsFileIsDamaged) {
  write_text(studio_.folder() / "written/batch.json", "{");
  const Outcome outcome = studio_.run({kIdle, kIdle, kIdle}, {"written"});
  EXPECT_NE(outcome.status, 0);
  EXPECT_NE(outcome.err.find("batch.json"), std::string::npos) << outcome.err;
}

TEST(StudyPanel, RefusesAFolderThatIsNoBatch) {
  const StudioProgram studio;
  std::filesystem::create_directories(studio.folder() / "empty");
  const Outcome outcome = studio.run({kIdle, kIdle}, {"empty"});
  EXPECT_NE(outcome.status, 0);
  EXPECT_NE(outcome.err.find("or batch (batch.json)"), std::string::npos) << outcome.err;
}

/// The simulation and the worker run in real time, so the script waits for each reported result.
TEST(StudyPanel, LeavesNothingHalfDoneIfCancelled) {
  const StudioProgram studio;
  const auto study = [](const std::string& key, const std::string& equals) {
    return R"({"do": "wait_for", "pointer": "/study/)" + key + R"(", "equals": )" + equals + "}";
  };
  const Lines run{press("Study/Run study"), study("busy", "true")}, done{study("busy", "false")};
  const Lines cancel{press("Study/Cancel study"), study("busy", "false"), kIdle};
  std::vector<std::string> arguments = coarse_fingertip(studio, "1500x2600");
  arguments.insert(arguments.begin(), "--live");
  studio.play(joined({kStudyPanel,
                      entered("Vary values", "90"),
                      run,
                      cancel,
                      {dump("cancelled.json"), R"({"do": "screenshot", "file": "cancelled.png"})"},
                      entered("Vary values", "1"),
                      run,
                      done,
                      {kIdle, dump("again.json")},
                      entered("Vary values", "90"),
                      run,
                      cancel,
                      {dump("kept.json")}}),
              arguments);
  const Json cancelled = studio.state("cancelled.json"), again = studio.state("again.json"),
             kept = studio.state("kept.json");
  EXPECT_TRUE(cancelled["study"]["cancelled"].get<bool>());
  EXPECT_TRUE(cancelled["study"]["runs"].empty()) << "none of its runs";
  EXPECT_EQ(again["study"]["runs"].size(), 1U);
  EXPECT_FALSE(again["study"]["cancelled"].get<bool>());
  EXPECT_GT(again["study"]["runs"][0]["largest"].get<double>(), 0);
  EXPECT_TRUE(kept["study"]["cancelled"].get<bool>());
  EXPECT_EQ(kept["study"]["runs"], again["study"]["runs"]) << "those of the one before stay";
  for (const Json& state : {cancelled, again, kept}) {
    EXPECT_EQ(state["scenario"], cancelled["scenario"]) << "the document stays";
    for (const Json& message : state["messages"]) EXPECT_NE(message["severity"], "error") << message.dump();
  }
}

}  // namespace
}  // namespace taxel::test
