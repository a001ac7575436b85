// The presentation: the view alone, by one key, and the window as it was before after it.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>

#include "script_lines.h"

namespace taxel::test {
namespace {

/// Returns lines that press a key that ends the presentation, and wait until the panels are back.
Lines left_by(const std::string& name) {
  return {key(name), kIdle, kIdle, kIdle, kIdle, kIdle};
}

const Lines kPaused{kIdle, wait_time(0.7), key("Space"), kIdle, kIdle};

/// Returns the labels of all widgets, with their boxes but for tabs, which scroll in a narrow column.
std::set<std::string> widgets_of(const Json& state) {
  std::set<std::string> widgets;
  for (const Json& w : state["widgets"]) {
    const std::string label = w["label"];
    widgets.insert(w["panel"].get<std::string>() + "/" + label + (label.ends_with(" tab") ? "" : w["rect"].dump()));
  }
  return widgets;
}

std::set<std::string> panels_of(const Json& state) {
  std::set<std::string> panels;
  for (const Json& widget : state["widgets"]) panels.insert(widget["panel"].get<std::string>());
  return panels;
}

void expect_same_window(const Json& a, const Json& b) {
  EXPECT_EQ(widgets_of(a), widgets_of(b));
  for (const char* part : {"window", "view", "overlays", "reading_range", "range", "camera", "mode", "selection"})
    EXPECT_EQ(a[part], b[part]) << part;
}

class Presentation : public testing::TestWithParam<const char*> {};

TEST_P(Presentation, ShowsTheViewAloneAndRestoresTheWindow) {
  const StudioProgram studio;
  studio.play(joined({kPaused,
                      {dump("before.json"), key("F9"), kIdle, kIdle, dump("presented.json"),
                       R"({"do": "screenshot", "file": "presented.png"})"},
                      left_by("Esc"),
                      {dump("esc.json"), key("F9"), kIdle, kIdle},
                      left_by("F9"),
                      {dump("key.json")}}),
              {"--size", GetParam(), kLayoutFile});
  const Json before = studio.state("before.json"), presented = studio.state("presented.json");
  const Json &view = presented["view"]["rect"], &bars = presented["presentation"]["bars"],
             &caption = presented["presentation"]["caption"];
  EXPECT_GT(presented["window"]["view_share"], 0.98);
  for (const std::string& panel : panels_of(presented))
    EXPECT_TRUE((std::set<std::string>{"", "View", "Legend", "Pressure legend", "Presentation", "Presented readings"})
                    .contains(panel))
        << panel;
  EXPECT_EQ(presented["marks"]["discs"], 0) << "the colours of the readings have another range";
  EXPECT_EQ(presented["bars"].size(), 12U);
  for (const Json& bar : presented["bars"]) {
    EXPECT_GE(bar["rect"][0], bars[0]);
    EXPECT_LE(bar["rect"][2], bars[2]);
  }
  EXPECT_LE(bars[3], view[3]);
  EXPECT_LE(caption[3], bars[1]);
  EXPECT_LE(caption[2], view[2]);
  EXPECT_GT(caption[3].get<double>() - caption[1].get<double>(), 0.04 * view[3].get<double>()) << "large type";
  expect_same_window(before, studio.state("esc.json"));
  expect_same_window(before, studio.state("key.json"));
}

INSTANTIATE_TEST_SUITE_P(Sizes, Presentation, testing::Values("800x600", "1280x800", "1920x1080"));

/// Runs until the finger touches the box, and pauses.
const Lines kOnTheBox{kIdle, wait_time(1.3), key("Space"), kIdle, kIdle};

TEST(PresentationOfAContact, LooksAtTheContactAndReturns) {
  const StudioProgram studio;
  studio.play(joined({kOnTheBox,
                      {dump("before.json"), key("F9"), kIdle, kIdle, kIdle, dump("presented.json")},
                      left_by("Esc"),
                      {dump("after.json")}}),
              sparse_fingertip(studio));
  const Json before = studio.state("before.json"), presented = studio.state("presented.json");
  const auto part = [](const Json& state) { return state["contact"]["part_of_view"].get<double>(); };
  EXPECT_GT(part(presented), 2 * part(before)) << "nearer than the camera that follows the contact of a run";
  EXPECT_NE(presented["camera"]["target"], before["camera"]["target"]);
  EXPECT_EQ(studio.state("after.json")["camera"], before["camera"]);
}

TEST(PresentationOfAContact, LeavesACameraThatTheUserHasMoved) {
  const StudioProgram studio;
  studio.play(joined({kOnTheBox,
                      {key("1", R"("alt")"), kIdle, kIdle, dump("moved.json"), key("F9"), kIdle, kIdle, kIdle,
                       dump("presented.json")}}),
              sparse_fingertip(studio));
  EXPECT_EQ(studio.state("presented.json")["camera"], studio.state("moved.json")["camera"]);
}

TEST(PresentationOfAContact, KeepsACameraThatIsMovedMeanwhile) {
  const StudioProgram studio;
  studio.play(joined({kOnTheBox,
                      {key("F9"), kIdle, kIdle, key("1", R"("alt")"), kIdle, kIdle, dump("presented.json")},
                      left_by("Esc"),
                      {dump("after.json")}}),
              sparse_fingertip(studio));
  EXPECT_EQ(studio.state("after.json")["camera"], studio.state("presented.json")["camera"]);
}

/// Returns the number of pixels in strong colours in the square of `side` pixels at the lower left corner.
int strong_pixels(const Picture& picture, int side) {
  int strong = 0;
  for (int y = picture.height - side; y < picture.height; ++y)
    for (int x = 0; x < side; ++x) {
      const std::array<int, 3> c = picture.pixel(x, y);
      strong += std::max({c[0], c[1], c[2]}) - std::min({c[0], c[1], c[2]}) > 100 ? 1 : 0;
    }
  return strong;
}

// The gizmo is in the lower left corner of the view. A click on it looks along an axis.
TEST(PresentationOfALayout, HasNoGizmo) {
  const StudioProgram studio;
  studio.play(
      {kIdle, kLayoutMode, kIdle, key("F9"), kIdle, kIdle, kIdle, R"({"do": "screenshot", "file": "presented.png"})",
       dump("presented.json"), R"({"event": "mouse_move", "at": [70, 730]})", kIdle, click("[70, 730]"), kIdle, kIdle,
       dump("clicked.json")},
      sparse_fingertip(studio, 5e5, "1280x800"));
  EXPECT_EQ(strong_pixels(studio.picture("presented.png"), 140), 0);
  EXPECT_EQ(studio.state("clicked.json")["camera"], studio.state("presented.json")["camera"]);
}

TEST(PresentationOfAScene, IsNamedInWords) {
  const StudioProgram studio;
  studio.play({kIdle, key("Space"), kIdle, key("F9"), kIdle, kIdle, dump("presented.json")},
              {TAXEL_SOURCE_DIR "/assets/scenes/hand_grasps_ball.xml"});
  const Json presented = studio.state("presented.json");
  std::string caption;
  for (const Json& widget : presented["widgets"])
    if (widget["panel"] == "Presentation") caption = widget["label"];
  EXPECT_TRUE(caption.starts_with("hand grasps ball   ")) << caption;
}

TEST(PresentationOfTheDemo, GoesOnAndEndsByAPanel) {
  const StudioProgram studio;
  studio.play({kIdle, wait_time(0.6), key("F9"), kIdle, wait_time(0.7), dump("demo.json"), key("2", kCtrl), key("F4"),
               kIdle, kIdle, dump("panel.json")},
              {"--demo"});
  const Json demo = studio.state("demo.json"), panel = studio.state("panel.json");
  EXPECT_TRUE(demo["presentation"]["on"]);
  EXPECT_TRUE(demo["simulation"]["history"]["demo"]["runs"]);
  EXPECT_FALSE(panels_of(demo).contains("Demo")) << "its caption is left out";
  EXPECT_FALSE(panel["presentation"]["on"]);
}

TEST(PresentationOfALayout, HasBarsWithAProbeOnly) {
  const StudioProgram studio;
  studio.play({kIdle, kLayoutMode, kIdle, key("F9"), kIdle, kIdle, dump("layout.json"), key("x"), kIdle, kIdle,
               R"({"event": "mouse_move", "at": {"taxel": 3}})", kIdle, kIdle, dump("probe.json")},
              {kLayoutFile});
  const Json layout = studio.state("layout.json"), probe = studio.state("probe.json");
  EXPECT_TRUE(layout["presentation"]["on"]);
  EXPECT_TRUE(layout["bars"].empty()) << "there are no readings";
  EXPECT_EQ(probe["bars"].size(), 12U) << "of the probe";
}

}  // namespace
}  // namespace taxel::test
