// The Explain panel through the program: a clicked bar is explained, polygons can be selected in view, table and
// scatter plot, and `taxel explain` gives the same result.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "script_lines.h"

namespace taxel::test {
namespace {

/// Returns our fingertip with few samples, whose readings jump.
std::vector<std::string> coarse_layout(const StudioProgram& studio) {
  Json layout = Json::parse(file_text(kLayoutFile));
  layout["mesh"]["file"] = kMeshFile;
  layout["sampling"]["density"] = 5e5;
  write_text(studio.folder() / "coarse.taxels.json", layout.dump());
  return {"coarse.taxels.json"};
}

std::string middle_of(const Json& rect) {
  return Json({0.5 * (rect[0].get<double>() + rect[2].get<double>()),
               0.5 * (rect[1].get<double>() + rect[3].get<double>())})
      .dump();
}
const Json* bar_of(const Json& state, int id) {
  for (const Json& bar : state["bars"])
    if (bar["taxel"] == id) return &bar;
  return nullptr;
}

const Lines kExplain{key("e"), kIdle, kIdle, dump("explained.json")};
/// Paused at the step in which a taxel jumped by 1 %, and explained.
const Lines kJumped = joined({{press("Tracks"), kIdle, key("="), key("="), press("Jump"), key("a", kCtrl), type("1"),
                               key("Enter"), key("b", kShift), R"({"frame": 200, "do": "wait_idle"})"},
                              kExplain});
/// Paused in the middle of the contact, and explained.
const Lines kInContact = joined({{key("="), key("="), wait_time(1.3), key("Space"), kIdle}, kExplain});

TEST(Explain, ExplainsTheTaxelThatJumpedAtTheStepOfTheJump) {
  const StudioProgram studio;
  studio.play(kJumped, coarse_layout(studio));
  const Json state = studio.state("explained.json"), &stop = state["simulation"]["history"]["stop"];
  ASSERT_TRUE(stop.is_object()) << state["simulation"]["history"].dump();
  const Json& found = state["explain"];
  ASSERT_TRUE(found.is_object());
  EXPECT_EQ(found["taxel"]["id"], stop["taxel"]);
  EXPECT_EQ(found["step"], stop["step"]);
  EXPECT_EQ(found["step_before"].get<int>(), stop["step"].get<int>() - 1);
  EXPECT_EQ(found["reading"], stop["after"]);
  EXPECT_EQ(found["change"]["before"], stop["before"]);
  EXPECT_NE(found["verdict"]["cause"], "none");
  EXPECT_NEAR(std::abs(found["verdict"]["change"].get<double>()) / found["verdict"]["limit"].get<double>(),
              stop["part"].get<double>() / 0.01, 1e-9)
      << "the limit is the breakpoint's";
  EXPECT_TRUE(found["ghost"].get<bool>());
  EXPECT_EQ(state["selection"]["taxel"], stop["taxel"]);
}

TEST(Explain, LeadsFromNoJumpToTheLargestChangeOfTheRun) {
  const StudioProgram studio;
  studio.play(joined({kInContact, {press("Largest change of the run"), kIdle, kIdle, dump("largest.json")}}),
              coarse_layout(studio));
  const Json here = studio.state("explained.json"), largest = studio.state("largest.json");
  ASSERT_EQ(here["explain"]["verdict"]["cause"], "none");
  EXPECT_EQ(largest["mode"], "analyse");
  EXPECT_TRUE(largest["plot"]["close_up"].is_object());
  EXPECT_LT(largest["explain"]["step"], here["explain"]["step"]) << "an earlier step of the run";
  EXPECT_GT(std::abs(largest["explain"]["verdict"]["change"].get<double>()),
            std::abs(here["explain"]["verdict"]["change"].get<double>()));
}

TEST(Explain, FollowsAClickedBarAndScrubbing) {
  const StudioProgram studio;
  const auto layout = coarse_layout(studio);
  const Lines start{key("="), key("="), wait_time(1.3), key("Space"), kIdle, dump("plain.json")};
  studio.play(start, layout);
  const Json plain = studio.state("plain.json");
  EXPECT_TRUE(plain["explain"].is_null());
  const Json* bar = bar_of(plain, 4);
  ASSERT_NE(bar, nullptr);
  studio.play(joined({start,
                      {click(middle_of((*bar)["rect"])), key("e"), kIdle, kIdle, dump("bar.json"), key("Left"), kIdle,
                       kIdle, dump("back.json"), key("e"), key("Right"), kIdle, kIdle, dump("again.json")}}),
              layout);
  const Json at = studio.state("bar.json"), back = studio.state("back.json"), again = studio.state("again.json");
  EXPECT_EQ(at["explain"]["taxel"]["id"], 4);
  EXPECT_EQ(at["explain"]["reading"], at["simulation"]["readings"][4]);
  EXPECT_EQ(back["explain"]["step"].get<int>(), at["explain"]["step"].get<int>() - 1);
  EXPECT_EQ(back["explain"]["reading"], at["explain"]["change"]["before"]);
  EXPECT_EQ(again["explain"], at["explain"]) << "the same step is explained the same";
}

TEST(Explain, SelectsAPolygonInTheViewAndInTheTable) {
  const StudioProgram studio;
  std::vector<std::string> layout = coarse_layout(studio);
  layout.insert(layout.begin(), {"--size", "1400x2100"});  // tall enough to show the table
  studio.play(kInContact, layout);
  const Json state = studio.state("explained.json");
  const Json* target = nullptr;
  for (const Json& polygon : state["polygons"])
    if (polygon["inside"].get<bool>() && polygon["facing"].get<bool>() &&
        (target == nullptr || polygon["area"] > (*target)["area"]))
      target = &polygon;
  ASSERT_NE(target, nullptr) << state["polygons"].dump().substr(0, 400);
  studio.play(joined({kInContact,
                      {click((*target)["pixel"].dump()), kIdle, dump("view.json"),
                       R"({"do": "screenshot", "file": "v.png"})"}}),
              layout);
  const Json view = studio.state("view.json");
  ASSERT_TRUE(view["explain"]["selected_polygon"].is_array());
  EXPECT_EQ(view["selection"], state["selection"]) << "the taxel stays";
  // The displayed values of the panel: area and pressures, share of the force, tet, taxels.
  int rows = 0;
  for (const Json& p : view["explain"]["polygons"]) {
    if (Json{p["surface"], p["polygon"]} != view["explain"]["selected_polygon"]) continue;
    ++rows;
    EXPECT_NEAR(p["area"].get<double>(), (*target)["area"].get<double>(), 1e-12 * p["area"].get<double>());
    EXPECT_LE(p["lowest_pressure"], (*target)["pressure"]);
    EXPECT_GE(p["highest_pressure"], (*target)["pressure"]);
    EXPECT_GT(p["force_share"], 0);
    EXPECT_GE(p["tet"], 0);
  }
  EXPECT_EQ(rows, 1) << "the selected polygon is a row of the table";
  const Json row = view["explain"]["polygons"][0];
  const std::string label = "Polygon " + std::to_string(row["surface"].get<int>()) + "/";
  std::string first;
  for (const Json& widget : view["widgets"])
    if (first.empty() && widget["label"].get<std::string>().rfind(label, 0) == 0) first = widget["label"];
  ASSERT_FALSE(first.empty());
  studio.play(joined({kInContact,
                      {press(first), kIdle, dump("table.json"), key("Left"), kIdle, kIdle, dump("stepped.json"),
                       R"({"event": "wheel", "at": {"view": [1.1, 0.9]}, "y": -99})", kIdle, kIdle, dump("below.json"),
                       R"({"do": "screenshot", "file": "below.png"})"}}),
              layout);
  const Json selected = studio.state("table.json")["explain"]["selected_polygon"];
  EXPECT_EQ("Polygon " + std::to_string(selected[0].get<int>()) + "/" + std::to_string(selected[1].get<int>()), first);
  EXPECT_TRUE(studio.state("stepped.json")["explain"]["selected_polygon"].is_null()) << "numbers are of one step";
  // All parts of the panel must be visible, at the top or after scrolling.
  std::set<std::string> parts;
  for (const char* file : {"stepped.json", "below.json"}) {
    const Json shown = studio.state(file);
    for (const Json& widget : shown["widgets"])
      if (widget["panel"] == "Explain") parts.insert(widget["label"]);
  }
  for (const char* part : {"Verdict", "Onion skin (previous step)", "Exact and sampled", "Change since the step before",
                           "Convergence plot", "Scatter", "Samples caption", "Force budget"})
    EXPECT_TRUE(parts.count(part) > 0) << part;
}

TEST(Explain, SelectsThePolygonOfAClickedScatterDot) {
  const StudioProgram studio;
  std::vector<std::string> layout = coarse_layout(studio);
  layout.insert(layout.begin(), {"--size", "1400x1900"});  // tall enough to show the whole panel
  studio.play(kInContact, layout);
  const Json state = studio.state("explained.json");
  const Json* plot = nullptr;
  for (const Json& widget : state["widgets"])
    if (widget["label"] == "Scatter dots") plot = &widget["rect"];
  ASSERT_NE(plot, nullptr);
  const Json& polygons = state["explain"]["polygons"];
  ASSERT_GT(polygons.size(), 20U);
  double area = 0, mean = 0;
  for (const Json& p : polygons) {
    area = std::max(area, p["area"].get<double>());
    mean = std::max(mean, p["mean_pressure"].get<double>());
  }
  // The axes end a little above the largest value.
  const auto pixel = [&](const Json& p) {
    const double u = p["area"].get<double>() / (1.08 * area), v = p["mean_pressure"].get<double>() / (1.08 * mean);
    const double x0 = (*plot)[0], y0 = (*plot)[1], x1 = (*plot)[2], y1 = (*plot)[3];
    return dvec2(x0 + u * (x1 - x0), y1 - v * (y1 - y0));
  };
  // Select the dot that is farthest from all others. The contact is symmetric, and many polygons have a mirror image.
  const auto same = [](const Json& p, const Json& q) {
    return std::abs(p["area"].get<double>() / q["area"].get<double>() - 1) < 1e-6 &&
           std::abs(p["mean_pressure"].get<double>() / q["mean_pressure"].get<double>() - 1) < 1e-6;
  };
  const Json* alone = nullptr;
  double farthest = 0;
  for (const Json& p : polygons) {
    double nearest = 1e9;
    for (const Json& q : polygons)
      if (!same(p, q)) nearest = std::min(nearest, glm::distance(pixel(p), pixel(q)));
    if (nearest > farthest) farthest = nearest, alone = &p;
  }
  ASSERT_GT(farthest, 2) << "pixels";
  const auto at = [](const dvec2& p) { return Json({p.x, p.y}).dump(); };
  studio.play(joined({kInContact,
                      {click(at(pixel(*alone) + dvec2(0.3, -0.3))), kIdle, dump("dot.json"),
                       R"({"do": "screenshot", "file": "dot.png"})"}}),
              layout);
  const Json dot = studio.state("dot.json");
  const Json chosen = dot["explain"]["selected_polygon"];
  ASSERT_TRUE(chosen.is_array());
  bool is_dot = false;
  for (const Json& p : polygons) {
    if (p["surface"] == chosen[0] && p["polygon"] == chosen[1]) {
      is_dot = true;
      EXPECT_TRUE(same(p, *alone)) << p.dump() << alone->dump();
    }
  }
  EXPECT_TRUE(is_dot) << "the selected polygon has a dot";
  EXPECT_EQ(dot["selection"], state["selection"]) << "the taxel stays";
  EXPECT_EQ(dot["simulation"]["step"], state["simulation"]["step"]);
}

TEST(Explain, HidesTheGhostByAToggle) {
  const StudioProgram studio;
  const auto shot = [](const char* name) { return std::string(R"({"do": "screenshot", "file": ")") + name + R"("})"; };
  studio.play(joined({kInContact,
                      {shot("with.png"), press("Onion skin (previous step)"), kIdle, kIdle, dump("without.json"),
                       shot("without.png")}}),
              coarse_layout(studio));
  const Json state = studio.state("without.json"), &view = state["view"]["rect"];
  EXPECT_TRUE(studio.state("explained.json")["explain"]["ghost"].get<bool>());
  EXPECT_FALSE(state["explain"]["ghost"].get<bool>());
  const Picture with = studio.picture("with.png"), without = studio.picture("without.png");
  int changed = 0;
  for (double y = view[1]; y < view[3]; ++y)
    for (double x = view[0]; x < view[2]; ++x) changed += with.pixel(x, y) != without.pixel(x, y) ? 1 : 0;
  EXPECT_GT(changed, 100) << "its lines are in the view";
}

#ifdef TAXEL_PROGRAM
// A recording of every step, explained by the command line, gives the same object to the last digit. A jump is measured
// against the largest recorded reading, so the window runs on and returns to the step with the largest change.
TEST(Explain, GivesTheSameResultAsTheCommandLine) {
  const StudioProgram studio;
  const auto jump_of = [](const char* percent) {
    return Lines{press("Jump"), key("a", kCtrl), type(percent), key("Enter"), kIdle};
  };
  studio.play(joined({kJumped,
                      {key("b", kShift), kIdle},
                      jump_of("0.5"),
                      {key("Space"), wait_time(1.5), key("Space"), kIdle, press("Largest change of the run"), kIdle,
                       kIdle, dump("explained.json")}}),
              coarse_layout(studio));
  Json window = studio.state("explained.json")["explain"];
  ASSERT_TRUE(window.is_object());
  const Outcome swept = run_program(TAXEL_PROGRAM,
                                    {"sweep", "--layout", "coarse.taxels.json", "--object", "box", "--past", "0.004",
                                     "--record-every", "0.00001", "--out", "run", "--quiet"},
                                    studio.folder());
  ASSERT_EQ(swept.status, 0) << swept.err;
  const Outcome said =
      run_program(TAXEL_PROGRAM,
                  {"explain", "run", "--taxel", std::to_string(window["taxel"]["id"].get<int>()), "--time",
                   std::to_string(window["time"].get<double>()), "--jump", "0.005", "--json"},
                  studio.folder());
  ASSERT_EQ(said.status, 0) << said.err;
  EXPECT_NE(window["verdict"]["cause"], "none");
  for (const char* own : {"step", "step_before", "ghost", "selected_polygon"}) window.erase(own);
  EXPECT_EQ(Json::parse(said.out), window);
}
#endif

}  // namespace
}  // namespace taxel::test
