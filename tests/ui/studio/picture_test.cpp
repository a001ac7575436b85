// Images show the numbers: bars, polygons and samples have the pixels of their values.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <sstream>

#include "studio_program.h"

namespace taxel::test {
namespace {

const std::string kPicture = R"({"do": "screenshot", "file": "picture.png"})";
const std::string kDump = R"({"do": "dump_state", "file": "state.json"})";

std::string toggle(const std::string& label) {
  return R"({"event": "click", "at": {"widget": "Toolbar/)" + label + R"("}})";
}
std::string idle() {
  return R"({"do": "wait_idle"})";
}

/// Four times as fast, 80 steps per frame, until shortly before the frame under test.
const std::string kFaster = R"({"event": "key", "key": "="})", kSlower = R"({"event": "key", "key": "-"})";

/// Returns the script of the sweep at 1.2 s, paused, after a click on each named switch of the toolbar.
std::vector<std::string> at_mid_sweep(const std::vector<std::string>& to_switch_off) {
  std::vector<std::string> script{kFaster, kFaster, R"({"do": "wait_time", "time": 1.2})",
                                  R"({"event": "key", "key": "Space"})", idle()};
  for (const std::string& label : to_switch_off) {
    script.push_back(toggle(label));
    script.push_back(idle());
  }
  script.push_back(R"({"event": "mouse_move", "at": [5, 5]})");  // no tooltip over the view
  script.insert(script.end(), {idle(), kPicture, kDump});
  return script;
}

/// Expects the legend's numbers in kPa to increase evenly over the range, from bottom to top.
void expect_legend_of_range(const Json& state) {
  std::vector<double> shown, places;
  for (const Json& widget : state["widgets"]) {
    if (widget["panel"] != "Pressure legend") continue;
    shown.push_back(std::stod(widget["label"].get<std::string>()));
    places.push_back(widget["rect"][1]);
  }
  ASSERT_GE(shown.size(), 2U);
  const double lo = state["range"]["least"], hi = state["range"]["largest"];
  ASSERT_GT(hi, 1000) << "Pa";
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(shown.size() - 1);
    EXPECT_NEAR(1e3 * shown[i], lo + part * (hi - lo), 1e-3 * hi) << "number " << i;
    EXPECT_NEAR(places[i], places.front() + part * (places.back() - places.front()), 1.5) << "number " << i;
  }
  EXPECT_LT(places.back(), places.front());
}

TEST(Bars, HaveTheHeightAndTheColourOfTheReadings) {
  const StudioProgram studio;
  studio.play(at_mid_sweep({}));
  const Json state = studio.state("state.json");
  const Picture picture = studio.picture("picture.png");
  expect_legend_of_range(state);
  const Json& bars = state["bars"];
  const Json& readings = state["simulation"]["readings"];
  ASSERT_EQ(bars.size(), readings.size());
  int risen = 0;
  for (std::size_t i = 0; i < bars.size(); ++i) {
    EXPECT_EQ(bars[i]["value"], readings[i]);
    const double top = bars[i]["top"], axis = bars[i]["axis_height"], height = bars[i]["height"];
    EXPECT_NEAR(height, axis * readings[i].get<double>() / top, 0.01);
    if (height < 4) continue;
    ++risen;
    const Json& rect = bars[i]["rect"];
    const double middle = 0.5 * (rect[0].get<double>() + rect[2].get<double>());
    const auto inside = picture.pixel(middle, rect[3].get<double>() - 0.5 * height);
    const auto above = picture.pixel(middle, rect[1].get<double>() - 6);
    EXPECT_NE(inside, above) << "taxel " << bars[i]["taxel"];
    EXPECT_LE(color_distance(inside, bars[i]["color"]), 2) << "the colour of its taxel";
    EXPECT_EQ(inside, picture.pixel(middle, rect[1].get<double>() + 3)) << "filled up to its top";
  }
  EXPECT_GE(risen, 2);
}

/// Returns the rows of readings.csv by step (1 ms each).
std::map<int, std::vector<double>> sweep_rows(const std::filesystem::path& csv) {
  std::map<int, std::vector<double>> rows;
  std::istringstream text(file_text(csv));
  std::string line;
  std::getline(text, line);
  while (std::getline(text, line)) {
    std::vector<double> values;
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) values.push_back(std::stod(cell));
    rows[static_cast<int>(std::lround(1e3 * values[0]))] = values;
  }
  return rows;
}

