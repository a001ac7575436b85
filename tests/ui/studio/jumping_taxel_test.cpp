// The example of the paper's artifact, as a user sees it: one command shows the largest step of the run, magnified and
// explained, and "Fix it" removes it.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "script_lines.h"

namespace taxel::test {
namespace {

const std::string kExactIsRead = R"({"do": "wait_for", "pointer": "/plot/close_up/exact/0", "least": 0})";
const std::string kRunIsMade = R"({"do": "wait_for", "pointer": "/runs_ahead", "equals": false})";
const Lines kShow{kIdle,
                  key("k", kCtrl),
                  kIdle,
                  type("jumping"),
                  kIdle,
                  key("Enter"),
                  kIdle,
                  R"({"do": "wait_for", "pointer": "/explain/verdict/cause", "contains": "sampling_noise"})",
                  kExactIsRead,
                  kIdle,
                  dump("jumped.json")};

Lines export_run(const StudioProgram& studio, const char* file) {
  return {key("e", kCtrlShift), kIdle, key("a", kCtrl), type((studio.folder() / file).string()), kIdle,
          key("Enter"),         kIdle};
}

/// The largest change of a reading between two rows of a table.
struct TableStep {
  double change = 0, time = 0;
  std::string column;
};

/// Returns the largest change in a table of readings by its definition.
TableStep largest_step(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::string line, cell;
  std::getline(in, line);
  std::vector<std::string> names;
  for (std::istringstream cells(line); std::getline(cells, cell, ',');) names.push_back(cell);
  TableStep largest;
  std::vector<double> before;
  while (std::getline(in, line)) {
    std::vector<double> row;
    for (std::istringstream cells(line); std::getline(cells, cell, ',');) row.push_back(std::stod(cell));
    for (std::size_t i = 0; i < row.size() && !before.empty(); ++i)
      if (names[i].starts_with("taxel_") && std::abs(row[i] - before[i]) > std::abs(largest.change))
        largest = {row[i] - before[i], row[0], names[i]};
    before = row;
  }
  return largest;
}

/// Returns whether a message with a text is in the list.
bool has_message(const Json& state, const std::string& text) {
  for (const Json& message : state["messages"])
    if (message["text"].get<std::string>().find(text) != std::string::npos) return true;
  return false;
}

TEST(JumpingTaxel, PausesAtTheLargestStepOfTheRecordedRun) {
  const StudioProgram studio;
  studio.play(joined({kShow, export_run(studio, "run.csv"), {R"({"do": "screenshot", "file": "jumped.png"})", kIdle}}));
  const Json jumped = studio.state("jumped.json");
  const TableStep largest = largest_step(studio.folder() / "run.csv");
  EXPECT_FALSE(jumped["simulation"]["playing"]);
  EXPECT_EQ(jumped["simulation"]["time"].get<double>(), largest.time);
  EXPECT_EQ("taxel_" + jumped["explain"]["taxel"]["id"].dump(), largest.column);
  EXPECT_EQ(jumped["explain"]["verdict"]["change"].get<double>(), largest.change);
  EXPECT_EQ(jumped["selection"]["taxel"], jumped["explain"]["taxel"]["id"]);
  EXPECT_TRUE(has_message(jumped, "The largest step of the run")) << jumped["messages"];

  const Json& close_up = jumped["plot"]["close_up"];
  EXPECT_EQ(close_up["taxel"], jumped["explain"]["taxel"]["id"]);
  EXPECT_EQ(close_up["step"], jumped["explain"]["step"]);
  EXPECT_GE(close_up["change_pixels"].get<double>(), 40);
  EXPECT_EQ(close_up["exact"].size(), close_up["readings"].size());
  const std::size_t middle = close_up["readings"].size() / 2;
  const auto change_at_jump = [&](const char* curve) {
    return std::abs(close_up[curve][middle].get<double>() - close_up[curve][middle - 1].get<double>());
  };
  EXPECT_LT(change_at_jump("exact"), 0.2 * change_at_jump("readings")) << "the contact itself hardly changes";
}

TEST(JumpingTaxel, SaysThatItSearches) {
  const StudioProgram studio;
  studio.play({kIdle, key("k", kCtrl), kIdle, type("jumping"), kIdle, key("Enter"),
               R"({"do": "wait_for", "pointer": "/runs_ahead", "equals": true})", dump("searching.json"),
               R"({"do": "wait_for", "pointer": "/runs_ahead", "equals": false})", dump("found.json")});
  EXPECT_EQ(studio.state("searching.json")["runs_ahead_hint"].get<std::string>().find("Searching for the largest step"),
            0U);
  EXPECT_EQ(studio.state("found.json")["runs_ahead_hint"], "");
}

TEST(JumpingTaxel, IsFixedAsTheSentenceSaysAtTheSameStep) {
  const StudioProgram studio;
  studio.play(joined(
      {kShow,
       {press("Fix it"), kIdle, kRunIsMade, R"({"do": "wait_for", "pointer": "/plot/close_up/before/0", "least": 0})",
        R"({"do": "wait_for", "pointer": "/explain/verdict/cause", "contains": "none"})", kExactIsRead, kIdle,
        dump("fixed.json"), R"({"do": "screenshot", "file": "fixed.png"})", press("Whole run"), kIdle,
        dump("whole.json"), key("z", kCtrl), kIdle, dump("undone.json")}}));
  const Json jumped = studio.state("jumped.json"), fixed = studio.state("fixed.json");
  const double sparse = jumped["document"]["layout"]["sampling"]["density"].get<double>();
  const double factor = jumped["explain"]["verdict"]["samples_needed"]["factor"].get<double>();
  EXPECT_EQ(factor, 4);
  EXPECT_NE(jumped["explain"]["verdict"]["text"].get<std::string>().find("4 times as many"), std::string::npos);
  EXPECT_EQ(fixed["document"]["layout"]["sampling"]["density"].get<double>(), factor * sparse);
  EXPECT_EQ(fixed["simulation"]["time"], jumped["simulation"]["time"]);
  EXPECT_EQ(fixed["simulation"]["history"]["last"], jumped["simulation"]["history"]["last"]) << "the whole run";
  EXPECT_FALSE(fixed["simulation"]["playing"]);
  // Curves are divided by the largest reading of the run that is shown, which the remedy has changed.
  const auto before = fixed["plot"]["close_up"]["before"].get<std::vector<double>>(),
             drawn = jumped["plot"]["close_up"]["readings"].get<std::vector<double>>();
  ASSERT_EQ(before.size(), drawn.size());
  for (std::size_t i = 0; i < before.size(); ++i)
    EXPECT_NEAR(before[i] * drawn[0], drawn[i] * before[0], 1e-9) << "the same readings at point " << i;
  EXPECT_NE(fixed["plot"]["close_up"]["readings"], jumped["plot"]["close_up"]["readings"]);
  EXPECT_FALSE(has_message(fixed, "The largest step of the run")) << "it is not true any more";
  EXPECT_TRUE(studio.state("whole.json")["plot"]["close_up"].is_null());
  EXPECT_TRUE(studio.state("whole.json")["plot"]["before"]) << "before and after, over the whole run";
  const Json undone = studio.state("undone.json");
  EXPECT_EQ(undone["document"]["layout"]["sampling"]["density"], sparse) << "one step of undo";
  EXPECT_FALSE(undone["plot"]["before"]) << "the layout is the one before the remedy again";
}

TEST(JumpingTaxel, IsForgottenWithItsDocument) {
  const StudioProgram studio;
  studio.play(joined({kShow,
                      {R"({"event": "drop", "files": [")" + kLayoutFile + R"("]})", kIdle,
                       R"({"do": "wait_time", "time": 0.2})", key("Space"), kIdle, dump("other.json")}}));
  const Json other = studio.state("other.json");
  EXPECT_TRUE(other["explain"].is_null());
  EXPECT_TRUE(other["plot"]["close_up"].is_null());
  EXPECT_EQ(other["scenario"]["running"]["speed"], 0.01) << "the fast sweep was the example's own";
}

}  // namespace
}  // namespace taxel::test
