// Lists of a hand whose geoms have no names: filters, chosen rows in the view, a chosen body in the list, and the names
// of attached sensors.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <set>

#include "script_lines.h"

namespace taxel::test {
namespace {

/// A hand of ten bodies in a row, 60 mm apart. Only the bodies and joints have names; there are a class of drawn and
/// one of colliding geoms.
std::string hand_scene() {
  std::string scene = R"(<mujoco><option gravity='0 0 0'/><default>
    <default class='visual'><geom type='mesh' mesh='tip' contype='0' conaffinity='0'/></default>
    <default class='collision'><geom type='capsule' size='.004 .004' pos='0 0 .01'/></default></default>
    <asset><mesh name='tip' file='fingertip.obj'/></asset><worldbody>)";
  const char* const bodies[] = {"a_link", "b_link", "c_link", "d_link", "e_link",
                                "ff_tip", "mf_tip", "rf_tip", "lf_tip", "th_tip"};
  double x = -0.3;
  for (const char* body : bodies) {
    scene += std::string("<body name='") + body + "' pos='" + std::to_string(x) + " 0 0'><joint name='" +
             std::string(body).substr(0, 2) +
             "j3' axis='0 0 1'/><geom class='visual'/><geom class='collision'/></body>";
    x += 0.06;
  }
  return scene + "</worldbody></mujoco>";
}

std::vector<std::string> hand_in(const StudioProgram& studio, const char* size = "1500x2700") {
  std::filesystem::copy_file(kMeshFile, studio.folder() / "fingertip.obj");
  Json layout = Json::parse(file_text(kLayoutFile));
  layout["mesh"] = {{"file", "fingertip.obj"}, {"scale", {1, 1, 1}}};
  layout["sampling"]["density"] = 5e5;
  write_text(studio.folder() / "tip.taxels.json", layout.dump());
  write_text(studio.folder() / "scene.xml", hand_scene());
  std::vector<std::string> arguments = tall_window(studio, "scene.xml");
  *(std::ranges::find(arguments, "--size") + 1) = size;
  return arguments;
}

Lines typed_in(const std::string& field, const std::string& text) {
  return {press(field), kIdle, key("a", kCtrl), type(text), kIdle};
}

/// Returns the labels of the visible rows of geoms in a panel.
std::set<std::string> rows(const Json& state, const std::string& panel) {
  std::set<std::string> labels;
  for (const Json& widget : state["widgets"])
    if (widget["panel"] == panel && widget["label"].get<std::string>().find("_") == 2)
      labels.insert(widget["label"].get<std::string>());
  return labels;
}

int difference(const std::array<int, 3>& a, const std::array<int, 3>& b) {
  return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
}

/// Returns the number of pixels that differ around the middle of the 3-D view, apart from the texts at its edges.
int changed_pixels(const StudioProgram& studio, const Json& state, const std::string& a, const std::string& b) {
  const Picture before = studio.picture(a), after = studio.picture(b);
  const Json& view = state["view"]["rect"];
  int changed = 0;
  const int top = view[1].get<int>(), height = view[3].get<int>() - top;
  for (int y = top + 3 * height / 10; y < top + 7 * height / 10; ++y)
    for (int x = view[0].get<int>(); x < view[2].get<int>(); ++x)
      if (difference(before.pixel(x, y), after.pixel(x, y)) > 40) ++changed;
  return changed;
}

std::string screenshot_as(const std::string& file) {
  return R"({"do": "screenshot", "file": ")" + file + R"("})";
}

TEST(SceneNames, FilterByBodyMeshClassAndJointInBothLists) {
  const StudioProgram studio;
  const std::vector<std::string> arguments = hand_in(studio);
  studio.play(joined({{kIdle, key("Space"), kIdle},
                      typed_in("Filter the scene", "th_tip visual"),
                      {dump("body.json")},
                      typed_in("Filter the scene", "ffj3"),
                      {dump("joint.json")},
                      typed_in("Filter the outliner", "COLLISION lf"),
                      {dump("class.json")},
                      typed_in("Filter the outliner", "nothing"),
                      {dump("none.json")}}),
              arguments);
  EXPECT_EQ(rows(studio.state("body.json"), "Controls"), std::set<std::string>{"th_tip, visual"});
  EXPECT_EQ(rows(studio.state("joint.json"), "Controls"),
            (std::set<std::string>{"ff_tip, collision", "ff_tip, visual"}));
  EXPECT_EQ(rows(studio.state("class.json"), "Outliner"), std::set<std::string>{"lf_tip, collision"});
  EXPECT_EQ(rows(studio.state("class.json"), "Controls"), std::set<std::string>{"lf_tip, collision"});
  EXPECT_TRUE(rows(studio.state("none.json"), "Outliner").empty());
}

TEST(SceneNames, LightTheChosenRowAndScrollToTheChosenBody) {
  const StudioProgram studio;
  const std::vector<std::string> arguments = hand_in(studio, "1900x1200");  // so wide that all bodies are in view
  studio.play(joined({{kIdle, key("Space"), kIdle, screenshot_as("dark.png"), press("Controls/a_link, visual"), kIdle,
                       R"({"event": "mouse_move", "at": [3, 1197]})", kIdle, screenshot_as("lit.png"), dump("lit.json"),
                       press("Controls/a_link, visual"), kIdle, dump("off.json"),
                       R"({"event": "double_click", "at": {"world": [0.24, 0, 0.012]}})", kIdle, dump("view.json")}}),
              arguments);
  const Json lit = studio.state("lit.json"), view = studio.state("view.json");
  EXPECT_EQ(lit["scene"]["body"], "a_link");
  EXPECT_EQ(lit["scene"]["chosen"], Json({"a_link"}));
  EXPECT_GT(changed_pixels(studio, lit, "dark.png", "lit.png"), 100);
  EXPECT_TRUE(studio.state("off.json")["scene"]["body"].is_null());
  EXPECT_FALSE(rows(lit, "Controls").contains("th_tip, visual")) << "it is below the rows in sight";
  EXPECT_EQ(view["scene"]["body"], "th_tip");
  EXPECT_TRUE(rows(view, "Controls").contains("th_tip, visual"));
}

TEST(SceneNames, SelectABodyFromThePalette) {
  const StudioProgram studio;
  const std::vector<std::string> arguments = hand_in(studio);
  studio.play({kIdle, key("Space"), kIdle, key("k", kCtrl), kIdle, type("lfj3"), kIdle, dump("found.json"),
               key("Enter"), kIdle, dump("selected.json")},
              arguments);
  const Json found = studio.state("found.json");
  EXPECT_TRUE(std::ranges::any_of(found["widgets"], [](const Json& one) { return one["label"] == "Select lf_tip"; }));
  EXPECT_EQ(studio.state("selected.json")["scene"]["body"], "lf_tip");
}

TEST(SceneNames, CallAttachedSensorsAfterTheirBodies) {
  const StudioProgram studio;
  const std::vector<std::string> arguments = hand_in(studio);
  studio.play(
      joined({{kIdle, key("Space"), kIdle},
              typed_in("Filter the scene", "visual _tip"),
              {press("Controls/ff_tip, visual"), kIdle, press("Controls/th_tip, visual"), kIdle,
               press("Attach a layout to 2 geoms..."), kIdle, type((studio.folder() / "tip.taxels.json").string()),
               kIdle, key("Enter"), kIdle, kIdle, dump("attached.json"), press("Detach ff_tip"), kIdle, kIdle,
               press("Controls/Attach a layout"), kIdle, dump("detached.json")}}),
      arguments);
  const Json attached = studio.state("attached.json"), detached = studio.state("detached.json");
  ASSERT_EQ(attached["simulation"]["sensors"].size(), 2U) << attached["messages"].dump(1);
  EXPECT_EQ(attached["scene"]["attached"][0]["geom"], "ff_tip");
  EXPECT_EQ(attached["scene"]["attached"][1]["geom"], "th_tip");
  EXPECT_TRUE(rows(attached, "Controls").contains("th_tip"));
  EXPECT_NE(attached["messages"].dump().find("\\\"ff_tip, collision\\\" (100 % of its surface)"), std::string::npos)
      << attached["messages"].dump(1);
  ASSERT_EQ(detached["simulation"]["sensors"].size(), 1U);
  EXPECT_TRUE(rows(detached, "Controls").contains("ff_tip, visual"));
}

}  // namespace
}  // namespace taxel::test