TEST(Bars, EqualTheReadingsOfTheCommandLine) {
#ifdef TAXEL_PROGRAM
  const StudioProgram studio;
  const Outcome sweep =
      run_program(TAXEL_PROGRAM, {"sweep", "--object", "box", "--out", "sweep", "--quiet"}, studio.folder());
  ASSERT_EQ(sweep.status, 0) << sweep.err;
  const auto rows = sweep_rows(studio.folder() / "sweep" / "readings.csv");
  std::vector<std::string> script;
  for (int k = 0; k < 12; ++k) {  // stop somewhere in the contact, then step to the next row
    if (k == 0)
      script.insert(script.end(),
                    {kFaster, kFaster, R"({"do": "wait_time", "time": 1.1})", R"({"event": "key", "key": "Space"})"});
    script.push_back(R"({"event": "key", "key": "Right"})");
    script.push_back(idle());
    script.push_back(R"({"do": "dump_state", "file": "step)" + std::to_string(k) + R"(.json"})");
  }
  studio.play(script);
  int compared = 0;
  for (int k = 0; k < 12; ++k) {
    const Json state = studio.state("step" + std::to_string(k) + ".json");
    const auto row = rows.find(static_cast<int>(std::lround(1e3 * state["simulation"]["time"].get<double>())));
    if (row == rows.end()) continue;
    ++compared;
    const std::vector<double> expected(row->second.end() - 12, row->second.end());
    std::vector<double> bars;
    for (const Json& bar : state["bars"]) bars.push_back(bar["value"]);
    EXPECT_EQ(bars, expected) << "to the last digit";
  }
  EXPECT_GE(compared, 1);
#else
  GTEST_SKIP() << "the command line is not built";
#endif
}

/// Returns the fraction of the glyphs that face the eye within the view and have their colour in the image.
double right_colour(const Picture& picture, const Json& marks, bool facing_only, int tolerance, int& looked_at) {
  int right = 0;
  looked_at = 0;
  for (const Json& mark : marks) {
    if (!mark["inside"].get<bool>() || (facing_only && !mark["facing"].get<bool>())) continue;
    ++looked_at;
    right += color_distance(picture.pixel(mark["pixel"][0], mark["pixel"][1]), mark["color"]) <= tolerance ? 1 : 0;
  }
  return looked_at > 0 ? static_cast<double>(right) / looked_at : 0.0;
}

/// Turns the view so that the contact is seen from above and fills it. The pressure changes little within a pixel.
std::vector<std::string> close_up(std::vector<std::string> script) {
  // Without the timeline there is room for all rows of the table, and for the contact.
  const std::vector<std::string> gestures{R"({"event": "click", "at": {"widget": "Panels"}})",
                                          idle(),
                                          R"({"event": "click", "at": {"widget": "Panels/Timeline"}})",
                                          idle(),
                                          R"({"event": "click", "at": {"widget": "Taxel 10"}})",
                                          idle(),
                                          R"({"event": "key", "key": "."})",
                                          idle(),
                                          R"({"event": "mouse_down", "at": [500, 300]})",
                                          idle(),
                                          R"({"event": "mouse_move", "at": [520, 320]})",
                                          idle(),
                                          R"({"event": "mouse_move", "at": [520, 420]})",
                                          idle(),
                                          R"({"event": "mouse_up"})",
                                          idle()};
  script.insert(script.begin() + 5, gestures.begin(), gestures.end());
  return script;
}

TEST(ContactSurface, DrawsAPolygonInTheColourOfItsPressure) {
  const StudioProgram studio;
  studio.play(close_up(at_mid_sweep({"Rays", "Taxels", "Fields", "Path"})));
  const Json state = studio.state("state.json");
  int looked_at = 0;
  const double right = right_colour(studio.picture("picture.png"), state["polygons"], false, 4, looked_at);
  EXPECT_GT(looked_at, 30);
  EXPECT_GT(right, 0.75) << "the force arrow hides some";
}

TEST(Samples, HaveTheColourOfTheirTaxel) {
  const StudioProgram studio;
  studio.play(at_mid_sweep({"Rays", "Contact", "Taxels", "Fields", "Path", "Samples"}));
  const Json state = studio.state("state.json");
  int looked_at = 0;
  const double right = right_colour(studio.picture("picture.png"), state["samples"], true, 2, looked_at);
  EXPECT_GT(looked_at, 50);
  EXPECT_GT(right, 0.85) << "discs of neighbouring taxels overlap at their border";
}

