// The diagnosis of `taxel explain` on contacts with an artifact that is known by construction. A scene, or a scenario
// around a layout, is recorded, and the largest jump of the recording is explained.
#include <cmath>

#include "cli/taxel_program.h"
#include "fixtures/labelled_touches.h"
#include "fixtures/touch_files.h"

namespace taxel::test {
namespace {
namespace fs = std::filesystem;

/// Number of samples per square metre that causes no noise and is fast to make.
constexpr double kVerdictDensity = 1.5e6;

fs::path run_scene(Touch touch) {
  touch.layout.sampling.density = kVerdictDensity;
  const fs::path folder = test_folder();
  const double seconds = write_scene(folder, touch);
  const Json run =
      taxel_json({"run", "scene.xml", "--seconds", std::to_string(seconds), "--out", "run", "--quiet"}, folder);
  EXPECT_EQ(run["rows"], touch.path.size());
  return folder / "run";
}

fs::path play_path(Touch touch) {
  touch.layout.sampling.density = kVerdictDensity;
  const fs::path folder = test_folder();
  write_path(folder, touch);
  const Json run =
      taxel_json({"play", "scenario.json", "--layout", "skin.taxels.json", "--out", "run", "--quiet"}, folder);
  EXPECT_EQ(run["rows"], touch.path.size());
  return folder / "run";
}

double force_in(const Table& table, std::size_t row) {
  return std::hypot(table.at("force_x")[row], table.at("force_y")[row], table.at("force_z")[row]);
}

std::vector<std::string> explain_jump(const fs::path& run, const RecordedJump& jump) {
  return {"explain", run.string(), "--taxel", std::to_string(jump.taxel), "--time", std::to_string(jump.time)};
}

/// Expects this cause, the largest part of the change, and these words for the largest jump.
void expect_verdict(const fs::path& run, const std::string& cause, const std::string& words) {
  const RecordedJump jump = largest_jump(run);
  const Json found = taxel_json(explain_jump(run, jump)), &v = found["verdict"];
  ASSERT_TRUE(v.is_object()) << found.dump();
  EXPECT_EQ(v["cause"], cause) << v["text"];
  const std::string text = v["text"];
  EXPECT_EQ(text.rfind(words + ": ", 0), 0U) << text;
  const double change = v["change"], noise = v["noise"], field = v["field"], cone = v["cone"], contact = v["contact"],
               edges = v["edges"];
  EXPECT_EQ(change, jump.after - jump.before) << "as recorded";
  EXPECT_GT(std::abs(change), v["limit"].get<double>());
  EXPECT_NEAR(noise + field + cone + edges + contact, change, 1e-9 * std::abs(change));
  const bool star = cause == "star_field" || cause == "inverted_tets";
  const std::string largest = cause == "sampling_noise" ? "noise"
                              : cause == "mesh_edges"   ? "edges"
                              : star                    ? "field"
                                                        : "contact";
  for (const char* part : {"noise", "field", "cone", "edges", "contact"})
    EXPECT_LE(v[part].get<double>() / change, v[largest].get<double>() / change) << part;
  const Table table = read_csv(run / "readings.csv");
  const double before = force_in(table, jump.row - 1), now = force_in(table, jump.row);
  const bool stays = std::abs(now - before) <= 0.02 * std::max(before, now);
  EXPECT_EQ(v["force_stays"], stays);
  if (largest == "contact") {
    EXPECT_EQ(cause == "redistribution", stays);
  }
  // Whether the taxel's polygons are on inverted tets.
  bool inverted = false;
  for (const Json& polygon : found["polygons"]) inverted |= polygon["inverted"].get<bool>();
  EXPECT_EQ(inverted, cause == "inverted_tets");
}

/// Expects these words in the first line of the explanation as text.
void expect_first_line(const fs::path& run, const std::string& words) {
  const Outcome out = taxel(explain_jump(run, largest_jump(run)));
  EXPECT_EQ(out.status, 0);
  EXPECT_EQ(out.err, "");
  EXPECT_EQ(out.out.rfind(words + ": the reading ", 0), 0U) << out.out.substr(0, 200);
}

TEST(Verdict, IsTheFieldForABallThatTapsAnEggOnAStar) {
  const fs::path run = run_scene(taps_on_egg(0.004, 0.0018));
  expect_verdict(run, "star_field", "Pressure field");
  expect_first_line(run, "Pressure field");
}
TEST(Verdict, IsTheFieldForAFingertipOnAStarThatTapsABall) {
  expect_verdict(play_path(taps_on_fingertip(0.005, 0.0018)), "star_field", "Pressure field");
}

TEST(Verdict, IsInvertedTetsForABallThatTapsInsideATorus) {
  const fs::path run = run_scene(taps_on_torus(0.016, 0.006, 133, 0.0035));
  expect_verdict(run, "inverted_tets", "Inverted tets");
  expect_first_line(run, "Inverted tets");
}
TEST(Verdict, IsInvertedTetsForABentFingerThatTapsABall) {
  expect_verdict(play_path(taps_in_hook(0.9, 0.0035, 0.0018)), "inverted_tets", "Inverted tets");
}

TEST(Verdict, IsRedistributionForABallMovedAlongAFinger) {
  const fs::path run = run_scene(led_along(0.003, 0.0005));
  expect_verdict(run, "redistribution", "Redistribution");
  expect_first_line(run, "Redistribution");
}
TEST(Verdict, IsRedistributionForAFingerMovedAlongABall) {
  expect_verdict(play_path(led_along(0.005, 0.0006)), "redistribution", "Redistribution");
}

TEST(Verdict, IsTheContactForAnEdgeThatMovesOverAFinger) {
  const fs::path run = run_scene(edge_comes({1, 0, 0, 0}, dvec3(0.0162, 0, -0.018), dvec3(0, 0, 0.0007)));
  expect_verdict(run, "contact", "The contact itself");
  expect_first_line(run, "The contact itself");
}
TEST(Verdict, IsTheContactForAnEggMovedOverAnEdge) {
  expect_verdict(play_path(edge_comes_over_egg(0.68)), "contact", "The contact itself");
}

TEST(Verdict, IsMeshEdgesForABallThatMovesOverARoof) {
  const fs::path run = run_scene(over_roof(60, 0.001));
  expect_verdict(run, "mesh_edges", "Mesh edges");
  expect_first_line(run, "Mesh edges");
  const Json v = taxel_json(explain_jump(run, largest_jump(run)))["verdict"];
  EXPECT_NEAR(v["crossed_edges"][0]["bend_deg"].get<double>(), 60, 1e-3);
  EXPECT_NEAR(v["crossed_edges"][0]["distance"].get<double>(), 0.0003, 1e-5);
  EXPECT_FALSE(v["tried"].empty());
}

// The diagnosis of noise names a number of samples. With this number the same step is no jump.
TEST(Verdict, NamesASampleCountThatCuresTheNoise) {
  Touch touch = few_samples(7e5, 3);
  const fs::path folder = test_folder();
  const std::string seconds = std::to_string(write_scene(folder, touch));
  const auto run = [&](const char* out) {
    taxel_json({"run", "scene.xml", "--seconds", seconds, "--out", out, "--quiet"}, folder);
    return folder / out;
  };
  const fs::path few = run("few");
  expect_verdict(few, "sampling_noise", "Sampling noise");
  const RecordedJump jump = largest_jump(few);
  const Json noisy = taxel_json(explain_jump(few, jump)), &needed = noisy["verdict"]["samples_needed"],
             &strip = noisy["convergence"];
  ASSERT_TRUE(needed.is_object());
  ASSERT_TRUE(needed["cures"].get<bool>());
  EXPECT_EQ(needed["samples"], strip["samples"][2]);
  EXPECT_NEAR(needed["factor"].get<double>(), strip["factors"][2].get<double>(), 0.01) << "samples are whole";
  touch.layout.sampling.density *= strip["factors"][2].get<double>();
  write_skin(folder, touch);
  const Json cured = taxel_json(explain_jump(run("enough"), jump));
  EXPECT_EQ(cured["verdict"]["cause"], "none") << cured["verdict"]["text"];
  EXPECT_EQ(cured["reading"], strip["values"][2]) << "as the diagnosis predicted";
  EXPECT_EQ(cured["change"]["before"], strip["values_before"][2]);
}

// A ball on the same path as above, but slow: nothing jumps.
TEST(Verdict, IsNoneForABallMovedSlowly) {
  const fs::path run = run_scene(smooth(FieldKind::star));
  const RecordedJump jump = largest_jump(run);
  const Json v = taxel_json(explain_jump(run, jump))["verdict"];
  EXPECT_EQ(v["cause"], "none");
  EXPECT_EQ(v["change"].get<double>(), jump.after - jump.before);
  EXPECT_LT(std::abs(jump.after - jump.before), v["limit"].get<double>());
  EXPECT_EQ(v["text"].get<std::string>().rfind("No jump: ", 0), 0U) << v["text"];
}

}  // namespace
}  // namespace taxel::test
