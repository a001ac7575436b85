// The demo at the start: its camera, its loop over the contact, and its end when the user pauses.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "script_lines.h"

namespace taxel::test {
namespace {

std::string until(double time) {
  return R"({"do": "wait_time", "time": )" + std::to_string(time) + "}";
}

std::string wait_for(const std::string& pointer, const std::string& condition) {
  return R"({"do": "wait_for", "pointer": ")" + pointer + R"(", )" + condition + "}";
}

const std::vector<std::string> kDemo{"--demo"};
/// Waits for the loop, whose first round begins before the touch.
const std::string kLoops = wait_for("/simulation/history/replay", R"("equals": 1)");
const std::string kRoundBegins = wait_for("/simulation/time", R"("most": 0.2)");
/// Waits until a recorded step at this time or later is displayed [s].
std::string shows(double time) {
  return wait_for("/simulation/time", R"("least": )" + std::to_string(time));
}

/// The demo presses deepest after this time, in the middle of its sweep [s].
constexpr double kPeak = 0.72;

double azimuth(const Json& state) {
  return state["camera"]["azimuth_deg"].get<double>();
}

const Json& demo_of(const Json& state) {
  return state["simulation"]["history"]["demo"];
}

int polygons_of(const Json& state) {
  return state["simulation"]["sensors"][0]["polygons"].get<int>();
}

/// Returns the least distance of the image of the contact from a line [pixel].
double distance_from_contact(const Json& state, const Json& line) {
  const dvec2 a(line[0][0], line[0][1]), b(line[1][0], line[1][1]);
  double least = 1e9;
  for (const Json& polygon : state["polygons"]) {
    const dvec2 p(polygon["pixel"][0], polygon["pixel"][1]);
    const double along = std::clamp(glm::dot(p - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
    least = std::min(least, glm::distance(p, glm::mix(a, b, along)));
  }
  return least;
}

/// Returns the distance of the image of the centre of pressure from the middle of the view, in heights of the view.
double distance_from_middle(const Json& state) {
  dvec2 sum(0);
  double forces = 0;
  for (const Json& polygon : state["polygons"]) {
    const double force = polygon["pressure"].get<double>() * polygon["area"].get<double>();
    sum += force * dvec2(polygon["pixel"][0], polygon["pixel"][1]);
    forces += force;
  }
  const Json& view = state["view"]["rect"];
  const dvec2 lo(view[0], view[1]), hi(view[2], view[3]);
  return glm::distance(sum / forces, 0.5 * (lo + hi)) / (hi.y - lo.y);
}

/// Returns the largest distance of the contact from the camera's target, in heights of the view, `seconds` after the
/// touch. The target follows as a first-order lag: behind a point with a constant speed it is speed times time
/// constant, and the point moves on for one frame until it is drawn. The contact is at most as fast as the finger,
/// whose sweep has 10 mm/s. The distance at the touch, at most that of the sweep's begin from the edge, decays with the
/// time constant.
double largest_lag(const Json& state, double seconds) {
  constexpr double kSweepSpeed = 0.01, kTimeConstant = 0.2, kFrame = 0.02;  // [m/s], [s], [s]
  constexpr double kDistanceFromEdge = 0.0055;                              // [m]
  const double speed = kSweepSpeed * state["simulation"]["speed"].get<double>();
  const Json& camera = state["camera"];
  const double height =
      2 * camera["distance"].get<double>() * std::tan(0.5 * glm::radians(camera["fov_deg"].get<double>()));
  return (speed * (kTimeConstant + kFrame) + kDistanceFromEdge * std::exp(-seconds / kTimeConstant)) / height;
}

TEST(Demo, ShowsTheContactLargeWithItsForceNextToIt) {
  for (const char* size : {"800x600", "1280x800", "1920x1080"}) {
    const StudioProgram studio;
    studio.play({kIdle, until(kPeak), dump("peak.json")}, {"--demo", "--size", size});
    const Json peak = studio.state("peak.json");
    EXPECT_GE(peak["contact"]["part_of_view"].get<double>(), 0.04) << size;
    for (const Json& polygon : peak["polygons"]) EXPECT_TRUE(polygon["inside"]) << size;
    ASSERT_EQ(peak["contact"]["arrows"].size(), 1U);
    EXPECT_GT(distance_from_contact(peak, peak["contact"]["arrows"][0]), 6) << "half of the arrow's width, " << size;
  }
}

TEST(Demo, SwaysTheCameraAroundTheContactAndFollowsIt) {
  const StudioProgram studio;
  constexpr double kTouch = 0.1, kEarly = 0.5, kLate = 0.8;  // times of the run [s]
  studio.play({kIdle, until(kEarly), dump("early.json"), kLoops, kRoundBegins, shows(kLate), dump("late.json")}, kDemo);
  const Json early = studio.state("early.json"), late = studio.state("late.json");
  EXPECT_TRUE(demo_of(early)["runs"]);
  EXPECT_GT(std::abs(azimuth(late) - azimuth(early)), 5);
  for (const auto& [state, seconds] : {std::pair(early, kEarly - kTouch), {late, (kLate - kTouch) / 0.25}}) {
    ASSERT_GT(polygons_of(state), 0);
    EXPECT_LT(distance_from_middle(state), largest_lag(state, seconds)) << "the contact is in the middle";
  }
}

TEST(Demo, RepeatsItsContactSlowly) {
  const StudioProgram studio;
  studio.play({kIdle, kLoops, kRoundBegins, shows(0.3), dump("once.json"), kRoundBegins, dump("again.json")}, kDemo);
  const Json once = studio.state("once.json")["simulation"], again = studio.state("again.json")["simulation"];
  EXPECT_EQ(once["speed"], 0.25);
  EXPECT_EQ(again["history"]["replay"], 1) << "another round";
  const auto first = once["history"]["loop"][0].get<double>(), last = once["history"]["loop"][1].get<double>();
  double begins = -1, ends = -1;
  for (const Json& event : once["history"]["events"]) {
    const auto has = [&](const char* what) {
      return std::find(event["what"].begin(), event["what"].end(), what) != event["what"].end();
    };
    if (has("contact_begins") && begins < 0) begins = event["step"].get<double>();
    if (has("contact_ends")) ends = event["step"].get<double>();
  }
  ASSERT_GT(begins, 0);
  EXPECT_GE((ends - begins) / (last - first), 0.8) << "in contact for most of its time";
  constexpr double kStepsPerMm = 100;  // 10 mm/s in steps of 1 ms
  EXPECT_NEAR(begins - first, kStepsPerMm, 2);
  EXPECT_NEAR(last - ends, kStepsPerMm, 2);
}

TEST(Demo, LoopsOverTheContactOfALongerSweep) {
  const StudioProgram studio;
  studio.play({kIdle, kLoops, dump("loop.json")},
              {"--demo", "--scenario", TAXEL_SOURCE_DIR "/tests/fixtures/edge_sweep.json"});
  const Json history = studio.state("loop.json")["simulation"]["history"];
  EXPECT_GT(history["loop"][0], 1500);
  EXPECT_LT(history["loop"][1], 3500);
  EXPECT_GT(history["last"], 4000) << "its whole run is kept";
}

std::string mouse(const std::string& event, const std::string& more = "") {
  return R"({"event": ")" + event + R"(", "at": {"view": [0.3, 0.4]})" + more + "}";
}

/// A first input of a user: its name, and its lines.
struct FirstInput {
  std::string name;
  Lines lines;
};

std::vector<FirstInput> first_inputs() {
  std::vector<FirstInput> inputs{
      {"click", {mouse("click")}},
      {"right click", {mouse("click", R"(, "button": "right")")}},
      {"middle click", {mouse("click", R"(, "button": "middle")")}},
      {"double click", {mouse("double_click")}},
      {"click on the contact", {R"({"event": "click", "at": {"view": [0.5, 0.5]}})"}},
      {"wheel", {mouse("wheel", R"(, "y": 2)")}},
      {"drag",
       {mouse("mouse_down"), R"({"event": "mouse_move", "at": {"view": [0.4, 0.5]}})", R"({"event": "mouse_up"})"}},
      {"click on a bar", {press("X-ray")}},
      {"menu", {press("View"), kIdle, key("Esc")}},
  };
  for (const char* name : {"T", "C", "W", "Y", "Home", ".", "F1", "F2", "A", "Esc"})
    inputs.push_back({name, {key(name)}});
  inputs.push_back({"Space", {key("Space")}});
  return inputs;
}

TEST(Demo, StaysInContactAfterAnyFirstInput) {
  const std::vector<FirstInput> inputs = first_inputs();
  ASSERT_EQ(inputs.size(), 20U);
  for (const FirstInput& input : inputs) {
    const StudioProgram studio;
    studio.play(joined({{kIdle, until(kPeak), dump("before.json")}, input.lines, {kIdle, kIdle, dump("after.json")}}),
                kDemo);
    const Json before = studio.state("before.json"), after = studio.state("after.json");
    ASSERT_GT(polygons_of(before), 0);
    EXPECT_GT(polygons_of(after), 0) << input.name;
    const bool pauses = input.name == "Space";
    EXPECT_EQ(after["simulation"]["playing"], !pauses) << input.name;
    if (!pauses) {
      EXPECT_TRUE(demo_of(after)["runs"]) << input.name;
    }
  }
}

TEST(Demo, LeavesTheCameraToTheUserAndPlaysOn) {
  const StudioProgram studio;
  studio.play({kIdle, until(0.3), R"({"event": "mouse_move", "at": [300, 300]})", until(0.35), dump("moved.json"),
               until(0.45), dump("swayed.json"), mouse("click"), until(0.6), dump("clicked.json"), kLoops, kRoundBegins,
               shows(0.5), dump("loops.json")},
              kDemo);
  EXPECT_NE(studio.state("moved.json")["camera"], studio.state("swayed.json")["camera"]) << "the pointer only moved";
  const Json clicked = studio.state("clicked.json"), loops = studio.state("loops.json");
  EXPECT_EQ(clicked["camera"], loops["camera"]) << "the camera rests";
  EXPECT_TRUE(loops["simulation"]["playing"]);
  EXPECT_GT(polygons_of(loops), 0);
}

TEST(Demo, EndsAtTheStepThatIsShown) {
  const StudioProgram studio;
  studio.play({kIdle, kLoops, kRoundBegins, shows(0.5), key("Space"), kIdle, dump("paused.json"), kIdle, kIdle,
               dump("later.json")},
              kDemo);
  const Json paused = studio.state("paused.json"), later = studio.state("later.json");
  EXPECT_GT(polygons_of(paused), 0);
  EXPECT_EQ(paused["simulation"]["step"], later["simulation"]["step"]);
  EXPECT_FALSE(later["simulation"]["playing"]);
  EXPECT_FALSE(demo_of(later)["runs"]);
  EXPECT_TRUE(later["simulation"]["history"]["loop"].is_null());
  EXPECT_EQ(later["simulation"]["speed"], 1) << "that of the user";
}

TEST(Demo, IsNotPlayedInAScriptUnlessItIsAskedFor) {
  const StudioProgram studio;
  studio.play({kIdle, until(0.2), dump("plain.json")});
  EXPECT_FALSE(demo_of(studio.state("plain.json"))["runs"]);
}

TEST(Demo, IsRefusedForAFile) {
  const Outcome outcome = StudioProgram().run({}, {"--demo", kLayoutFile});
  EXPECT_EQ(outcome.status, 2);
}

}  // namespace
}  // namespace taxel::test
