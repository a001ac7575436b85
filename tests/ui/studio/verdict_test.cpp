// Tests the diagnosis of the Explain panel on contacts whose artifact is known by construction: a scene is opened and
// run, it pauses where a taxel jumps, and E explains the jump.
#include <gtest/gtest.h>

#include <cmath>

#include "fixtures/labelled_touches.h"
#include "fixtures/touch_files.h"
#include "script_lines.h"

namespace taxel::test {
namespace {

/// The path from one of its poses on.
Touch from_pose(std::ptrdiff_t pose, Touch touch) {
  touch.path.erase(touch.path.begin(), touch.path.begin() + pose);
  return touch;
}

/// The state with the step explained at which these breakpoints ("jump >", "at constant force") stopped the scene.
Json explained_where(const std::vector<std::string>& breakpoints, Touch touch) {
  touch.layout.sampling.density = 1.5e6;  // the number of samples is irrelevant here
  const StudioProgram studio;
  // A taxel that is touched from the beginning must be touched for more than 3 / 0.1 steps to be considered
  // (breakpoints.h).
  constexpr int kRest = 40;
  write_scene(studio.folder(), touch, kRest);
  Lines lines{kIdle, key("Space"), kIdle, press("Tracks"), kIdle};
  for (const std::string& breakpoint : breakpoints) lines = joined({lines, {press(breakpoint), kIdle}});
  const std::string stopped = R"({"do": "wait_for", "pointer": "/messages/0/text", "contains": "jumped"})";
  studio.play(
      joined({lines,
              {key("Backspace"), kIdle, key("Space"), stopped, kIdle, key("e"), kIdle, kIdle, dump("explained.json")}}),
      {"scene.xml"});
  return studio.state("explained.json");
}

void expect_verdict(const Json& state, const std::string& cause, const std::string& words) {
  const Json &simulation = state["simulation"], &stop = simulation["history"]["stop"], &found = state["explain"];
  ASSERT_TRUE(stop.is_object()) << simulation["history"]["breakpoints"].dump();
  ASSERT_TRUE(found.is_object());
  EXPECT_FALSE(simulation["playing"]);
  EXPECT_EQ(found["step"], stop["step"]);
  EXPECT_EQ(found["taxel"]["id"], stop["taxel"]);
  const Json& v = found["verdict"];
  EXPECT_EQ(v["cause"], cause) << v["text"];
  EXPECT_EQ(v["text"].get<std::string>().rfind(words + ": ", 0), 0U) << v["text"];
  const double change = v["change"], field = v["field"], contact = v["contact"], noise = v["noise"], cone = v["cone"],
               edges = v["edges"];
  EXPECT_EQ(change, stop["after"].get<double>() - stop["before"].get<double>());
  EXPECT_NEAR(noise + field + cone + edges + contact, change, 1e-9 * std::abs(change));
  const bool star = cause == "star_field" || cause == "inverted_tets";
  for (const char* part : {"noise", "field", "cone", "edges", "contact"})
    EXPECT_LE(v[part].get<double>() / change, (star                    ? field
                                               : cause == "mesh_edges" ? edges
                                                                       : contact) /
                                                  change)
        << part;
  bool shown = false;
  for (const Json& widget : state["widgets"]) shown |= widget["panel"] == "Explain" && widget["label"] == "Verdict";
  EXPECT_TRUE(shown) << "in the panel";
}

TEST(Verdict, IsTheFieldForABallThatTapsAFingertipOnAStar) {
  expect_verdict(explained_where({"jump >"}, taps_on_fingertip(0.0045, 0.002)), "star_field", "Pressure field");
}

TEST(Verdict, IsInvertedTetsForABallThatTapsABentFinger) {
  expect_verdict(explained_where({"jump >"}, taps_in_hook(0.9, 0.0035, 0.0018)), "inverted_tets", "Inverted tets");
}

TEST(Verdict, IsRedistributionForABallMovedAlongAFinger) {
  const Json state = explained_where({"of sensor", "at constant force"}, led_along(0.0035, 0.0005));
  expect_verdict(state, "redistribution", "Redistribution");
  EXPECT_TRUE(state["simulation"]["history"]["stop"]["at_equal_force"].get<bool>());
  EXPECT_TRUE(state["explain"]["verdict"]["force_stays"]);
}

TEST(Verdict, IsMeshEdgesForABallThatMovesOverARoof) {
  const Json state = explained_where({"jump >"}, over_roof(60, 0.001));
  expect_verdict(state, "mesh_edges", "Mesh edges");
  EXPECT_FALSE(state["explain"]["verdict"]["crossed_edges"].empty());
}

TEST(Verdict, IsTheContactForAnEdgeThatMovesOverAnEgg) {
  const Json state = explained_where({"of sensor", "jump >"}, from_pose(3, edge_comes_over_egg(0.66)));
  expect_verdict(state, "contact", "The contact itself");
  EXPECT_FALSE(state["explain"]["verdict"]["force_stays"]);
}

}  // namespace
}  // namespace taxel::test
