// Targets of keys, and fast input: fields, menus, modifiers. Large text is nowhere cut off.
#include <gtest/gtest.h>

#include <algorithm>

#include "app/studio/shell/window/input_event.h"
#include "script_lines.h"

namespace taxel::test {
namespace {

using studio::InputEvent;
using studio::InputQueue;
using studio::KeyPress;
using studio::MouseWheel;

InputEvent ctrl(bool down) {
  return KeyPress{static_cast<ImGuiKey>(ImGuiMod_Ctrl), down};
}
InputEvent press_z(bool down) {
  return KeyPress{ImGuiKey_Z, down};
}

/// Returns the number of events in each frame.
std::vector<std::size_t> portions(const std::vector<InputEvent>& events) {
  InputQueue queue;
  queue.add(events);
  std::vector<std::size_t> sizes;
  while (!queue.empty()) sizes.push_back(queue.take().size());
  return sizes;
}

TEST(InputQueue, KeepsAModifierThroughTheFrameOfItsEvent) {
  const InputEvent wheel = MouseWheel{0, 1};
  using Sizes = std::vector<std::size_t>;
  EXPECT_EQ(portions({ctrl(true), wheel, ctrl(false)}), (Sizes{2, 1}));
  EXPECT_EQ(portions({ctrl(true), press_z(true), ctrl(false), press_z(false)}), (Sizes{2, 2}));
  EXPECT_EQ(portions({press_z(true), ctrl(true), wheel}), (Sizes{1, 2}));
  EXPECT_EQ(portions({ctrl(false), wheel, ctrl(false)}), (Sizes{3})) << "it was up already";
  EXPECT_EQ(portions({wheel, wheel, press_z(true), press_z(false)}), (Sizes{4}));
  EXPECT_EQ(portions({ctrl(true), wheel, ctrl(false), wheel, ctrl(true), wheel}), (Sizes{2, 2, 2}));
}

TEST(Keyboard, ResizesByCtrlWheelIfCtrlIsReleasedAtOnce) {
  const StudioProgram studio;
  studio.play(
      {kLayoutMode, kIdle, click(taxel(3)), kIdle, dump("before.json"),
       R"({"event": "wheel", "at": {"view": [0.471, 0.507]}, "y": 1, "mods": ["ctrl"]})", kIdle, dump("after.json")},
      {kLayoutFile});
  const Json before = studio.state("before.json"), after = studio.state("after.json");
  EXPECT_EQ(after["camera"], before["camera"]);
  EXPECT_NEAR(taxel_of(after["document"]["layout"], 3)["radius"].get<double>(),
              1.02 * taxel_of(before["document"]["layout"], 3)["radius"].get<double>(), 1e-15);
}

TEST(Keyboard, LeavesAFieldOrMenuByEscBeforeClearingTheSelection) {
  const StudioProgram studio;
  studio.play({kLayoutMode, kIdle, click(taxel(3)), kIdle, press("Inspector/Radius (mm)"), kIdle, type("9"), key("Esc"),
               kIdle, dump("field.json"), press("Edit"), kIdle, dump("menu.json"), key("Esc"), kIdle,
               dump("closed.json"), key("Esc"), kIdle, dump("cleared.json")},
              {kLayoutFile});
  const auto selected = [&](const char* file) { return studio.state(file)["selection"]["taxels"]; };
  EXPECT_EQ(selected("field.json"), Json({3}));
  EXPECT_NE(studio.state("menu.json")["widgets"].dump().find("Undo history"), std::string::npos);
  EXPECT_EQ(studio.state("closed.json")["widgets"].dump().find("Undo history"), std::string::npos);
  EXPECT_EQ(selected("closed.json"), Json({3}));
  EXPECT_EQ(selected("cleared.json"), Json::array());
  EXPECT_EQ(studio.state("cleared.json")["history"]["depth"], 0);
}

TEST(Keyboard, MovesFromFieldToFieldByTab) {
  const StudioProgram studio;
  studio.play({kLayoutMode,
               kIdle,
               click(taxel(3)),
               kIdle,
               press("Inspector/Centre (mm) X"),
               kIdle,
               type("1"),
               kIdle,
               key("Tab"),
               kIdle,
               type("-6.5"),
               kIdle,
               key("Tab"),
               kIdle,
               type("11"),
               kIdle,
               key("Tab", kShift),
               kIdle,
               type("-6.25"),
               kIdle,
               key("Enter"),
               kIdle,
               dump("typed.json")},
              {kLayoutFile});
  const Json typed = studio.state("typed.json");
  EXPECT_EQ(taxel_of(typed["document"]["layout"], 3)["center"], Json({1e-3, -6.25e-3, 11e-3}));
  EXPECT_EQ(typed["history"]["depth"], 4);
}

TEST(Keyboard, EntersTheInspectorByTabAndLeavesItByEsc) {
  const StudioProgram studio;
  studio.play({kLayoutMode,
               kIdle,
               click(taxel(3)),
               kIdle,
               key("Tab"),
               kIdle,
               dump("entered.json"),
               key("Tab"),
               kIdle,
               type("77"),
               kIdle,
               key("Enter"),
               kIdle,
               key("Esc"),
               kIdle,
               dump("left.json"),
               key("w"),
               kIdle,
               key("Esc"),
               kIdle,
               dump("cleared.json"),
               key("Tab", kShift),
               kIdle,
               dump("table.json")},
              {kLayoutFile});
  EXPECT_EQ(studio.state("table.json")["keyboard"], "Taxels");
  EXPECT_EQ(studio.state("entered.json")["keyboard"], "Inspector");
  EXPECT_EQ(studio.state("left.json")["keyboard"], "");
  EXPECT_EQ(studio.state("left.json")["selection"]["taxels"], Json({77})) << "the first field is the id's";
  EXPECT_EQ(studio.state("cleared.json")["selection"]["taxels"], Json::array());
  EXPECT_TRUE(studio.state("cleared.json")["overlays"]["wireframe"]);
}

TEST(Scale, NeitherOverlapsNorCutsOffTextAtScaleTwo) {
  const StudioProgram studio;
  std::filesystem::create_directories(studio.folder() / "state");
  write_text(studio.folder() / "state/settings.json", R"({"scale": 2.0})");
  studio.play({kIdle, key("Space"), kIdle, dump("simulate.json"), R"({"do": "screenshot", "file": "simulate.png"})",
               kLayoutMode, kIdle, click(taxel(3)), kIdle, dump("layout.json"),
               R"({"do": "screenshot", "file": "layout.png"})"},
              {"--state-dir", "state", kLayoutFile});
  for (const char* file : {"simulate.json", "layout.json"}) {
    std::vector<Json> bars;
    const Json state = studio.state(file);
    for (const Json& w : state["widgets"])
      if (w["panel"] == "Toolbar" || w["panel"] == "Status") bars.push_back(w);
    EXPECT_GT(bars.size(), 12U);
    const Json& view = state["view"]["rect"];
    for (const Json& a : bars) {
      const Json& r = a["rect"];
      EXPECT_GE(r[0].get<double>(), 0) << a;
      EXPECT_LE(r[2].get<double>(), 1280) << a;
      EXPECT_GT(r[3].get<double>() - r[1].get<double>(), 25) << "cut off: " << a;
      EXPECT_TRUE(r[3] <= view[1] || r[1] >= view[3]) << a;
      for (const Json& b : bars) {
        const Json& s = b["rect"];
        if (&a == &b) continue;
        EXPECT_TRUE(r[2] <= s[0] || s[2] <= r[0] || r[3] <= s[1] || s[3] <= r[1]) << a << " overlaps " << b;
      }
    }
    const auto last =
        std::find_if(bars.begin(), bars.end(), [](const Json& w) { return w["label"] == "Message counter"; });
    ASSERT_NE(last, bars.end());
  }
}

}  // namespace
}  // namespace taxel::test
