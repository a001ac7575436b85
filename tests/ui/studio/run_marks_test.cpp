// The marks of a run: few arrows and ids, discs that glow, forces with their numbers, each named in the legend.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "script_lines.h"

namespace taxel::test {
namespace {

const std::string kPointerAway = R"({"event": "mouse_move", "at": [5, 5]})";
constexpr int kMostArrows = 60;

/// Returns the lines that run a scene for some time and pause it, without a taxel under the pointer.
Lines paused_at(const std::string& seconds) {
  return {kIdle,        kPointerAway, R"({"do": "wait_time", "time": )" + seconds + "}", key("Space"), kIdle,
          kPointerAway, kIdle};
}

/// Returns the number of taxels of all sensors with a reading above two hundredths of the range.
int responding(const Json& state) {
  int count = 0;
  const double least = 0.02 * state["reading_range"]["largest"].get<double>();
  for (const Json& sensor : state["simulation"]["sensors"])
    for (const Json& reading : sensor["readings"]) count += reading.get<double>() > least ? 1 : 0;
  return count;
}

int touched(const Json& state) {
  int count = 0;
  for (const Json& sensor : state["simulation"]["sensors"])
    for (const Json& reading : sensor["readings"]) count += reading.get<double>() > 0 ? 1 : 0;
  return count;
}

std::set<std::string> texts_of(const Json& state, const std::string& panel) {
  std::set<std::string> texts;
  for (const Json& widget : state["widgets"])
    if (widget["panel"] == panel) texts.insert(widget["label"].get<std::string>());
  return texts;
}

/// Expects that only responding taxels of a run have marks.
void expect_few_marks(const Json& state) {
  const Json& marks = state["marks"];
  EXPECT_GE(responding(state), 1);
  EXPECT_EQ(marks["arrows"], std::min(kMostArrows, responding(state)));
  EXPECT_EQ(marks["discs"], touched(state)) << "no disc at zero";
  EXPECT_EQ(marks["samples"], 0);
  EXPECT_EQ(marks["bold_rings"], 0);
  EXPECT_LE(marks["labels"].get<int>(), marks["arrows"].get<int>() + marks["forces"].get<int>());
  EXPECT_LE(marks["leaders"], 24);
}

TEST(RunMarks, AreThoseOfRespondingTaxelsInARunAndAllInLayout) {
  const StudioProgram studio;
  studio.play(joined({paused_at("2.3"),
                      {dump("run.json"), key("P"), kIdle, dump("samples.json"), kLayoutMode, kIdle, kPointerAway, kIdle,
                       dump("layout.json"), key("T"), kIdle, dump("x_ray.json")}}));
  const Json run = studio.state("run.json"), layout = studio.state("layout.json");
  expect_few_marks(run);
  EXPECT_EQ(run["marks"]["rings"], 12) << "thin rings of all taxels";
  EXPECT_GT(studio.state("samples.json")["marks"]["samples"], 1000);
  EXPECT_EQ(layout["marks"]["arrows"], 12);
  EXPECT_EQ(layout["marks"]["rings"], 12);
  EXPECT_EQ(layout["marks"]["discs"], 0);
  EXPECT_GT(layout["marks"]["samples"], 1000) << "LAYOUT has its own switches";
  EXPECT_EQ(layout["labels"].size(), 6U) << "those of the near side of an opaque skin";
  EXPECT_EQ(studio.state("x_ray.json")["labels"].size(), 12U);
}

TEST(RunMarks, AddTheTaxelUnderThePointer) {
  const StudioProgram studio;
  const std::string on_the_finger = R"({"event": "mouse_move", "at": {"view": [0.56, 0.48]}})";
  studio.play(joined({paused_at("2.6"),
                      {dump("away.json"), on_the_finger,
                       R"({"do": "wait_for", "pointer": "/marks/bold_rings", "equals": 1})", dump("hovered.json")}}),
              {"--scenario", TAXEL_SOURCE_DIR "/tests/fixtures/edge_sweep.json"});
  const Json away = studio.state("away.json")["marks"], hovered = studio.state("hovered.json")["marks"];
  EXPECT_EQ(away["bold_rings"], 0);
  EXPECT_EQ(hovered["bold_rings"], 1);
  EXPECT_EQ(hovered["rings"], 12);
  EXPECT_GE(hovered["labels"].get<int>(), away["labels"].get<int>());
  EXPECT_LE(hovered["arrows"].get<int>() - away["arrows"].get<int>(), 1);
}

TEST(RunMarks, StayFewForTwoHundredAndFortyTaxels) {
  const StudioProgram studio;
  Json layout = Json::parse(file_text(kLayoutFile));
  layout["mesh"]["file"] = kMeshFile;
  Json taxels = Json::array();
  for (int k = 0; k < 240; ++k) {  // twenty in the plane of each taxel
    Json one = layout["taxels"][static_cast<std::size_t>(k % 12)];
    const dvec3 normal = glm::normalize(vector_of(one["normal"])), u = any_perpendicular(normal),
                p = vector_of(one["center"]) +
                    1.2e-3 * (((k / 12) % 4 - 1.5) * u + ((k / 48) - 2.0) * glm::cross(normal, u));
    one["id"] = k;
    one["name"] = "";
    one["radius"] = 0.0012;
    one["center"] = {p.x, p.y, p.z};
    taxels.push_back(one);
  }
  layout["taxels"] = taxels;
  write_text(studio.folder() / "many.taxels.json", layout.dump());
  studio.play(joined({paused_at("2.3"), {dump("run.json")}}), {"many.taxels.json"});
  expect_few_marks(studio.state("run.json"));
}

TEST(RunMarks, NameTheFingersOfAHandAndTheForces) {
  const StudioProgram studio;
  studio.play(joined({paused_at("0.3"), {dump("run.json")}}), {TAXEL_SOURCE_DIR "/assets/scenes/hand_grasps_ball.xml"});
  const Json state = studio.state("run.json");
  expect_few_marks(state);
  int forces = 0;
  for (const Json& label : state["labels"]) {
    const std::string text = label["text"];
    const bool is_force = text.ends_with(" N");
    forces += is_force ? 1 : 0;
    EXPECT_TRUE(is_force || text.starts_with("index ") || text.starts_with("middle ") || text.starts_with("ring ") ||
                text.starts_with("little ") || text.starts_with("thumb "))
        << text;
  }
  EXPECT_GE(forces, 1);
  EXPECT_GE(state["marks"]["forces"], forces);
}

TEST(RunMarks, HaveNamesAndUnitsInTheLegend) {
  const StudioProgram studio;
  studio.play(
      joined({{kIdle, R"({"event": "wheel", "at": {"view": [0.5, 0.5]}, "y": -0.01})", kIdle},  // the camera stays
              paused_at("2.3"),
              {dump("run.json"), key("Y"), kIdle, dump("no_rays.json")}}));
  const Json state = studio.state("run.json");
  const std::set<std::string> texts = texts_of(state, "Marks");
  for (const char* text : {"Net force", "10 mm = 1 N", "Rays to the contact", "Path of the finger", "Normals of taxels",
                           "Readings of fields", "kPa"})
    EXPECT_TRUE(texts.contains(text)) << text;
  EXPECT_FALSE(texts_of(studio.state("no_rays.json"), "Marks").contains("Rays to the contact"));
  const Json& force = state["simulation"]["sensors"][0]["force"];
  char expected[32];
  std::snprintf(expected, sizeof expected, "%.2f N", glm::length(vector_of(force)));
  bool written = false;
  for (const Json& label : state["labels"]) written = written || label["text"] == expected;
  EXPECT_TRUE(written) << expected;
}

}  // namespace
}  // namespace taxel::test
