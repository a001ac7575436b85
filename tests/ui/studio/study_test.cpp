// Parameter studies in the window: run in a worker and shown side by side. A click loads the values of a run into the
// document.
#include <gtest/gtest.h>

#include "scenario_lines.h"

namespace taxel::test {
namespace {

Lines entered(const std::string& field, const std::string& text) {
  return {press("Study/" + field), kIdle, key("a", kCtrl), type(text), key("Enter"), kIdle};
}

const Lines kStudyPanel{kIdle, key("Space"), press("Panels"), kIdle, press("Study panel"), kIdle};

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

TEST(StudyPanel, WritesItsRunsAsADataSetAndOpensThem) {
  const StudioProgram studio;
  studio.play(joined({kStudyPanel,
                      entered("Vary from", "0.5"),
                      entered("Vary to", "1 mm"),
                      entered("Vary values", "2"),
                      {press("Study/Save as data set..."), kIdle, dump("disabled.json"), press("Study/Run study"),
                       kIdle, kIdle, dump("run.json")},
                      with_path("Save as data set...", "written"),
                      {dump("saved.json")},
                      with_path("Save as data set...", (studio.folder() / "written").string()),
                      {dump("twice.json")},
                      with_path("Open data set...", "written/meta/info.json"),
                      {dump("opened.json"), R"({"do": "screenshot", "file": "opened.png"})"},
                      with_path("Open data set...", "coarse.taxels.json"),
                      {dump("no_set.json")}}),
              coarse_fingertip(studio, "1500x2600"));
  const auto messages = [&](const std::string& file) { return studio.state(file)["messages"].dump(); };
  EXPECT_EQ(studio.state("disabled.json")["widgets"].dump().find("\"Folder\""), std::string::npos)
      << "no study was run";
  EXPECT_NE(messages("saved.json").find("Wrote 2 runs as a data set"), std::string::npos);
  EXPECT_NE(messages("twice.json").find("has the data set of this study already"), std::string::npos);
  const Json run = studio.state("run.json")["study"], opened = studio.state("opened.json")["study"];
  ASSERT_EQ(run["runs"].size(), 2U);
  EXPECT_EQ(opened["runs"], run["runs"]) << "values, rows and the largest readings";
  EXPECT_EQ(opened["problem"], "");
  EXPECT_NE(messages("no_set.json").find("is no data set"), std::string::npos);
  EXPECT_EQ(studio.state("no_set.json")["study"]["runs"], run["runs"]) << "the runs stay";
  const Json info = Json::parse(file_text(studio.folder() / "written/meta/taxel.json"));
  EXPECT_EQ(info["episodes"], 2);
  EXPECT_EQ(info["bits"], 64);
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
