// The comparison of a run with a second layout through the program: the second layout's readings are those of its own
// run, and nothing outdated is shown.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <fstream>
#include <future>
#include <sstream>

#include "csv_row.h"
#include "script_lines.h"

namespace taxel::test {
namespace {

/// Writes the fingertip with every second taxel and a larger radius. Returns its path.
std::string second_layout(const StudioProgram& studio, double factor = 1.25, const std::string& mesh = kMeshFile) {
  Json layout = Json::parse(file_text(kLayoutFile));
  layout["mesh"] = {{"file", mesh}, {"scale", {1, 1, 1}}};
  layout["sampling"]["density"] = 4e5;
  Json taxels = Json::array();
  for (std::size_t k = 0; k < layout["taxels"].size(); k += 2) {
    taxels.push_back(layout["taxels"][k]);
    taxels.back()["radius"] = factor * taxels.back()["radius"].get<double>();
  }
  layout["taxels"] = taxels;
  const std::filesystem::path file = studio.folder() / "second.taxels.json";
  write_text(studio.folder() / "part", layout.dump());
  std::filesystem::rename(studio.folder() / "part", file);
  return file.string();
}

Lines compared_with(const std::string& file) {
  return {press("Simulation"),
          kIdle,
          press("Compare with a layout..."),
          kIdle,
          key("a", kCtrl),
          type(file),
          kIdle,
          key("Enter"),
          kIdle,
          kIdle};
}

const Lines kComparedPaper{press("Simulation"), kIdle, press("Compare with the paper's released model"), kIdle, kIdle};
const Lines kRunAndPause{key("="), key("="), R"({"do": "wait_time", "time": 1.3})", key("Space"), kIdle};

double largest_of(const Json& values) {
  double largest = 0;
  for (const Json& value : values) largest = std::max(largest, value.get<double>());
  return largest;
}

TEST(Compare, ReadsTheSecondLayoutLikeItsOwnRun) {
  const StudioProgram studio;
  const std::vector<std::string> first = sparse_fingertip(studio);
  const std::string second = second_layout(studio);
  studio.play(
      joined({kRunAndPause,
              compared_with(second),
              {dump("compared.json"), R"({"do": "screenshot", "file": "compared.png"})", press("Compare/Export..."),
               kIdle, key("a", kCtrl), type((studio.folder() / "both.csv").string()), kIdle, key("Enter"), kIdle,
               dump("exported.json")}}),
      first);
  const Json state = studio.state("compared.json"), &compare = state["compare"];
  ASSERT_TRUE(compare.is_object());
  EXPECT_EQ(compare["problem"], "");
  ASSERT_TRUE(compare["is_displayed"]) << compare.dump();
  EXPECT_TRUE(compare["reads_recorded"]);
  EXPECT_TRUE(compare["equal_contact"]);
  EXPECT_EQ(compare["step"], state["simulation"]["step"]);
  EXPECT_EQ(compare["read"], compare["due"]) << "all rows are read";
  EXPECT_GT(compare["rows"], 50);
  EXPECT_EQ(compare["sides"][0]["readings"], state["simulation"]["readings"]);
  ASSERT_EQ(compare["sides"][1]["readings"].size(), 6U);
  EXPECT_GT(largest_of(compare["sides"][1]["readings"]), 0);
  EXPECT_EQ(compare["bars"].size(), 18U) << "twelve bars of A and six of B";
  EXPECT_EQ(compare["rings"], 6) << "the fields of B are drawn in the view";
  for (const Json& side : compare["sides"]) {
    EXPECT_GT(side["responding"], 0);
    EXPECT_GT(side["peak"]["value"], side["jump"]["value"]);
    EXPECT_GE(side["curves"].size(), side["responding"]);
  }
  EXPECT_EQ(compare["sides"][0]["curves"][0]["dashed"], false);
  EXPECT_EQ(compare["sides"][1]["curves"][0]["dashed"], true);
  const std::string said = studio.state("exported.json")["messages"].dump();
  EXPECT_NE(said.find("B is second.taxels.json"), std::string::npos) << said;
  std::map<std::string, double> written = csv_row(studio.folder() / "both.csv", 1.2);
  EXPECT_EQ(written.size(), 2U + 12 + 6);
#ifdef TAXEL_PROGRAM
  // The taxels do not change the motion, so that a run of the second layout has the same contact in every step.
  const Outcome swept = run_program(TAXEL_PROGRAM,
                                    {"sweep", "--layout", "second.taxels.json", "--object", "box", "--past", "0.002",
                                     "--record-every", "0.00001", "--out", "run", "--quiet"},
                                    studio.folder());
  ASSERT_EQ(swept.status, 0) << swept.err;
  std::map<std::string, double> own = csv_row(studio.folder() / "run/readings.csv", written["time"]);
  ASSERT_NEAR(own["time"], written["time"], 1e-9);
  int above_zero = 0;
  for (const auto& [name, value] : own) {
    if (!name.starts_with("taxel_")) continue;
    EXPECT_NEAR(written["B/" + name], value, 1e-9 * std::abs(value)) << name;
    above_zero += value > 0;
  }
  EXPECT_GT(above_zero, 0);
#endif
}

TEST(Compare, ReadsTheReleasedModelWithItsOwnFieldOrOnTheContactOfTheRun) {
  const StudioProgram studio;
  studio.play(joined({kRunAndPause,
                      kComparedPaper,
                      {dump("own.json"), press("A's contact"), kIdle, kIdle, dump("recorded.json"),
                       press("Close comparison"), kIdle, dump("closed.json")}}),
              sparse_fingertip(studio));
  const Json own = studio.state("own.json")["compare"], recorded = studio.state("recorded.json")["compare"];
  ASSERT_TRUE(own["is_displayed"]) << own.dump();
  EXPECT_TRUE(own["paper"]);
  EXPECT_FALSE(own["reads_recorded"]);
  EXPECT_EQ(own["sides"][1]["field"], "star");
  EXPECT_EQ(own["sides"][1]["density"], 1e6);
  EXPECT_EQ(own["sides"][1]["readings"].size(), 12U);
  EXPECT_EQ(own["rings"], 0) << "the fields are those of A";
  EXPECT_NE(own["held"].get<std::string>().find("Not equal: the pressure field"), std::string::npos) << own["held"];
  ASSERT_TRUE(recorded["is_displayed"]) << recorded.dump();
  EXPECT_TRUE(recorded["reads_recorded"]);
  EXPECT_EQ(recorded["sides"][1]["field"], "pad") << "of A";
  EXPECT_EQ(recorded["sides"][0]["readings"], own["sides"][0]["readings"]);
  EXPECT_NE(recorded["sides"][1]["readings"], own["sides"][1]["readings"]);
  EXPECT_GT(largest_of(recorded["sides"][1]["readings"]), 0);
  EXPECT_EQ(studio.state("closed.json")["compare"], nullptr);
}

TEST(Compare, FollowsScrubbingAndARunThatContinuesFromAnEarlierStep) {
  const StudioProgram studio;
  const Lines back{key("Left"), key("Left"), kIdle, dump("back.json")};
  const Lines on{
      key("Space"),   R"({"do": "wait_time", "time": 1.35})", dump("running.json"), key("Space"), kIdle, kIdle,
      dump("on.json")};
  const Lines again{key("Backspace"), kIdle, key("Space"), R"({"do": "wait_time", "time": 1.0})",
                    key("Space"),     kIdle, kIdle,        dump("again.json")};
  studio.play(joined({kRunAndPause, kComparedPaper, back, on, again}), sparse_fingertip(studio));
  for (const char* file : {"back.json", "on.json", "again.json"}) {
    const Json state = studio.state(file), &compare = state["compare"];
    ASSERT_TRUE(compare["is_displayed"]) << file;
    EXPECT_EQ(compare["step"], state["simulation"]["step"]) << file;
    EXPECT_EQ(compare["sides"][0]["readings"], state["simulation"]["readings"]) << file;
    EXPECT_EQ(compare["read"], compare["due"]) << file;
    EXPECT_EQ(compare["rows"], compare["due"]) << file << ": each row of the run once";
  }
  EXPECT_GT(studio.state("running.json")["compare"]["rows"], 50) << "rows are read while the run goes on";
  EXPECT_LT(studio.state("again.json")["compare"]["rows"], studio.state("on.json")["compare"]["rows"]);
}

TEST(Compare, RefusesALayoutForAnotherMeshAndAMissingFile) {
  const StudioProgram studio;
  const std::vector<std::string> first = sparse_fingertip(studio);
  const std::string other = second_layout(studio, 1, TAXEL_SOURCE_DIR "/assets/meshes/hand_middle.obj");
  studio.play(joined({kRunAndPause,
                      compared_with(other),
                      {dump("other.json")},
                      compared_with((studio.folder() / "gone.taxels.json").string()),
                      {dump("gone.json")}}),
              first);
  for (const char* file : {"other.json", "gone.json"}) {
    const Json compare = studio.state(file)["compare"];
    EXPECT_FALSE(compare["is_displayed"]) << file;
    EXPECT_EQ(compare["rings"], 0) << file;
  }
  const std::string other_problem = studio.state("other.json")["compare"]["problem"],
                    gone_problem = studio.state("gone.json")["compare"]["problem"];
  EXPECT_NE(other_problem.find("is another mesh than that of the run"), std::string::npos) << other_problem;
  EXPECT_NE(gone_problem.find("gone.taxels.json"), std::string::npos) << gone_problem;
}

TEST(Compare, ReadsAChangedFileAgainAndEndsWithTheDocument) {
  using namespace std::chrono_literals;
  const StudioProgram studio;
  const std::vector<std::string> first = sparse_fingertip(studio);
  const std::string second = second_layout(studio);
  const Lines lines =
      joined({kRunAndPause,
              compared_with(second),
              {dump("before.json"),
               R"({"do": "wait_for", "pointer": "/messages", "contains": "the comparison reads it again"})", kIdle,
               kIdle, dump("after.json"), press("Help"), kIdle, press("Examples"), kIdle, press("Fingertip sweep"),
               kIdle, kIdle, dump("other.json")}});
  auto played = std::async(std::launch::async, [&] { return studio.run(lines, first); });
  while (!std::filesystem::exists(studio.folder() / "before.json") &&
         played.wait_for(20ms) != std::future_status::ready)
    continue;
  second_layout(studio, 1.6);
  const Outcome outcome = played.get();
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Json before = studio.state("before.json")["compare"], after = studio.state("after.json")["compare"];
  ASSERT_TRUE(after["is_displayed"]);
  EXPECT_GT(after["number"], before["number"]);
  EXPECT_NE(after["sides"][1]["readings"], before["sides"][1]["readings"]);
  EXPECT_EQ(after["sides"][0]["readings"], before["sides"][0]["readings"]);
  EXPECT_EQ(studio.state("other.json")["compare"], nullptr);
}

}  // namespace
}  // namespace taxel::test
