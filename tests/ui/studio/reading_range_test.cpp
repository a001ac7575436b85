// Bars and legend: readings have a range of their own, and everything is seen in both themes by all people.
#include <gtest/gtest.h>

#include <algorithm>

#include "script_lines.h"
#include "ui/theme.h"

namespace taxel::test {
namespace {

const std::string kAway = R"({"event": "mouse_move", "at": [5, 5]})";

std::string range_shot(const std::string& name) {
  return R"({"do": "screenshot", "file": ")" + name + R"("})";
}

/// Plays the sweep to 2.3 s and pauses, where four taxels respond; then more lines.
Lines at_contact(const Lines& more) {
  return joined({{key("="), key("="), R"({"do": "wait_time", "time": 2.3})", key("Space"), kIdle, kAway, kIdle}, more});
}

glm::vec3 color_at(const Picture& picture, double x, double y) {
  const auto pixel = picture.pixel(x, y);
  return glm::vec3(pixel[0], pixel[1], pixel[2]) / 255.0f;
}

/// Returns the largest contrast between any two pixels in a rectangle, with the least favourable sight.
double contrast_within(const Picture& picture, const Json& rect) {
  glm::vec3 darkest(1), lightest(0);
  for (double y = rect[1].get<double>(); y < rect[3].get<double>(); ++y)
    for (double x = rect[0].get<double>(); x < rect[2].get<double>(); ++x) {
      const glm::vec3 color = color_at(picture, x, y);
      if (ui::contrast(color, glm::vec3(0)) < ui::contrast(darkest, glm::vec3(0))) darkest = color;
      if (ui::contrast(color, glm::vec3(0)) > ui::contrast(lightest, glm::vec3(0))) lightest = color;
    }
  return ui::least_contrast(darkest, lightest);
}

std::vector<Json> widgets_of(const Json& state, const std::string& panel) {
  std::vector<Json> found;
  for (const Json& widget : state["widgets"])
    if (widget["panel"] == panel) found.push_back(widget);
  return found;
}

double number_at_top(const Json& state, const std::string& panel) {
  return std::stod(widgets_of(state, panel).back()["label"].get<std::string>());
}

TEST(Readings, HaveARangeOfTheirOwnUntilLinked) {
  const StudioProgram studio;
  studio.play(
      at_contact({dump("apart.json"), press("Link ranges"), kAway, kIdle, dump("linked.json"), press("Link ranges"),
                  kAway, kIdle, press("Readings range"), kAway, kIdle, dump("locked.json")}));
  const Json apart = studio.state("apart.json"), linked = studio.state("linked.json");
  const double surface = apart["range"]["largest"], readings = apart["reading_range"]["largest"];
  double largest = 0;
  for (const Json& peak : apart["simulation"]["peaks"]) largest = std::max(largest, peak.get<double>());
  EXPECT_GT(surface, 3 * readings) << "otherwise one range would do";
  EXPECT_GE(readings, largest);
  EXPECT_LE(readings, 2 * largest) << "the largest reading fills at least half of the range";
  EXPECT_EQ(apart["reading_range"]["unit"], "kPa");
  EXPECT_NEAR(1e3 * number_at_top(apart, "Pressure legend"), surface, 1e-3 * surface);
  EXPECT_NEAR(1e3 * number_at_top(apart, "Readings legend"), readings, 1e-3 * readings);
  EXPECT_EQ(apart["bars"][0]["top"], readings);
  EXPECT_EQ(linked["reading_range"]["largest"], surface);
  EXPECT_EQ(linked["bars"][0]["top"], surface);
  EXPECT_TRUE(linked["reading_range"]["linked"]);
  EXPECT_TRUE(widgets_of(linked, "Readings legend").empty()) << "one scale for both";
  const Json locked = studio.state("locked.json")["reading_range"];
  EXPECT_FALSE(locked["automatic"]);
  EXPECT_EQ(locked["largest"], readings);
}

/// Returns the larger contrast of the colours in the middle of a bar and at its left edge with the background above it.
double contrast_of_bar(const Picture& picture, const Json& bar) {
  const double x0 = bar["rect"][0], y0 = bar["rect"][1], x1 = bar["rect"][2], y1 = bar["rect"][3];
  const glm::vec3 background = color_at(picture, 0.5 * (x0 + x1), y0 - 6);
  const double middle = 0.5 * (y0 + y1);
  return std::max(ui::least_contrast(color_at(picture, 0.5 * (x0 + x1), middle), background),
                  ui::least_contrast(color_at(picture, x0, middle), background));
}

TEST(Readings, AreSeenInBothThemesByAllPeople) {
  const StudioProgram studio;
  std::filesystem::create_directories(studio.folder() / "state");
  for (const bool dark : {true, false}) {
    write_text(studio.folder() / "state/settings.json", Json{{"dark", dark}, {"tour_seen", true}}.dump());
    studio.play(at_contact({range_shot("picture.png"), dump("state.json")}), {"--state-dir", "state"});
    const Json state = studio.state("state.json");
    const Picture picture = studio.picture("picture.png");
    int bars = 0;
    for (const Json& bar : state["bars"]) {
      if (bar["height"] < 5) continue;
      ++bars;
      EXPECT_GE(contrast_of_bar(picture, bar), ui::kGraphicsContrast) << (dark ? "dark " : "light ") << bar["taxel"];
    }
    EXPECT_GE(bars, 2);
    std::vector<Json> texts;
    for (const char* panel : {"Legend", "Pressure legend", "Readings legend"})
      for (const Json& widget : widgets_of(state, panel)) texts.push_back(widget);
    EXPECT_GE(texts.size(), 8U);
    for (const Json& text : texts)
      EXPECT_GE(contrast_within(picture, text["rect"]), ui::kTextContrast) << (dark ? "dark " : "light ") << text;
  }
}

}  // namespace
}  // namespace taxel::test
