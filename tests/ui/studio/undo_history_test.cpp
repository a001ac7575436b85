// The list of undo steps: names, the present and the saved step, and clicks that go to a step.
#include <gtest/gtest.h>

#include "script_lines.h"

namespace taxel::test {
namespace {

const std::string kUndoKeys = R"("ctrl", "alt")";

/// Three edits of the layout: taxel 3 gets another radius, is duplicated by a move, and the copy is deleted.
const Lines kThreeEdits{kLayoutMode, kIdle,        click(taxel(3)), kIdle,    key("f"), type("3"),
                        kIdle,       key("Enter"), kIdle,           key("h"), kIdle,    key("h", R"("alt")"),
                        kIdle};

TEST(UndoHistory, GoesToTheClickedStep) {
  const StudioProgram studio;
  studio.play(
      joined({kThreeEdits,
              {dump("edited.json"), key("z", kUndoKeys), kIdle, dump("listed.json"), press("Undo history/Step 1"),
               kIdle, dump("first.json"), R"({"do": "screenshot", "file": "first.png"})", press("Undo history/Step 0"),
               kIdle, dump("opened.json"), press("Undo history/Step 3"), kIdle, dump("last.json")}}),
      {kLayoutFile});
  const Json edited = studio.state("edited.json"), first = studio.state("first.json");
  EXPECT_EQ(edited["history"]["steps"], Json({"", "Resize taxel 3", "Hide taxel 3", "Show all taxels"}));
  EXPECT_EQ(edited["history"]["depth"], 3);
  EXPECT_EQ(edited["history"]["saved_step"], 0);
  const auto lists = [&](const char* label) {
    const Json widgets = studio.state("listed.json")["widgets"];
    return std::any_of(widgets.begin(), widgets.end(),
                       [&](const Json& w) { return w["panel"] == "Undo history" && w["label"] == label; });
  };
  for (const char* label : {"Document as opened", "Resize taxel 3", "Hide taxel 3", "Show all taxels"})
    EXPECT_TRUE(lists(label)) << label;
  EXPECT_EQ(first["history"]["depth"], 1);
  EXPECT_EQ(first["history"]["redo_depth"], 2);
  EXPECT_EQ(first["document"]["layout"], edited["document"]["layout"]) << "hidden taxels are no part of the layout";
  const Json opened = studio.state("opened.json"), last = studio.state("last.json");
  EXPECT_EQ(opened["history"]["depth"], 0);
  EXPECT_FALSE(opened["history"]["dirty"]);
  EXPECT_EQ(taxel_of(opened["document"]["layout"], 3)["radius"], 0.006);
  EXPECT_EQ(last["history"]["depth"], 3);
  EXPECT_EQ(last["document"]["layout"], edited["document"]["layout"]);
}

TEST(UndoHistory, MarksTheSavedStepAndForgetsAClosedDocument) {
  const StudioProgram studio;
  const std::string file = (studio.folder() / "mine.taxelproj").string();
  studio.play(joined({kThreeEdits,
                      {key("z", kCtrl), kIdle, key("s", kCtrl), kIdle, type(file), kIdle, key("Enter"), kIdle,
                       dump("saved.json"), press("File"), kIdle, press("File/Close"), kIdle, key("z", kUndoKeys), kIdle,
                       dump("closed.json")}}),
              {kLayoutFile});
  EXPECT_EQ(studio.state("saved.json")["history"]["saved_step"], 2);
  EXPECT_EQ(studio.state("saved.json")["history"]["steps"].size(), 4U);
  EXPECT_EQ(studio.state("closed.json")["history"]["steps"], Json::array());
}

}  // namespace
}  // namespace taxel::test