TEST(Picture, HasTheSameColourForTheSamePressureInTwoFrames) {
  const StudioProgram studio;
  auto script = close_up(at_mid_sweep({"Rays", "Taxels", "Fields", "Path"}));
  script.insert(script.end(),
                {R"({"event": "click", "at": {"widget": "Range"}})", idle(), R"({"event": "key", "key": "Space"})",
                 R"({"do": "wait_time", "time": 1.6})", R"({"event": "key", "key": "Space"})", idle(),
                 R"({"event": "mouse_move", "at": [5, 5]})", idle(), R"({"do": "screenshot", "file": "second.png"})",
                 R"({"do": "dump_state", "file": "second.json"})"});
  studio.play(script);
  const Json first = studio.state("state.json"), second = studio.state("second.json");
  EXPECT_FALSE(second["range"]["automatic"]);
  EXPECT_EQ(first["range"]["largest"], second["range"]["largest"]);
  int looked_at = 0;
  EXPECT_GT(right_colour(studio.picture("second.png"), second["polygons"], false, 4, looked_at), 0.75);
}

TEST(Picture, HasTheSameBytesForTheSameScript) {
  const StudioProgram studio;
  const std::vector<std::string> script{R"({"frame": 5, "event": "click", "at": {"taxel": 11}})",
                                        R"({"frame": 6, "event": "mouse_down", "at": [600, 300]})",
                                        R"({"frame": 8, "event": "mouse_move", "at": [660, 320]})",
                                        R"({"frame": 9, "event": "mouse_up"})",
                                        kFaster,
                                        kFaster,
                                        R"({"do": "wait_time", "time": 1.0})",
                                        kPicture};
  studio.play(script);
  const std::string first = file_text(studio.folder() / "picture.png");
  studio.play(script);
  EXPECT_EQ(first, file_text(studio.folder() / "picture.png"));
}

/// Returns a state of the window without measured times.
Json state_without_times(const StudioProgram& studio, const std::string& file) {
  Json state = studio.state(file);
  for (const char* measured : {"pace", "profile"}) state.erase(measured);
  return state;
}

TEST(Picture, IsTheSameIfOnlySavedFramesAreDrawn) {
  const std::vector<std::string> script{kPicture,
                                        R"({"frame": 5, "event": "click", "at": {"taxel": 11}})",
                                        R"({"frame": 6, "event": "mouse_down", "at": [600, 300]})",
                                        R"({"frame": 8, "event": "mouse_move", "at": [660, 320]})",
                                        R"({"frame": 9, "event": "mouse_up"})",
                                        kFaster,
                                        R"({"do": "wait_time", "time": 0.9})",
                                        R"({"do": "screenshot", "file": "second.png"})",
                                        kDump};
  std::vector<std::array<std::string, 2>> pictures;
  std::vector<Json> states;
  for (const DrawnFrames drawn : {DrawnFrames::all, DrawnFrames::saved}) {
    const StudioProgram studio(drawn);
    studio.play(script);
    pictures.push_back({file_text(studio.folder() / "picture.png"), file_text(studio.folder() / "second.png")});
    states.push_back(state_without_times(studio, "state.json"));
  }
  EXPECT_TRUE(pictures[0][0] == pictures[1][0]);
  EXPECT_TRUE(pictures[0][1] == pictures[1][1]);
  EXPECT_FALSE(pictures[0][0] == pictures[0][1]);
  EXPECT_EQ(Json::diff(states[0], states[1]).dump(), "[]");
}

TEST(Picture, IsDrawnManyTimesPerSecondWhileTheContactMoves) {
  const StudioProgram studio(DrawnFrames::all);
  studio.play({kFaster, kFaster, R"({"do": "wait_time", "time": 0.88})", kSlower, kSlower, idle(), kDump,
               R"({"do": "wait_time", "time": 1.7})", R"({"do": "dump_state", "file": "moving.json"})"});
  const Json pace = studio.state("moving.json")["pace"];
  EXPECT_EQ(pace["pictures"], pace["scene_draws"]) << "each picture showed another contact";
  RecordProperty("frames_per_second", std::to_string(pace["frames_per_second"].get<double>()));
  std::printf("%.1f pictures per second at 1280 x 800 while the contact moves, 20 simulation steps each\n",
              pace["frames_per_second"].get<double>());
  EXPECT_GT(pace["frames_per_second"], 2) << "far below what any machine should reach";
}

}  // namespace
}  // namespace taxel::test
