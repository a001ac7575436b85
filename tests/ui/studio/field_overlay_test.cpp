// Overlays of receptive fields through the real executable: the numbers of their legends and the pixels that they
// paint.
#include <gtest/gtest.h>

#include <cmath>

#include "studio_program.h"

namespace taxel::test {
namespace {

const std::string kIdle = R"({"do": "wait_idle"})";

/// Returns the script of a fingertip layout with one overlay switched on in addition to the skin.
std::vector<std::string> with_overlay(const std::string& label, const std::string& picture) {
  std::vector<std::string> script{R"({"event": "key", "key": "Space"})",
                                  R"({"event": "key", "key": "1", "mods": ["ctrl"]})", kIdle};
  for (const char* shown : {"Samples", "Taxels", "Fields"}) {
    script.push_back(R"({"event": "click", "at": {"widget": "Toolbar/)" + std::string(shown) + R"("}})");
    script.push_back(kIdle);
  }
  const std::vector<std::string> rest{
      R"({"event": "click", "at": [246, 12]})",  // the menu: the view itself is named View as well
      kIdle,
      R"({"event": "click", "at": {"widget": "View/Taxels and fields"}})",
      kIdle,
      R"({"event": "click", "at": {"widget": ")" + label + R"("}})",
      kIdle,
      R"({"event": "mouse_move", "at": [5, 795]})",
      kIdle,
      R"({"do": "screenshot", "file": ")" + picture + R"(.png"})",
      R"({"do": "dump_state", "file": "state.json"})"};
  script.insert(script.end(), rest.begin(), rest.end());
  return script;
}

/// Returns the number of pixels of the view whose colour (0 to 1) is within a few levels of `color`.
int count_pixels(const Picture& picture, const Json& rect, const std::array<double, 3>& color, int tolerance) {
  int count = 0;
  for (int y = static_cast<int>(rect[1]); y < static_cast<int>(rect[3]); ++y) {
    for (int x = static_cast<int>(rect[0]); x < static_cast<int>(rect[2]); ++x) {
      const auto pixel = picture.pixel(x, y);
      bool same = true;
      for (std::size_t k = 0; k < 3; ++k) same = same && std::abs(pixel[k] - 255 * color[k]) <= tolerance;
      count += same ? 1 : 0;
    }
  }
  return count;
}

constexpr std::array<double, 3> kEuclideanOnly{0.90, 0.16, 0.45};

/// Numbers of bright pixels of the view by their hue: skin without taxels is warm, and covered skin is blue.
struct CoveragePixels {
  int warm = 0, blue = 0;
};
CoveragePixels coverage_pixels(const Picture& picture, const Json& rect) {
  CoveragePixels count;
  for (int y = static_cast<int>(rect[1]); y < static_cast<int>(rect[3]); ++y) {
    for (int x = static_cast<int>(rect[0]); x < static_cast<int>(rect[2]); ++x) {
      const auto pixel = picture.pixel(x, y);
      if (pixel[0] + pixel[1] + pixel[2] < 260) continue;
      count.warm += pixel[0] > 1.1 * pixel[2] ? 1 : 0;
      count.blue += pixel[0] < 0.85 * pixel[2] ? 1 : 0;
    }
  }
  return count;
}

TEST(FieldOverlays, PaintUncoveredSkinAndAddUpCoverage) {
  const StudioProgram studio;
  studio.play(with_overlay("Coverage and overlap", "coverage"));
  const Json state = studio.state("state.json");
  const Json& coverage = state["fields"]["coverage"];
  double sum = 0;
  for (const Json& area : coverage["area_of_overlap"]) sum += area.get<double>();
  const double skin = coverage["area"];
  EXPECT_NEAR(sum, skin, 1e-9 * skin);
  // The samples give the same areas: used samples over all samples, within the noise of their spread.
  EXPECT_NEAR(coverage["area_of_overlap"][0].get<double>() / skin, 0.553, 0.01);
  EXPECT_GT(coverage["overlap"], 1);
  const CoveragePixels pixels = coverage_pixels(studio.picture("coverage.png"), state["view"]["rect"]);
  EXPECT_GT(pixels.warm, 5000);
  EXPECT_GT(pixels.blue, 3000);
  EXPECT_TRUE(state["fields"]["comparison"].is_null());
}

TEST(FieldOverlays, PaintTheDifferenceOfTheMetrics) {
  const StudioProgram studio;
  studio.play(with_overlay("Receptive fields: Euclidean vs. geodesic", "comparison"));
  const Json state = studio.state("state.json");
  const Json& comparison = state["fields"]["comparison"];
  const double straight = comparison["euclidean"], geodesic = comparison["geodesic"],
               only = comparison["euclidean_only"];
  EXPECT_GT(only, 0);
  EXPECT_NEAR(straight, geodesic + only, 1e-3 * straight);  // no path is shorter than the straight line
  EXPECT_GT(count_pixels(studio.picture("comparison.png"), state["view"]["rect"], kEuclideanOnly, 45), 100);
}

TEST(FieldOverlays, CompareTaxelNormalsWithTheNormalsOfTheSkin) {
  const StudioProgram studio;
  studio.play(with_overlay("Normal deviation", "normals"));
  const Json normals = studio.state("state.json")["fields"]["normals"];
  EXPECT_GT(normals["largest_deg"], normals["mean_deg"]);
  EXPECT_LT(normals["largest_deg"], 8) << "smooth normals on facets";
  EXPECT_EQ(normals["limit_deg"], 45);
}

}  // namespace
}  // namespace taxel::test
