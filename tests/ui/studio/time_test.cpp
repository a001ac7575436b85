// Recorded steps of the simulation: scrubbed, replayed, resumed from and searched for events, with keys and mouse.
#include <gtest/gtest.h>

#include <cmath>
#include <regex>
#include <set>

#include "script_lines.h"

namespace taxel::test {
namespace {

std::string pixel(double x, double y) {
  return Json({x, y}).dump();
}
std::string mouse(const std::string& event, const std::string& at, const Json& mods = {}) {
  Json line{{"event", event}, {"at", Json::parse(at)}};
  if (!mods.empty()) line["mods"] = mods;
  return line.dump();
}
Lines times(int count, const Lines& lines) {
  Lines all;
  for (int i = 0; i < count; ++i) all.insert(all.end(), lines.begin(), lines.end());
  return all;
}

/// Returns the position of a step in the timeline.
std::string in_timeline(const Json& state, double step) {
  const Json &lanes = state["timeline"]["lanes"], &steps = state["timeline"]["steps"];
  const double first = steps[0], last = steps[1], x0 = lanes[0], x1 = lanes[2];
  return pixel(x0 + (step - first + 0.5) / (last - first + 1) * (x1 - x0),
               0.5 * (lanes[1].get<double>() + lanes[3].get<double>()));
}

/// Returns the values that views, bars and numbers display of a step, without additional data about steps.
Json shown(const Json& state) {
  Json json = {{"simulation", state["simulation"]},
               {"bars", state["bars"]},
               {"polygons", state["polygons"]},
               {"camera", state["camera"]},
               {"range", state["range"]}};
  for (const char* part : {"history", "rows", "peaks"}) json["simulation"].erase(part);
  return json;
}

const Lines kInContact{key("="), key("="), wait_time(1.3), key("Space"), kIdle};

TEST(Time, ShowsRecordedStepsWhenScrubbedBackTenSteps) {
  const StudioProgram studio;
  Lines script = kInContact;
  for (int i = 0; i <= 10; ++i) {
    script.push_back(dump("live" + std::to_string(i) + ".json"));
    if (i < 10) script.insert(script.end(), {key("Right"), kIdle});
  }
  for (int i = 9; i >= 0; --i)
    script.insert(script.end(), {key("Left"), kIdle, dump("back" + std::to_string(i) + ".json")});
  for (int i = 1; i <= 10; ++i)
    script.insert(script.end(), {key("Right"), kIdle, dump("forth" + std::to_string(i) + ".json")});
  studio.play(script);
  for (int i = 0; i <= 10; ++i) {
    const std::string number = std::to_string(i);
    const Json live = studio.state("live" + number + ".json");
    EXPECT_FALSE(live["simulation"]["history"]["recorded"]);
    EXPECT_GT(live["polygons"].size(), 50U);
    for (std::size_t k = 0; k < live["bars"].size(); ++k)
      EXPECT_EQ(live["bars"][k]["value"], live["simulation"]["readings"][k]) << "all views show the same step";
    if (i < 10) {
      EXPECT_EQ(shown(studio.state("back" + number + ".json")), shown(live)) << i;
      EXPECT_TRUE(studio.state("back" + number + ".json")["simulation"]["history"]["recorded"]);
    }
    if (i == 0) continue;
    EXPECT_EQ(shown(studio.state("forth" + number + ".json")), shown(live)) << i;
  }
  EXPECT_EQ(studio.state("live10.json")["simulation"]["step"],
            studio.state("live0.json")["simulation"]["step"].get<int>() + 10);
  EXPECT_NE(shown(studio.state("live10.json")), shown(studio.state("live0.json")));
  EXPECT_FALSE(studio.state("forth10.json")["simulation"]["history"]["recorded"]) << "the newest is no past";
}

TEST(Time, GoesBackFiveHundredStepsAfterALayoutChange) {
  const StudioProgram studio;
  const Lines edited = joined({kInContact,
                               {key("Home"), kIdle, dump("first.json"), key("Space"), wait_time(1.85), key("Space"),
                                kIdle, kLayoutMode, kIdle, click(taxel(3)), kIdle, key("f"), type("2"), key("Enter"),
                                kIdle, key("2", kCtrl), kIdle, dump("edited.json")}});
  studio.play(edited);
  const Json first = studio.state("first.json"), changed = studio.state("edited.json");
  const int step = first["simulation"]["step"];
  ASSERT_GE(changed["simulation"]["step"].get<int>(), step + 500);
  // A click in the timeline is as exact as its pixels. Keys go the remaining steps.
  const Lines clicked = joined({edited, {click(in_timeline(changed, step)), kIdle, dump("clicked.json")}});
  studio.play(clicked);
  const Json near = studio.state("clicked.json");
  EXPECT_TRUE(near["simulation"]["history"]["recorded"]);
  const int rest = near["simulation"]["step"].get<int>() - step;
  EXPECT_LE(std::abs(rest), 3);
  studio.play(joined({clicked,
                      times(std::abs(rest), {key(rest > 0 ? "Left" : "Right"), kIdle}),
                      {key("Esc"), kIdle, dump("back.json"), key("End"), kIdle, dump("newest.json")}}));
  const Json back = studio.state("back.json");
  EXPECT_EQ(back["simulation"]["readings"], first["simulation"]["readings"]);
  EXPECT_EQ(shown(back)["simulation"], shown(first)["simulation"]);
  EXPECT_EQ(back["polygons"], first["polygons"]);
  EXPECT_EQ(studio.state("newest.json")["simulation"]["readings"], changed["simulation"]["readings"]);
  EXPECT_NE(changed["document"], first["document"]) << "it was changed";
}

TEST(Time, ResumesFromTheDisplayedStep) {
  const StudioProgram studio;
  // Relative to the largest reading of the sensor no taxel jumps here, so the contact is the only event.
  studio.play(joined({{kIdle, press("Tracks"), kIdle, press("of sensor"), kIdle},
                      kInContact,
                      {key("Left", kShift), kIdle, dump("back.json"), key("Space"), wait_time(0.8), key("Space"), kIdle,
                       dump("again.json")}}));
  const Json back = studio.state("back.json")["simulation"], again = studio.state("again.json")["simulation"];
  EXPECT_EQ(back["step"], back["history"]["events"][0]["step"]);
  EXPECT_EQ(back["history"]["events"][0]["what"], Json({"contact_begins"}));
  EXPECT_EQ(again["history"]["last"], again["step"]) << "later steps are discarded";
  EXPECT_GT(again["step"], back["step"]);
  EXPECT_LT(again["step"], back["history"]["last"]);
  EXPECT_FALSE(again["history"]["recorded"]);
  const auto highest = [](const Json& simulation) {
    const std::vector<double> peaks = simulation["peaks"];
    return *std::max_element(peaks.begin(), peaks.end());
  };
  EXPECT_GT(highest(again), 0);
  EXPECT_LT(highest(again), highest(back)) << "the discarded steps do not count";
}

TEST(Time, PausesAtALargeSamplingError) {
  const StudioProgram studio;
  studio.play(joined({{kIdle, key("Backspace"), kIdle, press("Tracks"), kIdle, press("Sampling error"), key("a", kCtrl),
                       type("2"), key("Enter"), kIdle, press("vs. exact integral"), kIdle, key("Space"), at_frame(170)},
                      {dump("state.json"), R"({"do": "screenshot", "file": "a.png"})"}}));
  const Json simulation = studio.state("state.json")["simulation"], stop = simulation["history"]["stop"];
  ASSERT_TRUE(stop.is_object()) << simulation["history"]["breakpoints"].dump();
  EXPECT_FALSE(simulation["playing"]);
  EXPECT_EQ(stop["step"], simulation["step"]);
  EXPECT_GT(stop["part"], 0.02);
  EXPECT_EQ(simulation["history"]["events"].back()["step"], stop["step"]);
  EXPECT_NE(simulation["history"]["events"].back()["what"].dump().find("disagreement"), std::string::npos);
  const auto taxel = stop["taxel"].get<std::size_t>();  // ids of our fingertip start at 0
  EXPECT_EQ(stop["sampled"], simulation["readings"][taxel]);
  EXPECT_NE(stop["exact"], stop["sampled"]);
  EXPECT_NE(studio.state("state.json")["messages"].dump().find("by the surface"), std::string::npos);
}

/// Checks a jump relative to the largest reading so far of each taxel or, if `of_sensor`, of all taxels.
void pauses_at_the_first_jump(bool of_sensor) {
  SCOPED_TRACE(of_sensor ? "of sensor" : "of each taxel");
  const StudioProgram studio;
  const auto script = [of_sensor](const Lines& stops) {
    return joined({{kIdle, key("Backspace"), kIdle, press("Tracks"), kIdle, press("Jump"), key("a", kCtrl), type("1"),
                    key("Enter"), kIdle},
                   of_sensor ? Lines{press("of sensor"), kIdle} : Lines{},
                   stops,
                   {key("Space"), at_frame(170), dump("state.json")}});
  };
  studio.play(script({}));
  const Json free = studio.state("state.json")["simulation"];
  EXPECT_TRUE(free["finished"]);
  EXPECT_EQ(free["history"]["breakpoints"]["jump"], 0.01);
  EXPECT_EQ(free["history"]["breakpoints"]["of_sensor"], of_sensor);
  EXPECT_GE(free["history"]["steps"], 2000) << "of the whole sweep";
  EXPECT_GT(free["history"]["bytes"], 2000 * 1000) << "and shown in the timeline";
  int first = 0;
  for (const Json& event : free["history"]["events"]) {
    const std::string what = event["what"].dump();
    if (first == 0 && what.find("jump") != std::string::npos) first = event["step"];
  }
  ASSERT_GT(first, 0) << "there is one in this sweep";
  studio.play(joined({script({key("b", kShift), kIdle}), {key("Left"), kIdle, dump("before.json")}}));
  const Json state = studio.state("state.json"), stopped = state["simulation"];
  EXPECT_EQ(stopped["step"], first) << "exactly there";
  EXPECT_FALSE(stopped["playing"]);
  const Json stop = stopped["history"]["stop"], before = studio.state("before.json")["simulation"];
  EXPECT_EQ(stop["step"], first);
  EXPECT_GT(stop["part"], 0.01);
  EXPECT_EQ(before["step"], first - 1);
  const std::vector<double> peaks = stopped["peaks"];
  const double of_all = *std::max_element(peaks.begin(), peaks.end());
  const auto part_of = [&](std::size_t k) {
    const double change = std::abs(stopped["readings"][k].get<double>() - before["readings"][k].get<double>());
    return change / std::max(5.0, of_sensor ? of_all : peaks[k]);  // 5 Pa: 1e-4 of the modulus
  };
  const auto which = stop["taxel"].get<std::size_t>();  // ids of our fingertip start at 0
  EXPECT_DOUBLE_EQ(stop["part"].get<double>(), part_of(which));
  // Relative to its own peak, a taxel that has just been touched is not yet considered.
  if (of_sensor) {
    for (std::size_t k = 0; k < peaks.size(); ++k) EXPECT_LE(part_of(k), part_of(which)) << k;
  }
  EXPECT_EQ(stop["after"], stopped["readings"][which]);
  EXPECT_EQ(stop["before"], before["readings"][which]);
  const std::regex said(
      R"(Paused at step \d+, [\d.]+ s: taxel \d+.* jumped from ([\d.]+) kPa to ([\d.]+) kPa, [\d.]+ %)");
  const std::string messages = state["messages"].dump();
  std::smatch numbers;
  ASSERT_TRUE(std::regex_search(messages, numbers, said)) << messages;
  const double change = stop["after"].get<double>() - stop["before"].get<double>();
  EXPECT_NEAR(1e3 * (std::stod(numbers[2]) - std::stod(numbers[1])), change, 0.1 * std::abs(change)) << messages;
}

TEST(Time, PausesAtTheFirstJumpOfATaxel) {
  for (const bool of_sensor : {false, true}) pauses_at_the_first_jump(of_sensor);
}

TEST(Time, KeepsTheRequestedNumberOfStepsAndShowsTheirSize) {
  const StudioProgram studio;
  studio.play(joined(
      {kInContact,
       {dump("all.json"), press("Tracks"), kIdle, press("Kept steps"), key("a", kCtrl), type("300"), key("Enter"),
        kIdle, kIdle, dump("fewer.json"), key("Space"), wait_time(1.4), key("Space"), kIdle, dump("later.json")},
       times(3, {key("Left"), kIdle}),
       {dump("past.json")}}));
  const Json all = studio.state("all.json")["simulation"]["history"], fewer = studio.state("fewer.json")["simulation"];
  const Json later = studio.state("later.json")["simulation"], past = studio.state("past.json")["simulation"];
  EXPECT_EQ(all["limit"], 8000);
  EXPECT_GT(all["steps"], 1200);
  EXPECT_EQ(fewer["history"]["limit"], 300);
  EXPECT_LT(fewer["history"]["bytes"], all["bytes"]);
  for (const Json& simulation : {fewer, later}) {
    const Json& history = simulation["history"];
    EXPECT_EQ(history["steps"], 300);
    EXPECT_EQ(history["last"], simulation["step"]) << "the latest ones stay";
    EXPECT_EQ(history["first"].get<int>(), history["last"].get<int>() - 299);
  }
  EXPECT_GT(later["step"], fewer["step"]);
  EXPECT_EQ(past["step"].get<int>(), later["step"].get<int>() - 3);
  EXPECT_TRUE(past["history"]["recorded"]);
}

TEST(Time, ScrubsLoopsAndPlaysBackwardsInTheTimeline) {
  const StudioProgram studio;
  Lines start = joined({kInContact, {dump("start.json")}});
  studio.play(start);
  const Json at = studio.state("start.json");
  const int last = at["simulation"]["step"];
  studio.play(joined({start,
                      {mouse("mouse_down", in_timeline(at, 200)),
                       kIdle,
                       mouse("mouse_move", in_timeline(at, 900)),
                       kIdle,
                       R"({"event": "mouse_up"})",
                       kIdle,
                       dump("dragged.json"),
                       press("Backwards"),
                       kIdle,
                       dump("backwards.json"),
                       key("Space"),
                       kIdle,
                       dump("paused.json"),
                       mouse("mouse_down", in_timeline(at, 1000), {"shift"}),
                       kIdle,
                       mouse("mouse_move", in_timeline(at, 1100)),
                       kIdle,
                       R"({"event": "mouse_up", "mods": ["shift"]})",
                       kIdle,
                       dump("marked.json"),
                       press("Replay"),
                       kIdle,
                       kIdle,
                       kIdle,
                       dump("loop1.json"),
                       kIdle,
                       kIdle,
                       dump("loop2.json"),
                       kIdle,
                       kIdle,
                       dump("loop3.json"),
                       R"({"do": "screenshot", "file": "loop.png"})"}}));
  const auto simulation = [&](const char* file) { return studio.state(file)["simulation"]; };
  EXPECT_NEAR(simulation("dragged.json")["step"].get<double>(), 900, 3);
  EXPECT_TRUE(simulation("dragged.json")["history"]["recorded"]);
  EXPECT_EQ(simulation("backwards.json")["history"]["replay"], -1);
  EXPECT_TRUE(simulation("backwards.json")["playing"]);
  EXPECT_LT(simulation("backwards.json")["step"], simulation("dragged.json")["step"]);
  EXPECT_EQ(simulation("paused.json")["history"]["replay"], 0);
  EXPECT_FALSE(simulation("paused.json")["playing"]);
  const Json loop = simulation("marked.json")["history"]["loop"];
  ASSERT_EQ(loop.size(), 2U);
  EXPECT_NEAR(loop[0].get<double>(), 1000, 3);
  EXPECT_NEAR(loop[1].get<double>(), 1100, 3);
  std::set<int> seen;
  for (const char* file : {"loop1.json", "loop2.json", "loop3.json"}) {
    const int step = simulation(file)["step"];
    seen.insert(step);
    EXPECT_GE(step, loop[0]);
    EXPECT_LE(step, loop[1]);
    EXPECT_EQ(simulation(file)["history"]["last"], last) << "nothing is simulated";
  }
  EXPECT_GT(seen.size(), 1U) << "it moves";
}

TEST(Time, GoesToEventsAndScrubsByAClickInThePlot) {
  const StudioProgram studio;
  studio.play(joined({kInContact,
                      {key("Left", kShift), kIdle, dump("one.json"), key("Right", kShift), kIdle,
                       R"({"event": "mouse_move", "at": {"widget": "Taxels over travel tab"}})", kIdle,
                       press("Taxels over travel tab"), kIdle, press("Plot"), kIdle, dump("plot.json")}}));
  const Json one = studio.state("one.json")["simulation"], plot = studio.state("plot.json")["simulation"];
  bool found = false;
  for (const Json& event : one["history"]["events"]) found = found || event["step"] == one["step"];
  EXPECT_TRUE(found) << one["history"].dump();
  EXPECT_TRUE(one["history"]["recorded"]);
  EXPECT_TRUE(plot["history"]["recorded"]);
  EXPECT_NEAR(plot["travel"].get<double>(), 0.012, 0.0015) << "the middle of the axis, about";
}

TEST(Time, StopsBeforeAnUnstableStepAndKeepsRecordedSteps) {
  const StudioProgram studio;
  write_text(studio.folder() / "unstable.xml", R"(<mujoco><option timestep="0.01" gravity="0 0 -9e9"/><worldbody>
    <body name="still"><geom type="box" size="0.1 0.1 0.1"/></body>
    <body name="stone" pos="0 0 1"><freejoint/><geom type="sphere" size="0.1" contype="0" conaffinity="0"/></body>
  </worldbody></mujoco>)");
  studio.play({kIdle, at_frame(90), dump("stopped.json"), key("Left"), kIdle, dump("back.json")}, {"unstable.xml"});
  const Json state = studio.state("stopped.json"), simulation = state["simulation"];
  EXPECT_NE(state["messages"].dump().find("body \\\"stone\\\""), std::string::npos) << state["messages"].dump();
  EXPECT_FALSE(simulation["playing"]);
  EXPECT_EQ(simulation["history"]["first"], 0);
  EXPECT_EQ(simulation["step"], simulation["history"]["last"]);
  EXPECT_GT(simulation["step"], 5);
  EXPECT_EQ(studio.state("back.json")["simulation"]["step"], simulation["step"].get<int>() - 1);
}

}  // namespace
}  // namespace taxel::test
