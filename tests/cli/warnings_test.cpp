// Runs with a useless result warn, and numbers that are not finite are refused.
#include "cli/taxel_program.h"

namespace taxel::test {
namespace {
namespace fs = std::filesystem;

Json press(double depth) {
  return {{"kind", "press"},  {"hold", 0},      {"clearance", 0.0002}, {"tilt_deg", 20},
          {"shape", "plate"}, {"depth", depth}, {"speed", 1}};
}

TEST(Warnings, NameDepthsBeyondThePad) {
  const fs::path folder = test_folder();
  const auto warning_of = [&](double depth) {
    write_text(folder / "press.json", press(depth).dump());
    const Outcome outcome = taxel({"play", "press.json", "--density", "1e5"}, folder);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return outcome.err;
  };
  EXPECT_EQ(warning_of(0.001).find("/depth"), std::string::npos);
  EXPECT_NE(warning_of(0.005).find("/depth: 0.005 m is deeper than the pad is thick, 0.002 m"), std::string::npos);
  EXPECT_NE(warning_of(1).find("/depth: 1 m is deeper than the sensor is thick"), std::string::npos);
}

TEST(Warnings, NameTheFirstDepthOfAStudyBeyondThePad) {
  const fs::path folder = test_folder();
  write_text(folder / "study.json", Json{{"format", "taxel-study"},
                                         {"version", 1},
                                         {"scenario", press(0.001)},
                                         {"parameters", {{{"parameter", "depth"}, {"values", {0.001, 0.003, 0.004}}}}}}
                                        .dump());
  const Outcome outcome = taxel({"study", "study.json", "--density", "1e5"}, folder);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const std::size_t first = outcome.err.find("/depth: 0.003 m is deeper than the pad");
  EXPECT_NE(first, std::string::npos) << outcome.err;
  EXPECT_EQ(outcome.err.find("/depth", first + 1), std::string::npos) << outcome.err;
}

TEST(Warnings, NameRunsWithoutContact) {
  const fs::path folder = test_folder();
  Json miss = press(0.001);
  miss["place"] = 1;
  write_text(folder / "miss.json", miss.dump());
  const Outcome outcome = taxel({"play", "miss.json", "--density", "1e5"}, folder);
  EXPECT_NE(outcome.err.find("finger: touches nothing in any"), std::string::npos) << outcome.err;
}

TEST(Limits, RefuseModuliAboveThoseOfMatter) {
  const fs::path folder = test_folder();
  const fs::path layout =
      changed_layout(folder, Json::array({{{"op", "add"}, {"path", "/material/modulus"}, {"value", 1e308}}}));
  expect_refusal(taxel({"sweep", "--layout", layout.string()}, folder),
                 "taxel: " + layout.string() + ": /material/modulus: must be at most 1e+15 Pa, is 1e+308");
  write_text(folder / "case.json", R"({"format": "contact-case", "version": 1, "a": {"shape": {"type": "sphere",
    "size": [0.05]}, "material": {"modulus": 1e308}, "pos": [0, 0, 0.0475]}, "b": {"shape": {"type": "plane"}}})");
  expect_refusal(taxel({"contact", "case.json"}, folder),
                 "taxel: case.json: /a/material/modulus: must be at most 1e+15 Pa, is 1e+308");
}

TEST(Limits, RefuseForcesThatAreNotFinite) {
  const fs::path folder = test_folder();
  write_text(folder / "case.json", R"({"format": "contact-case", "version": 1, "a": {"shape": {"type": "sphere",
    "size": [0.05]}, "material": {"modulus": 5e4, "dissipation": 1}, "pos": [0, 0, 0.0475],
    "linear_velocity": [0, 0, -1e308]}, "b": {"shape": {"type": "plane"}, "linear_velocity": [0, 0, 1e308]}})");
  expect_refusal(taxel({"contact", "case.json"}, folder),
                 "taxel: case.json: the contact force is not finite: a velocity, dissipation or size is too large");
}

TEST(Limits, RefuseBoxesWithTooManyTaxels) {
  const fs::path folder = test_folder();
  write_text(folder / "box.xml", R"(<mujoco><custom><numeric name="cs::box" data="1e5 0 0.01 0.5 0.5"/>
    <numeric name="cs::ball" data="0 0 0.01 0.5 0.5"/></custom>
    <worldbody><geom name="box" type="box" size="1000 1000 1"/><body pos="0 0 1.05"><freejoint/>
    <geom name="ball" size="0.1"/></body></worldbody></mujoco>)");
  const Outcome outcome = taxel({"run", "box.xml", "--seconds", "0.01"}, folder);
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.err.find("a box of 2000 m by 2000 m would get 6.4e+09 taxels, one for each 0.025 m, at most 4096"),
            std::string::npos)
      << outcome.err;
}

}  // namespace
}  // namespace taxel::test
