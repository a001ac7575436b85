// The status line and the help: the pace of the simulation, and keys found by typed text.
#include <gtest/gtest.h>

#include "app/studio/nouns/menus/menus_state.h"

namespace taxel::ui {
namespace {

/// A scene that runs at 0.976 times real time.
struct RunningShown {
  Shown shown;
  std::shared_ptr<SimFrame> frame = std::make_shared<SimFrame>();
  RunningShown() {
    frame->scene = std::make_shared<SimScene>();
    shown.run.frame = frame;
    shown.run.playing = true;
    shown.run.performance.simulation_speed = 0.976;
  }
};

TEST(PaceText, GivesTheSpeedInMultiplesOfRealTime) {
  EXPECT_EQ(pace_text(RunningShown().shown), "0.98 x real time");
}

TEST(PaceText, SaysWhyTheSimulationDoesNotRun) {
  RunningShown running;
  running.shown.run.playing = false;
  EXPECT_EQ(pace_text(running.shown), "paused");
  running.frame->finished = true;
  EXPECT_EQ(pace_text(running.shown), "ended");
  running.shown.document.polishing.holds_run = true;
  EXPECT_EQ(pace_text(running.shown), "starts when polished");
}

TEST(PaceText, IsEmptyWithoutAScene) {
  EXPECT_EQ(pace_text({}), "");
  RunningShown running;
  running.frame->scene = nullptr;
  EXPECT_EQ(pace_text(running.shown), "");
}

/// Returns the labels of the rows of the help that match a text.
std::vector<std::string> help_for(std::string_view typed) {
  std::vector<std::string> labels;
  for (const HelpRow& row : find_help(typed)) labels.emplace_back(row.label);
  return labels;
}

TEST(FindHelp, MatchesLabelsKeysContextsAndSynonyms) {
  EXPECT_EQ(help_for("undo"), (std::vector<std::string>{"Undo", "Undo history"}));
  EXPECT_EQ(help_for("ctrl+z").front(), "Undo");
  EXPECT_EQ(help_for("revert"), std::vector<std::string>{"Undo"}) << "a synonym";
  EXPECT_EQ(help_for("movie"), std::vector<std::string>{"Make a film around the contact"});
  EXPECT_EQ(help_for("ORBIT left"), std::vector<std::string>{"Orbit"}) << "words in any order and case";
  EXPECT_TRUE(help_for("rbit").empty()) << "words begin with the text";
  EXPECT_TRUE(help_for("nonsense").empty());
}

TEST(FindHelp, ListsEverythingWithoutAText) {
  const auto with_keys =
      std::count_if(bindings().begin(), bindings().end(), [](const Binding& b) { return b.chord != 0; });
  EXPECT_EQ(help_for("").size(), gestures().size() + static_cast<std::size_t>(with_keys));
  EXPECT_EQ(help_for("  "), help_for(""));
}

}  // namespace
}  // namespace taxel::ui
