// The example of the paper's artifact, as a user sees it: one command shows the jump and its explanation, and "Fix it"
// removes it.
#include <gtest/gtest.h>

#include "script_lines.h"

namespace taxel::test {
namespace {

const Lines kShow{kIdle, key("k", kCtrl),
                  kIdle, type("jumping"),
                  kIdle, key("Enter"),
                  kIdle, R"({"do": "wait_for", "pointer": "/explain/verdict/cause", "contains": "sampling_noise"})",
                  kIdle, dump("jumped.json")};

/// The sweep of the window's start, over an edge.
const std::vector<std::string> kAtTheEdge{"--scenario", TAXEL_SOURCE_DIR "/tests/fixtures/edge_sweep.json"};

TEST(JumpingTaxel, PausesIsExplainedAndFixed) {
  const StudioProgram studio;
  studio.play(
      joined({kShow,
              {press("Fix it"), kIdle, R"({"do": "wait_for", "pointer": "/simulation/playing", "equals": true})",
               R"({"do": "wait_time", "time": 3.4})", dump("fixed.json"), key("Space"), kIdle, key("z", kCtrl), kIdle,
               dump("undone.json")}}),
      kAtTheEdge);
  const Json jumped = studio.state("jumped.json"), fixed = studio.state("fixed.json");
  const Json& stop = jumped["simulation"]["history"]["stop"];
  ASSERT_TRUE(stop.is_object());
  EXPECT_FALSE(jumped["simulation"]["playing"]);
  EXPECT_EQ(jumped["selection"]["taxel"], stop["taxel"]);
  EXPECT_EQ(jumped["explain"]["taxel"]["id"], stop["taxel"]);
  const double sparse = jumped["document"]["layout"]["sampling"]["density"].get<double>();
  const double needed = jumped["explain"]["verdict"]["samples_needed"]["factor"].get<double>();
  EXPECT_EQ(fixed["document"]["layout"]["sampling"]["density"].get<double>(), 4 * sparse * needed);
  EXPECT_GT(fixed["simulation"]["time"], jumped["simulation"]["time"]) << "it ran beyond the place of the jump";
  EXPECT_TRUE(fixed["simulation"]["history"]["stop"].is_null()) << fixed["simulation"]["history"]["stop"];
  EXPECT_EQ(studio.state("undone.json")["document"]["layout"]["sampling"]["density"], sparse) << "one step of undo";
}

TEST(JumpingTaxel, IsForgottenWithItsDocument) {
  const StudioProgram studio;
  studio.play(joined({kShow,
                      {R"({"event": "drop", "files": [")" + kLayoutFile + R"("]})", kIdle,
                       R"({"do": "wait_time", "time": 1})", key("Space"), kIdle, dump("other.json")}}),
              kAtTheEdge);
  EXPECT_TRUE(studio.state("other.json")["explain"].is_null() ||
              studio.state("other.json")["simulation"]["history"]["stop"].is_null());
}

}  // namespace
}  // namespace taxel::test
