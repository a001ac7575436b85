// Scenarios in files: round trips, unchanged output for sweeps, and errors for values out of range.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/document/scenario/scenario.h"

namespace taxel {
namespace {

std::string complaint(const std::string& text) {
  try {
    parse_scenario(text, "s.json");
  } catch (const Error& e) {
    return e.what();
  }
  return "accepted";
}

/// Returns a scenario in which every value that this kind uses differs from its default.
Scenario unlike_default(ScenarioKind kind, ObjectShape shape) {
  Scenario scenario = with_shape(default_scenario(kind), shape);
  double value = 0.1 + 0.2;
  for (const ScenarioNumber& number : numbers_of(scenario)) *number.value = value += 1;
  if (shape == ObjectShape::edge && has_object(scenario)) scenario.edge_radius = 1.1;
  if (auto* replay = std::get_if<scenarios::Replay>(&scenario.motion)) replay->source = "out";
  if (auto* path = std::get_if<scenarios::Path>(&scenario.motion))
    path->points = {{0, {}}, {0.1 + 0.2, {{0.6, 0, 0.8, 0}, {1, 2, 3}}}};
  return scenario;
}

TEST(ScenarioJson, KeepsEveryValueOfEveryKind) {
  for (const auto& word : words_of(ScenarioKind{})) {
    for (const ObjectShape shape : {ObjectShape::edge, ObjectShape::box, ObjectShape::sphere}) {
      const bool has_shape = word.value != kKind<scenarios::Paper>;
      const Scenario scenario = unlike_default(word.value, has_shape ? shape : ObjectShape::box);
      EXPECT_EQ(parse_scenario(scenario_to_json(scenario)), scenario) << word.text;
      EXPECT_EQ(parse_scenario(scenario_file_json(scenario)), scenario) << word.text;
    }
  }
}

TEST(ScenarioJson, ReadsAFileWithoutShapeAsABox) {
  for (const std::string text : {"{}", R"({"kind": "sweep", "depth": 0.0015})"}) {
    const Scenario scenario = parse_scenario(text);
    EXPECT_EQ(scenario, with_shape({}, ObjectShape::box)) << text;
    EXPECT_EQ(scenario.as<scenarios::Sweep>().before, 0.012);
    EXPECT_EQ(scenario.as<scenarios::Sweep>().past, 0.012);
  }
  EXPECT_EQ(parse_scenario(R"({"shape": "edge"})"), Scenario{});
}

TEST(ScenarioJson, NamesTheEdgeThatASweepCrosses) {
  EXPECT_EQ(scenario_to_json({}),
            R"({"depth":0.0015,"speed":0.01,"before":0.025,"past":0.025,"tilt_deg":45.0,"record_every":0.0001,)"
            R"("timestep":0.001,"finger_mass":0.02,"box_size":0.05,"edge_radius":0.001,"shape":"edge","object":""})");
}

TEST(Scenario, ChangesItsReachWithTheShapeUnlessChosen) {
  Scenario scenario;
  scenario.as<scenarios::Sweep>().past = 0.03;
  scenario = with_shape(scenario, ObjectShape::box);
  EXPECT_EQ(scenario.as<scenarios::Sweep>().before, kBoxReach);
  EXPECT_EQ(scenario.as<scenarios::Sweep>().past, 0.03);
  EXPECT_EQ(with_shape(scenario, ObjectShape::edge).as<scenarios::Sweep>().before, kEdgeReach);
}

TEST(Scenario, ChangesItsObjectWithTheKindUnlessChosen) {
  Scenario scenario = with_kind({}, kKind<scenarios::Press>);
  EXPECT_EQ(scenario.shape, ObjectShape::box);
  EXPECT_EQ(with_kind(scenario, kKind<scenarios::Sweep>), Scenario{});
  EXPECT_EQ(with_kind({}, kKind<scenarios::Path>).shape, ObjectShape::edge) << "its poses are those around the edge";
  scenario = with_kind(with_object({}, "a.obj"), kKind<scenarios::Press>);
  EXPECT_EQ(scenario.object, "a.obj");
}

TEST(Scenario, KeepsNumbersAcrossKindsUnlessDefaultsDiffer) {
  Scenario scenario = default_scenario(kKind<scenarios::Roll>);
  scenario.as<scenarios::Roll>().depth = 0.002;
  EXPECT_EQ(with_kind(scenario, kKind<scenarios::Sweep>).as<scenarios::Sweep>().depth, 0.002);
  EXPECT_EQ(with_kind(scenario, kKind<scenarios::Paper>).as<scenarios::Paper>().record_interval, 0.025);
  scenario.as<scenarios::Roll>().record_interval = 0.02;
  EXPECT_EQ(with_kind(scenario, kKind<scenarios::Paper>).as<scenarios::Paper>().record_interval, 0.02);
}

TEST(Scenario, RestoresTheValuesOfAKindWithTheKind) {
  LastScenarios last;
  Scenario scenario = default_scenario(kKind<scenarios::Roll>);
  scenario.as<scenarios::Roll>().angle_deg = 40;
  scenario.as<scenarios::Roll>().hold = 1;
  Scenario sweep = with_kind(scenario, kKind<scenarios::Sweep>, last);
  sweep.as<scenarios::Sweep>().depth = 0.003;
  const Scenario twist = with_kind(sweep, kKind<scenarios::Twist>, last);
  EXPECT_EQ(twist.as<scenarios::Twist>().angle_deg, 40) << "shared by roll and twist";
  scenario.as<scenarios::Roll>().depth = 0.003;
  EXPECT_EQ(with_kind(twist, kKind<scenarios::Roll>, last), scenario);
}

TEST(ScenarioJson, KeepsTheTextOfASweepOnABox) {
  EXPECT_EQ(scenario_to_json(with_shape({}, ObjectShape::box)),
            R"({"depth":0.0015,"speed":0.01,"before":0.012,"past":0.012,"tilt_deg":45.0,"record_every":0.0001,)"
            R"("timestep":0.001,"finger_mass":0.02,"box_size":0.05,"object":""})");
}

TEST(ScenarioJson, IsFoundInsideASweepJson) {
  const Scenario scenario = parse_scenario(R"({"format": "taxel-sweep", "scenario": {"depth": 0.001}})");
  EXPECT_EQ(scenario.as<scenarios::Sweep>().depth, 0.001);
}

TEST(ScenarioJson, NamesTheWrongField) {
  EXPECT_EQ(complaint(R"({"depth": -1})"), "s.json: /depth: must be greater than 0, is -1");
  for (const char* key :
       {"depth", "speed", "before", "tilt_deg", "record_every", "timestep", "finger_mass", "box_size"})
    EXPECT_EQ(complaint(fmt::format(R"({{"{}": 1e300}})", key)),
              fmt::format("s.json: /{}: must be at most 1e+06, is 1e+300", key));
  EXPECT_EQ(complaint(R"({"scenario": {"speed": "fast"}})"), "s.json: /scenario/speed: must be a number, is \"fast\"");
  EXPECT_EQ(complaint(R"({"dept": 1})"), "s.json: /dept: unknown key; did you mean \"depth\"?");
  EXPECT_EQ(complaint(R"({"before": 0, "past": 0})"), "s.json: /past: before and past together must be greater than 0");
  EXPECT_EQ(complaint(R"(3)"), "s.json: must be an object, is 3");
}

TEST(ScenarioJson, NamesFieldsThatDoNotBelongToTheKind) {
  EXPECT_EQ(complaint(R"({"kind": "press", "before": 0.01})"), R"(s.json: /before: is not used by the kind "press")");
  EXPECT_EQ(complaint(R"({"points": []})"), R"(s.json: /points: is not used by the kind "sweep")");
  EXPECT_EQ(
      complaint(R"({"kind": "push"})"),
      R"(s.json: /kind: must be one of "sweep", "press", "roll", "twist", "slide", "drop", "path", "replay", "paper", is "push")");
  EXPECT_EQ(complaint(R"({"shape": "cone"})"),
            R"(s.json: /shape: must be one of "edge", "box", "plate", "sphere", is "cone")");
  EXPECT_EQ(complaint(R"({"shape": "plate", "object": "a.obj"})"),
            "s.json: /shape: a mesh as \"object\" takes the place of the shape: leave one of them out");
  EXPECT_EQ(complaint(R"({"edge_radius": 0.001})"), R"(s.json: /edge_radius: is used by the shape "edge" only)");
  EXPECT_EQ(complaint(R"({"shape": "edge", "edge_radius": 0.025})"),
            "s.json: /edge_radius: must be less than half of box_size, 0.025, is 0.025");
  EXPECT_EQ(complaint(R"({"kind": "paper", "shape": "edge"})"), R"(s.json: /shape: is not used by the kind "paper")");
  EXPECT_EQ(complaint(R"({"kind": "replay"})"), "s.json: /source: a replay needs a recording: a folder or its .npz");
  EXPECT_EQ(complaint(R"({"format": "taxel-scenario", "version": 2, "scenario": {}})"),
            "s.json: /version: 2 is unknown, this program reads version 1");
  EXPECT_EQ(complaint(R"({"format": "taxel-scenario", "version": 1})"), "s.json: /scenario: is missing");
  EXPECT_EQ(complaint(R"({"format": "taxel-scenarios", "version": 1, "scenario": {}})"),
            "s.json: /format: must be \"taxel-scenario\", or the format of a recording, \"taxel-sweep\" or "
            "\"taxel-play\", is \"taxel-scenarios\"");
  EXPECT_EQ(complaint(R"({"formt": "taxel-scenario", "scenario": {}})").substr(0, 15), "s.json: /formt:");
}

TEST(ScenarioJson, NamesTheWrongWaypoint) {
  const auto path = [](const std::string& second) {
    return complaint(R"({"kind": "path", "points": [{"time": 1, "pos": [0, 0, 0], "quat": [1, 0, 0, 0]}, )" + second +
                     "]}");
  };
  EXPECT_EQ(complaint(R"({"kind": "path"})"), "s.json: /points: a path needs 2 way points, has 0");
  EXPECT_EQ(path(R"({"time": 1, "pos": [0, 0, 1], "quat": [1, 0, 0, 0]})"),
            "s.json: /points/1/time: must be later than that of the way point before, 1, is 1");
  EXPECT_EQ(path(R"({"time": 2, "pos": [0, 0], "quat": [1, 0, 0, 0]})"),
            "s.json: /points/1/pos: must be an array of 3 numbers, is [0,0]");
  EXPECT_EQ(path(R"({"time": 2, "pos": [0, 0, 1], "quat": [1, 1, 0, 0]})"),
            "s.json: /points/1/quat: must be of length 1, is of length 1.4142135623730951");
  EXPECT_EQ(path(R"({"time": 2, "quat": [1, 0, 0, 0]})"), "s.json: /points/1/pos: is missing");
}

}  // namespace
}  // namespace taxel
