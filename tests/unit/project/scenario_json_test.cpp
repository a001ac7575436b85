// The sweep's parameters survive a file, and what is out of range is named.
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/project/scenario_json.h"

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

TEST(ScenarioJson, KeepsEveryValue) {
  SweepScenario scenario{0.1 + 0.2, 2, 3, 4, -30, 6, 7, 8, 9, "object.obj"};
  EXPECT_EQ(parse_scenario(scenario_to_json(scenario)), scenario);
  EXPECT_EQ(parse_scenario("{}"), SweepScenario{});
}

TEST(ScenarioJson, IsFoundInsideASweepJson) {
  const SweepScenario scenario = parse_scenario(R"({"format": "taxel-sweep", "scenario": {"depth": 0.001}})");
  EXPECT_EQ(scenario.depth, 0.001);
}

TEST(ScenarioJson, NamesWhatIsWrong) {
  EXPECT_EQ(complaint(R"({"depth": -1})"), "s.json: /depth: must be greater than 0, is -1");
  EXPECT_EQ(complaint(R"({"scenario": {"speed": "fast"}})"), "s.json: /scenario/speed: must be a number, is \"fast\"");
  EXPECT_EQ(complaint(R"({"dept": 1})"), "s.json: /dept: unknown key");
  EXPECT_EQ(complaint(R"({"before": 0, "past": 0})"), "s.json: /past: before and past together must be greater than 0");
  EXPECT_EQ(complaint(R"(3)"), "s.json: must be an object, is 3");
}

}  // namespace
}  // namespace taxel
