// The brush, the painted region and the lasso: raw events in, the document out.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "core/mesh/mesh_io.h"
#include "core/mesh/surface_brush.h"
#include "script_lines.h"

namespace taxel::test {
namespace {

std::string pixel(double x, double y) {
  std::string text("[");
  return text.append(std::to_string(x)).append(", ").append(std::to_string(y)).append("]");
}
std::string down(const std::string& at, const std::string& mods = "") {
  return R"({"event": "mouse_down", "at": )" + at + R"(, "mods": [)" + mods + "]}";
}
std::string move_to(const std::string& at) {
  return R"({"event": "mouse_move", "at": )" + at + "}";
}
/// Returns a mouse release with the modifiers that were pressed since the button went down.
std::string up(const std::string& mods = "") {
  return R"({"event": "mouse_up", "mods": [)" + mods + "]}";
}

/// Returns a drag from one pixel of the window to another in ten frames. The button stays down.
Lines drawn(const dvec2& from, const dvec2& to, const std::string& mods = "") {
  Lines lines{down(pixel(from.x, from.y), mods), kIdle};
  for (int i = 1; i <= 10; ++i) {
    const dvec2 at = glm::mix(from, to, i / 10.0);
    lines.insert(lines.end(), {move_to(pixel(at.x, at.y)), kIdle});
  }
  return lines;
}

std::vector<int> region(const Json& state) {
  return state["region"].get<std::vector<int>>();
}

TEST(Brush, PaintsTheFacesUnderAStrokeAsOneStep) {
  const StudioProgram studio;
  studio.play(joined({{kIdle, dump("before.json"), R"({"do": "screenshot", "file": "before.png"})", key("q"), kIdle},
                      drawn({590, 330}, {610, 420}),
                      {up(), kIdle, dump("painted.json"), key("Esc"), kIdle, move_to(pixel(420, 120)), kIdle,
                       R"({"do": "screenshot", "file": "painted.png"})", key("z", kCtrl), kIdle, dump("undone.json"),
                       key("y", kCtrl), kIdle, dump("redone.json")}}),
              {kMeshFile});
  const Json painted = studio.state("painted.json");
  EXPECT_EQ(painted["tool"]["name"], "brush");
  const std::vector<int> faces = region(painted);
  EXPECT_GT(faces.size(), 20U);
  EXPECT_TRUE(std::is_sorted(faces.begin(), faces.end()));
  EXPECT_EQ(painted["history"]["depth"], 1);
  EXPECT_EQ(painted["history"]["undo"], "Undo Paint the region");
  EXPECT_EQ(painted["camera"], studio.state("before.json")["camera"]);
  EXPECT_EQ(region(studio.state("undone.json")), std::vector<int>());
  EXPECT_EQ(region(studio.state("redone.json")), faces);
  // Samples are placed only in the painted region.
  const auto samples = [&](const char* state) { return studio.state(state)["document"]["samples"].get<int>(); };
  EXPECT_EQ(samples("undone.json"), samples("before.json"));
  EXPECT_EQ(samples("redone.json"), samples("painted.json"));
  const TriMesh mesh = *load_mesh(kMeshFile).mesh;
  const double part = area_of_faces(mesh, faces) / mesh.area();
  EXPECT_NEAR(samples("painted.json"), part * samples("before.json"), 1.0);
  // The stroke tints the region and nothing outside it.
  const Picture was = studio.picture("before.png"), is = studio.picture("painted.png");
  const auto difference = [&](double x, double y) {
    int largest = 0;
    for (std::size_t c = 0; c < 3; ++c) largest = std::max(largest, std::abs(was.pixel(x, y)[c] - is.pixel(x, y)[c]));
    return largest;
  };
  EXPECT_GT(difference(593, 345), 15);
  EXPECT_GT(difference(607, 405), 15);
  EXPECT_EQ(difference(420, 120), 0);
}

TEST(Brush, ReportsTaxelsThatGetNoSample) {
  const StudioProgram studio;
  studio.play(joined({{kLayoutMode, kIdle, dump("before.json"), key("q"), kIdle},
                      drawn({590, 330}, {610, 420}),
                      {up(), kIdle, dump("painted.json")}}),
              {kLayoutFile});
  const auto told = [&](const char* state) {
    std::set<std::string> where;
    const Json problems = studio.state(state)["problems"];
    for (const Json& problem : problems)
      if (problem["code"] == "field_without_samples") where.insert(problem["pointer"]);
    return where;
  };
  EXPECT_EQ(told("before.json"), std::set<std::string>{});
  const std::set<std::string> without = told("painted.json");
  EXPECT_TRUE(without.contains("/taxels/4")) << "at the tip";
  EXPECT_FALSE(without.contains("/taxels/0")) << "painted";
}

TEST(Brush, ErasesResizesAndIsCancelled) {
  const StudioProgram studio;
  studio.play(joined({{kIdle, key("q"), kIdle},
                      drawn({590, 330}, {610, 420}),
                      {up(), kIdle, dump("painted.json")},
                      drawn({590, 330}, {600, 375}, kShift),
                      {up(kShift), kIdle, dump("erased.json")},
                      drawn({590, 330}, {600, 375}),
                      {dump("during.json"), key("Esc"), kIdle, up(), kIdle, dump("cancelled.json")},
                      {key("q"), kIdle, click(pixel(560, 420)), kIdle, dump("dot.json"), key("z", kCtrl), kIdle},
                      {R"({"event": "wheel", "at": )" + pixel(560, 420) + R"(, "y": 5})", kIdle, click(pixel(560, 420)),
                       kIdle, dump("larger.json")}}),
              {kMeshFile});
  const std::vector<int> painted = region(studio.state("painted.json")), erased = region(studio.state("erased.json"));
  EXPECT_LT(erased.size(), painted.size());
  EXPECT_FALSE(erased.empty());
  EXPECT_EQ(without_faces(erased, painted), std::vector<int>()) << "nothing new";
  EXPECT_EQ(studio.state("erased.json")["history"]["depth"], 2);
  EXPECT_GT(region(studio.state("during.json")).size(), erased.size());
  EXPECT_EQ(region(studio.state("cancelled.json")), erased);
  EXPECT_EQ(studio.state("cancelled.json")["history"]["depth"], 2);
  const std::size_t dot = region(studio.state("dot.json")).size() - erased.size();
  const std::size_t larger = region(studio.state("larger.json")).size() - erased.size();
  EXPECT_GT(dot, 0U);
  EXPECT_GT(larger, 3 * dot / 2) << "five notches make the radius 1.6 times as large";
  EXPECT_EQ(studio.state("larger.json")["camera"], studio.state("painted.json")["camera"])
      << "the wheel is the brush's";
}

TEST(Brush, ChangesTheWholeRegionByButtons) {
  const StudioProgram studio;
  studio.play(
      joined({{kIdle, key("q"), kIdle, dump("card.json"), press("Brush/All"), kIdle, dump("all.json")},
              drawn({590, 330}, {610, 420}, kCtrl),
              {up(kCtrl), kIdle, dump("most.json"), press("Brush/Invert"), kIdle, dump("inverted.json"),
               press("Brush/Clear"), kIdle, dump("clear.json"), press("Brush/Done"), kIdle, dump("done.json")}}),
      {kMeshFile});
  const TriMesh mesh = *load_mesh(kMeshFile).mesh;
  EXPECT_EQ(region(studio.state("all.json")).size(), static_cast<std::size_t>(mesh.face_count()));
  const std::vector<int> most = region(studio.state("most.json")), rest = region(studio.state("inverted.json"));
  EXPECT_FALSE(rest.empty());
  EXPECT_EQ(most.size() + rest.size(), static_cast<std::size_t>(mesh.face_count()));
  EXPECT_EQ(without_faces(rest, most), rest) << "no face in both";
  EXPECT_TRUE(region(studio.state("clear.json")).empty());
  EXPECT_EQ(studio.state("clear.json")["history"]["depth"], 4);
  EXPECT_EQ(studio.state("done.json")["tool"]["name"], "none");
}

TEST(Lasso, SelectsTheTaxelsInsideIt) {
  const StudioProgram studio;
  studio.play({kLayoutMode, kIdle, dump("before.json")}, {kLayoutFile});
  const Json before = studio.state("before.json");
  // A diamond around taxel 3. Other taxels inside the diamond are selected as well.
  dvec2 middle(0);
  for (const Json& mark : before["taxels"])
    if (mark["id"] == 3) middle = {mark["pixel"][0].get<double>(), mark["pixel"][1].get<double>()};
  constexpr double kArm = 45;
  std::vector<int> expected;
  for (const Json& mark : before["taxels"]) {
    const dvec2 p{mark["pixel"][0].get<double>(), mark["pixel"][1].get<double>()};
    if (std::abs(p.x - middle.x) + std::abs(p.y - middle.y) < kArm - 3) expected.push_back(mark["id"]);
  }
  ASSERT_FALSE(expected.empty());
  const auto corner = [&](double x, double y) { return middle + kArm * dvec2(x, y); };
  const auto around = [&](const std::string& mods) {
    Lines lines = drawn(corner(0, -1), corner(1, 0), mods);
    for (const dvec2& to : {corner(0, 1), corner(-1, 0), corner(0, -1)})
      lines.insert(lines.end(), {move_to(pixel(to.x, to.y)), kIdle});
    lines.insert(lines.end(), {up(mods), kIdle});
    return lines;
  };
  studio.play(joined({{kLayoutMode, kIdle, key("b", kShift), kIdle, dump("tool.json")},
                      around(""),
                      {dump("selected.json"), key("a"), kIdle, key("b", kShift), kIdle},
                      around(kCtrl),
                      {dump("taken_out.json"), key("b", kShift), kIdle},
                      drawn(corner(0, -1), corner(1, 0)),
                      {key("Esc"), kIdle, up(), kIdle, dump("cancelled.json")}}),
              {kLayoutFile});
  EXPECT_EQ(studio.state("tool.json")["tool"]["name"], "lasso");
  const Json selected = studio.state("selected.json");
  std::vector<int> ids = selected["selection"]["taxels"];
  std::sort(ids.begin(), ids.end());
  EXPECT_EQ(ids, expected);
  EXPECT_EQ(selected["tool"]["name"], "none");
  EXPECT_EQ(selected["camera"], before["camera"]);
  EXPECT_EQ(studio.state("taken_out.json")["selection"]["taxels"].size(), 12U - expected.size());
  EXPECT_EQ(studio.state("cancelled.json")["selection"], studio.state("taken_out.json")["selection"]);
}

}  // namespace
}  // namespace taxel::test
