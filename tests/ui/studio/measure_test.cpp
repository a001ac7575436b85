// Measuring on the surface and the clip plane, through the real executable.
#include <gtest/gtest.h>

#include "core/mesh/mesh_io.h"
#include "core/mesh/query/closest_point.h"
#include "script_lines.h"

namespace taxel::test {
namespace {

std::string wheel(double notches, const std::string& at, const std::string& mods = "") {
  return R"({"event": "wheel", "y": )" + std::to_string(notches) + R"(, "at": )" + at + R"(, "mods": [)" + mods + "]}";
}

TEST(Measure, GivesBothDistancesOfTwoClicksAndSnapsToTaxels) {
  const StudioProgram studio;
  studio.play({kLayoutMode,
               kIdle,
               key("m"),
               kIdle,
               click(taxel(3)),
               kIdle,
               dump("one.json"),
               click(taxel(9)),
               kIdle,
               dump("two.json"),
               click("[600, 330]"),
               kIdle,
               click("[480, 130]"),
               kIdle,
               dump("third.json"),
               key("Esc"),
               kIdle,
               dump("ended.json"),
               click(taxel(3)),
               kIdle,
               dump("selected.json")},
              {kLayoutFile});
  const Json one = studio.state("one.json"), two = studio.state("two.json");
  ASSERT_EQ(one["measure"]["points"].size(), 1U);
  EXPECT_TRUE(one["measure"]["straight"].is_null());
  EXPECT_TRUE(one["selection"]["taxel"].is_null()) << "the click is the measure's";
  ASSERT_EQ(two["measure"]["points"].size(), 2U);
  EXPECT_EQ(two["measure"]["points"][0]["taxel"], 3);
  EXPECT_EQ(two["measure"]["points"][1]["taxel"], 9);
  const dvec3 a = vector_of(taxel_of(two["document"]["layout"], 3)["center"]),
              b = vector_of(taxel_of(two["document"]["layout"], 9)["center"]);
  const double straight = two["measure"]["straight"], along = two["measure"]["along"];
  EXPECT_NEAR(straight, glm::distance(a, b), 1e-12);
  EXPECT_GE(along, straight * (1 - 1e-6));
  EXPECT_LT(along, 2 * straight);
  const Json& path = two["measure"]["path"];
  const MeshIndex skin(load_mesh(kMeshFile).mesh);
  double length = 0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    length += glm::distance(vector_of(path[i - 1]), vector_of(path[i]));
    EXPECT_LT(skin.closest_point(0.5 * (vector_of(path[i - 1]) + vector_of(path[i]))).distance, 1e-9);
  }
  EXPECT_NEAR(length, along, 1e-9);
  EXPECT_LT(glm::distance(vector_of(path.front()), a), 1e-6);
  // A third click starts a new measurement. On the background there is no point.
  const Json third = studio.state("third.json")["measure"];
  EXPECT_EQ(third["points"].size(), 1U);
  EXPECT_TRUE(third["points"][0]["taxel"].is_null());
  EXPECT_TRUE(third["straight"].is_null());
  EXPECT_TRUE(studio.state("ended.json")["measure"].is_null());
  EXPECT_EQ(studio.state("ended.json")["history"]["depth"], 0);
  EXPECT_EQ(studio.state("selected.json")["selection"]["taxel"], 3);
}

/// Returns the distance by which a point is beyond the plane. A positive value means that the point is cut away.
double beyond(const Json& clip, const dvec3& p) {
  return glm::dot(vector_of(clip["normal"]), p) - clip["offset"].get<double>();
}

/// Returns the number of pixels of the view in which two images differ.
int differing(const Picture& a, const Picture& b, const Json& rect) {
  int count = 0;
  for (int y = static_cast<int>(rect[1]); y < static_cast<int>(rect[3]); ++y) {
    for (int x = static_cast<int>(rect[0]); x < static_cast<int>(rect[2]); ++x) {
      count += a.pixel(x, y) != b.pixel(x, y) ? 1 : 0;
    }
  }
  return count;
}

TEST(ClipPlane, IsToggledAndFlippedInTheMenu) {
  const StudioProgram studio;
  const std::string kMenu = click("[246, 12]"), kAway = R"({"event": "mouse_move", "at": [5, 795]})";
  const auto shot = [&](const std::string& name) {
    return Lines{kIdle, kAway, kIdle, R"({"do": "screenshot", "file": ")" + name + R"(.png"})", dump(name + ".json")};
  };
  studio.play(joined({{kLayoutMode, kIdle},
                      shot("whole"),
                      {kMenu, kIdle, press("View/Clip plane")},
                      shot("cut"),
                      {kMenu, kIdle, press("View/Flip the clip plane")},
                      shot("flipped"),
                      {kMenu, kIdle, press("View/Clip plane")},
                      shot("again")}),
              {kLayoutFile});
  const Json whole = studio.state("whole.json"), cut = studio.state("cut.json"), flipped = studio.state("flipped.json");
  const Json rect = whole["view"]["rect"];
  EXPECT_GT(differing(studio.picture("whole.png"), studio.picture("cut.png"), rect), 5000);
  EXPECT_GT(differing(studio.picture("cut.png"), studio.picture("flipped.png"), rect), 5000);
  EXPECT_EQ(differing(studio.picture("whole.png"), studio.picture("again.png"), rect), 0);
  EXPECT_EQ(flipped["clip"]["offset"], -cut["clip"]["offset"].get<double>());
  EXPECT_TRUE(studio.state("again.json")["clip"].is_null());
}

TEST(ClipPlane, PreventsPickingOfPartsThatAreCutAway) {
  const StudioProgram studio;
  // The whole sensor is cut away, so nothing can be selected or probed.
  studio.play(
      {kLayoutMode, kIdle, click(taxel(3)), kIdle, dump("before.json"), key("Esc"), kIdle,
       wheel(1, "[600, 330]", kShift), kIdle, dump("half.json"), click(taxel(3)), kIdle, dump("through.json"),
       wheel(60, "[600, 330]", kShift), kIdle, dump("all.json"), click("[600, 330]", kCtrl), kIdle, dump("none.json")},
      {kLayoutFile});
  const Json before = studio.state("before.json"), half = studio.state("half.json");
  EXPECT_EQ(before["selection"]["taxel"], 3);
  EXPECT_TRUE(before["clip"].is_null());
  ASSERT_TRUE(half["clip"].is_object());
  EXPECT_EQ(half["camera"], before["camera"]) << "no zoom";
  const dvec3 center = vector_of(taxel_of(half["document"]["layout"], 3)["center"]);
  EXPECT_GT(beyond(half["clip"], center), 0) << "it faces the eye";
  EXPECT_TRUE(studio.state("through.json")["selection"]["taxel"].is_null());
  const Json all = studio.state("all.json");
  EXPECT_EQ(all["clip"]["normal"], half["clip"]["normal"]);
  EXPECT_LT(all["clip"]["offset"], half["clip"]["offset"]);
  EXPECT_EQ(studio.state("none.json")["history"]["depth"], 0);
}

}  // namespace
}  // namespace taxel::test
