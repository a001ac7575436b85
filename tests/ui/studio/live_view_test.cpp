// The views of one step through the program: tractions, readings on the skin, the flat map.
#include <gtest/gtest.h>

#include <cmath>

#include "script_lines.h"

namespace taxel::test {
namespace {

const std::string kOutOfTheWay = R"({"event": "mouse_move", "at": [5, 5]})";

std::string shot(const std::string& name) {
  return R"({"do": "screenshot", "file": ")" + name + R"("})";
}
std::string toolbar(const std::string& label) {
  return press("Toolbar/" + label);
}

/// Paused in the middle of the contact, with only the skin, the contact and the path drawn.
const Lines kBare{key("="),
                  key("="),
                  R"({"do": "wait_time", "time": 1.3})",
                  key("Space"),
                  kIdle,
                  toolbar("Rays"),
                  kIdle,
                  toolbar("Taxels"),
                  kIdle,
                  toolbar("Fields"),
                  kIdle,
                  kOutOfTheWay,
                  kIdle};

int count_colour(const Picture& picture, const Json& rect, const Json& color) {
  int count = 0;
  for (int y = static_cast<int>(rect[1].get<double>()); y < rect[3].get<double>(); ++y)
    for (int x = static_cast<int>(rect[0].get<double>()); x < rect[2].get<double>(); ++x)
      count += color_distance(picture.pixel(x, y), color) <= 30 ? 1 : 0;
  return count;
}

TEST(LiveView, DrawsTheForceOverAnOpaqueSkin) {
  const StudioProgram studio;
  studio.play(joined({kBare, {shot("x_ray.png"), key("t"), kIdle, shot("opaque.png"), dump("opaque.json")}}));
  const Json state = studio.state("opaque.json");
  ASSERT_FALSE(state["overlays"]["sensor_transparent"].get<bool>());
  const Json white{1.0, 1.0, 1.0};
  const Json& view = state["view"]["rect"];
  const int seen = count_colour(studio.picture("x_ray.png"), view, white);
  EXPECT_GT(seen, 100);
  EXPECT_GT(count_colour(studio.picture("opaque.png"), view, white), 0.9 * seen) << "the arrow and its value";
}

TEST(LiveView, DrawsTractionsOfTheDisplayedStep) {
  const StudioProgram studio;
  studio.play(joined({kBare,
                      {shot("without.png"), key("v"), kIdle, shot("with.png"), dump("with.json"), key("v"), kIdle,
                       shot("off.png"), dump("off.json")}}));
  const Json state = studio.state("with.json"), &sensor = state["simulation"]["sensors"][0];
  const Json& tractions = state["tractions"];
  ASSERT_TRUE(tractions.is_object());
  EXPECT_TRUE(state["overlays"]["tractions"].get<bool>());
  EXPECT_EQ(tractions["polygons"], sensor["polygons"]);
  EXPECT_TRUE(tractions["friction_known"].get<bool>());
  const double largest = tractions["largest_pressure"], friction = tractions["largest_friction"];
  EXPECT_LE(largest, 1.05 * sensor["max_pressure"].get<double>()) << "but for damping";
  EXPECT_GT(largest, 0.5 * sensor["max_pressure"].get<double>());
  EXPECT_LT(friction, 0.5001 * largest) << "mu of the fingertip and of the box is 0.5";
  EXPECT_GT(friction, 0.4 * largest) << "it slides";
  const Json pink{1.0, 0x6F / 255.0, 0xD8 / 255.0};
  const Json& view = state["view"]["rect"];
  EXPECT_GT(count_colour(studio.picture("with.png"), view, pink), 100);
  EXPECT_LT(count_colour(studio.picture("without.png"), view, pink), 5);
  EXPECT_TRUE(studio.state("off.json")["tractions"].is_null());
  EXPECT_EQ(file_text(studio.folder() / "off.png"), file_text(studio.folder() / "without.png"));
}

TEST(LiveView, DrawsTheSkinInTheColoursOfTheReadings) {
  const StudioProgram studio;
  studio.play(joined({kBare,
                      {toolbar("Contact"), kIdle, toolbar("Path"), kIdle, kOutOfTheWay, key("s"), kIdle, kIdle,
                       shot("skin.png"), dump("skin.json")}}));
  const Json state = studio.state("skin.json");
  ASSERT_TRUE(state["skin"].is_object());
  EXPECT_EQ(state["skin"]["largest"], state["reading_range"]["largest"]);
  const Picture picture = studio.picture("skin.png");
  const Json& view = state["view"]["rect"];
  int looked_at = 0, right = 0;
  double largest = 0;
  for (const Json& point : state["skin"]["points"]) {
    largest = std::max(largest, point["value"].get<double>());
    const double x = point["pixel"][0], y = point["pixel"][1];
    if (!point["facing"].get<bool>() || x < view[0] || y < view[1] || x >= view[2] || y >= view[3]) continue;
    ++looked_at;
    right += color_distance(picture.pixel(x, y), point["color"]) <= 6 ? 1 : 0;
  }
  double reading = 0;
  for (const Json& r : state["simulation"]["readings"]) reading = std::max(reading, r.get<double>());
  EXPECT_LE(largest, reading * (1 + 1e-6)) << "a mean of readings";
  EXPECT_GT(largest, 0.8 * reading);
  EXPECT_GT(looked_at, 50);
  EXPECT_GT(right, 0.8 * looked_at) << "a label hides some";
}

/// Expects that the discs do not overlap and are inside the panel.
void expect_readable(const Json& state, std::size_t taxels) {
  const Json& discs = state["map"]["discs"];
  ASSERT_EQ(discs.size(), taxels);
  const double r = discs[0]["radius"];
  EXPECT_GT(r, 2.5);
  for (std::size_t i = 0; i < discs.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double dx = discs[i]["at"][0].get<double>() - discs[j]["at"][0].get<double>(),
                   dy = discs[i]["at"][1].get<double>() - discs[j]["at"][1].get<double>();
      EXPECT_GT(std::hypot(dx, dy), 1.9 * r) << discs[i]["taxel"] << " and " << discs[j]["taxel"];
    }
  }
}

const Lines kOpenMap{press("Panels"), kIdle, press("Taxel map"), kIdle, kIdle};

TEST(LiveView, ShowsReadingsInTheMapAndSelectsByIt) {
  const StudioProgram studio;
  studio.play(joined(
      {kBare,
       kOpenMap,
       {kOutOfTheWay, kIdle, shot("map.png"), dump("map.json"), press("Disc 10"), kIdle, dump("clicked.json")}}));
  const Json state = studio.state("map.json");
  expect_readable(state, 12);
  const Picture picture = studio.picture("map.png");
  for (std::size_t i = 0; i < 12; ++i) {
    const Json& disc = state["map"]["discs"][i];
    EXPECT_EQ(disc["value"], state["simulation"]["readings"][i]);
    const double x = disc["at"][0], y = disc["at"][1];
    EXPECT_LE(color_distance(picture.pixel(x, y - 0.8 * disc["radius"].get<double>()), disc["color"]), 3) << i;
  }
  EXPECT_EQ(studio.state("clicked.json")["selection"]["taxel"], 10);
}

TEST(LiveView, MirrorsTheMapOfAMirroredFinger) {
  const StudioProgram studio;
  studio.play(joined({kOpenMap, {dump("map.json")}}));
  const Json discs = studio.state("map.json")["map"]["discs"];
  double middle = 0;
  for (const Json& disc : discs) middle += disc["at"][0].get<double>() / 12;
  for (std::size_t k = 0; k < 6; ++k) {
    EXPECT_NEAR(discs[k]["at"][0].get<double>() - middle, middle - discs[k + 6]["at"][0].get<double>(), 1.0) << k;
    EXPECT_NEAR(discs[k]["at"][1].get<double>(), discs[k + 6]["at"][1].get<double>(), 1.0) << k;
  }
}

TEST(LiveView, IsIdleInTheStatusLineIfNothingMoves) {
  const StudioProgram studio;
  studio.play({R"({"do": "wait_for", "pointer": "/simulation/step", "least": 50})", dump("runs.json"), key("Space"),
               R"({"do": "wait_for", "pointer": "/simulation/playing", "equals": false})",
               R"({"do": "rest", "seconds": 1})", dump("rests.json")},
              {"--live", kLayoutFile});
  const auto shows = [](const Json& state, const std::string& begin) {
    for (const Json& widget : state["widgets"])
      if (widget["panel"] == "Status" && widget["label"].get<std::string>().starts_with(begin)) return true;
    return false;
  };
  const Json runs = studio.state("runs.json"), rests = studio.state("rests.json");
  EXPECT_TRUE(shows(runs, "fps"));
  EXPECT_FALSE(shows(runs, "idle"));
  EXPECT_FALSE(shows(rests, "fps"));
  EXPECT_TRUE(shows(rests, "idle"));
}

}  // namespace
}  // namespace taxel::test
