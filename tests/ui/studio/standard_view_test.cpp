// Orthographic and standard views by keys.
#include <gtest/gtest.h>

#include "script_lines.h"

namespace taxel::test {
namespace {

TEST(StandardView, IsTakenByKeysWithAndWithoutANumberPad) {
  const StudioProgram studio;
  const std::string kAlt = R"("alt")", kAltShift = R"("alt", "shift")";
  const std::vector<std::array<std::string, 4>> rows{{"1", kAlt, "Keypad1", ""}, {"1", kAltShift, "Keypad1", kCtrl},
                                                     {"3", kAlt, "Keypad3", ""}, {"3", kAltShift, "Keypad3", kCtrl},
                                                     {"7", kAlt, "Keypad7", ""}, {"7", kAltShift, "Keypad7", kCtrl}};
  const std::vector<std::array<double, 2>> azimuth_and_elevation{{-90, 0}, {90, 0},   {0, 0},
                                                                 {180, 0}, {-90, 90}, {-90, -90}};
  Lines lines{kIdle};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto& [digit, mods, pad, pad_mods] = rows[i];
    const std::string n = std::to_string(i);
    lines.insert(lines.end(), {key(digit, mods), kIdle, dump("digit" + n + ".json"), key("Home"), key("a", kCtrl),
                               kIdle, key(pad, pad_mods), kIdle, dump("pad" + n + ".json")});
  }
  studio.play(lines);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (const std::string from : {"digit", "pad"}) {
      const Json camera = studio.state(from + std::to_string(i) + ".json")["camera"];
      EXPECT_NEAR(std::remainder(camera["azimuth_deg"].get<double>() - azimuth_and_elevation[i][0], 360), 0, 1e-12)
          << from << i;
      EXPECT_EQ(camera["elevation_deg"], azimuth_and_elevation[i][1]) << from << i;
    }
  }
}

TEST(Orthographic, KeepsTheTargetInPlaceAndPicksTheSameTaxel) {
  const StudioProgram studio;
  studio.play({kIdle, kLayoutMode, kIdle, dump("perspective.json"), key("5", R"("alt")"), kIdle, click(taxel(4)), kIdle,
               dump("parallel.json"), R"({"do": "screenshot", "file": "parallel.png"})", key("Keypad5"), kIdle,
               dump("back.json")},
              {kLayoutFile});
  const Json perspective = studio.state("perspective.json"), parallel = studio.state("parallel.json");
  EXPECT_FALSE(perspective["camera"]["orthographic"]);
  EXPECT_TRUE(parallel["camera"]["orthographic"]);
  EXPECT_EQ(parallel["camera"]["target"], perspective["camera"]["target"]);
  EXPECT_EQ(parallel["camera"]["distance"], perspective["camera"]["distance"]);
  EXPECT_EQ(parallel["selection"]["taxel"], 4) << "the click at its pixel selects it";
  EXPECT_EQ(studio.state("back.json")["camera"], perspective["camera"]);
}

}  // namespace
}  // namespace taxel::test
