// The menus by keyboard, through the real executable.
#include <gtest/gtest.h>

#include "script_lines.h"

namespace taxel::test {
namespace {

/// The key's name on its own, without a modifier: the menus look at the key.
const std::string kAlt = key("LeftAlt");

Lines keys(const std::vector<std::string>& names) {
  Lines lines;
  for (const std::string& name : names) {
    lines.push_back(key(name));
    lines.push_back(kIdle);
  }
  return lines;
}

TEST(MenuKeys, CarryOutAnEntry) {
  const StudioProgram studio;
  studio.play(joined({{kLayoutMode, kIdle, dump("before.json"), kAlt, kIdle, dump("marked.json")},
                      keys({"e"}),
                      {dump("edit.json")},
                      keys({"Right", "Down", "Enter"}),
                      {dump("after.json"), kAlt, kIdle, key("F10"), kIdle, dump("left.json")}}),
              {kLayoutFile});
  EXPECT_EQ(studio.state("before.json")["mode"], "layout");
  EXPECT_EQ(studio.state("before.json")["menus"], Json({{"keyboard", false}, {"open", ""}}));
  EXPECT_EQ(studio.state("marked.json")["menus"], Json({{"keyboard", true}, {"open", ""}}));
  EXPECT_EQ(studio.state("edit.json")["menus"], Json({{"keyboard", true}, {"open", "Edit"}}));
  EXPECT_EQ(studio.state("after.json")["menus"], Json({{"keyboard", false}, {"open", ""}}));
  EXPECT_EQ(studio.state("after.json")["mode"], "simulate") << "Mode > SIMULATE is the second entry";
  EXPECT_EQ(studio.state("left.json")["menus"], Json({{"keyboard", false}, {"open", ""}}));
}

TEST(MenuKeys, LeaveTextAndSelectionAsTheyAre) {
  const StudioProgram studio;
  studio.play(
      joined({{kLayoutMode, kIdle, click(taxel(3)), kIdle, press("Inspector/Radius (mm)"), kIdle, type("1"), kAlt,
               key("F10"), type("."), kIdle, dump("typing.json"), type("25"), key("Enter"), kIdle, kAlt, kIdle},
              keys({"f", "Esc", "Esc"}),
              {dump("left.json")},
              keys({"Esc"}),
              {dump("cleared.json")}}),
      {kLayoutFile});
  EXPECT_EQ(studio.state("typing.json")["menus"], Json({{"keyboard", false}, {"open", ""}}));
  const Json left = studio.state("left.json");
  EXPECT_EQ(taxel_of(left["document"]["layout"], 3)["radius"], 1.25e-3);
  EXPECT_EQ(left["selection"]["taxels"], Json({3})) << "Esc left the menus and nothing else";
  EXPECT_EQ(studio.state("cleared.json")["selection"]["taxels"], Json::array());
}

TEST(MenuKeys, OpenADialogThatGetsTheKeyboard) {
  const StudioProgram studio;
  studio.play(joined({{kLayoutMode, kIdle, kAlt, kIdle}, keys({"f", "Down", "Enter"}), {dump("open.json")}}),
              {kLayoutFile});
  const Json state = studio.state("open.json");
  EXPECT_NE(state["widgets"].dump().find("\"Cancel\""), std::string::npos) << "the dialog to open a file";
  EXPECT_EQ(state["menus"]["keyboard"], false);
}

}  // namespace
}  // namespace taxel::test
