// `taxel fit`: a table of presses that the program itself made gives its numbers back; a real strip of barometers is
// described within the bounds of docs/user_guide.md, and permuted taxels and a narrower field are not.
#include <sstream>

#include "cli/taxel_program.h"

namespace taxel::test {
namespace {
namespace fs = std::filesystem;

/// Writes a plate of 120 x 40 x 12 mm whose top is z = 0, three taxels 6 mm apart on it with the ids 1 to 3, and a
/// ball that touches it.
void write_strip(const fs::path& folder, double ball = 0.0037) {
  std::ostringstream mesh;
  for (int i = 0; i < 8; ++i)
    mesh << "v " << ((i & 1) != 0 ? 0.06 : -0.06) << " " << ((i & 2) != 0 ? 0.02 : -0.02) << " "
         << ((i & 4) != 0 ? 0.0 : -0.012) << "\n";
  mesh
      << "f 1 3 4\nf 1 4 2\nf 5 6 8\nf 5 8 7\nf 1 2 6\nf 1 6 5\nf 3 7 8\nf 3 8 4\nf 1 5 7\nf 1 7 3\nf 2 4 8\nf 2 8 6\n";
  write_text(folder / "strip.obj", mesh.str());
  Json taxels = Json::array();
  for (int k = 1; k <= 3; ++k)
    taxels.push_back({{"id", k}, {"center", {0.006 * (k - 2), 0, 0}}, {"normal", {0, 0, 1}}, {"radius", 0.006}});
  const Json layout{{"format", "taxel-layout"},
                    {"version", 1},
                    {"mesh", {{"file", "strip.obj"}}},
                    {"frame", {{"distal", {1, 0, 0}}, {"pad", {0, 0, 1}}}},
                    {"sampling", {{"density", 1e6}}},
                    {"readout", {{"aggregate", "weighted_mean"}, {"method", "exact"}}},
                    {"material", {{"field", "pad"}, {"modulus", 1e5}, {"thickness", 0.005}}},
                    {"taxels", taxels}};
  write_text(folder / "strip.taxels.json", layout.dump());
  const Json ball_case{{"format", "contact-case"},
                       {"version", 1},
                       {"a", {{"layout", "strip.taxels.json"}}},
                       {"b", {{"shape", {{"type", "sphere"}, {"size", {ball}}}}, {"pos", {0, 0, ball}}}}};
  write_text(folder / "ball.json", ball_case.dump());
}

/// Returns presses of the ball as `taxel read` reads them: values are 2 * reading + 1000, x counts micrometres and
/// depth 480 steps a millimetre into the skin from 0.2 mm above it.
std::string table_of_presses(const fs::path& folder) {
  std::ostringstream poses, table;
  std::vector<std::pair<int, int>> at;
  for (int x = -14; x <= 14; x += 2)
    for (const int depth : {0, 0, 60, 120, 240, 360, 480, 600, 300, 0}) at.emplace_back(1000 * x, depth);
  poses << "x [mm],y,z [mm],qw,qx,qy,qz\n";
  for (const auto& [x, depth] : at) poses << 1e-3 * x << ",0," << 3.7 + 0.2 - depth / 480.0 << ",1,0,0,0\n";
  write_text(folder / "poses.csv", poses.str());
  const Outcome read = taxel(
      {"read", "strip.taxels.json", "ball.json", "--poses", "poses.csv", "--out", "readings.csv", "--quiet"}, folder);
  EXPECT_EQ(read.status, 0) << read.err;
  const Table readings = read_csv(folder / "readings.csv");
  table << "Sensor_1,Sensor_2,Sensor_3,x,depth\n";
  table.precision(12);
  for (std::size_t i = 0; i < at.size(); ++i) {
    for (const char* taxel : {"taxel_1", "taxel_2", "taxel_3"}) table << 1000 + 2 * readings.at(taxel)[i] << ",";
    table << at[i].first + 700 << "," << at[i].second << "\n";
  }
  return table.str();
}

std::vector<std::string> fit_arguments(const std::vector<std::string>& more) {
  std::vector<std::string> arguments{"fit",    "presses.csv", "--layout", "strip.taxels.json",
                                     "--case", "ball.json",   "--pose",   "x=1 um,z=depth*-(1/480) mm"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

TEST(Fit, FindsTheZerosAndGainsOfPressesAndWritesItsFiles) {
  const fs::path folder = test_folder();
  write_strip(folder);
  write_text(folder / "presses.csv", table_of_presses(folder));
  const Json fit = taxel_json(fit_arguments({"--free", "x0,z0,gain", "--out", "fit"}), folder);
  ASSERT_EQ(fit["free"].size(), 2U);
  EXPECT_NEAR(fit["free"][0]["value"].get<double>(), -0.0007, 2e-6) << "x0";
  EXPECT_NEAR(fit["free"][1]["value"].get<double>(), 0.0002, 2e-6) << "z0";
  const Json& run = fit["runs"][0];
  EXPECT_EQ(run["presses"], 15);
  EXPECT_GT(run["r2"].get<double>(), 0.99999);
  for (const Json& taxel : run["taxels"]) {
    EXPECT_NEAR(taxel["gain"].get<double>(), 2, 0.005);
    EXPECT_NEAR(taxel["width_measured"].get<double>(), taxel["width_fitted"].get<double>(), 2e-5);
  }
  EXPECT_EQ(Json::parse(file_text(folder / "fit/fit.json")), fit);
  for (const char* chart : {"bells.svg", "loading.svg", "residuals.svg"})
    EXPECT_NE(file_text(folder / "fit" / chart).find("taxel 1 recorded"), std::string::npos) << chart;
  const std::string points = file_text(folder / "fit/points.csv");
  EXPECT_EQ(static_cast<std::size_t>(std::count(points.begin(), points.end(), '\n')),
            1 + run["points"].get<std::size_t>());
}

TEST(Fit, RefusesWrongOptionsAndTables) {
  const fs::path folder = test_folder();
  write_strip(folder);
  write_text(folder / "presses.csv", "Sensor_1,Sensor_2,Sensor_3,x,depth\n1,1,1,0,0\n1,1,1,0,0\n");
  const auto refused = [&](const std::vector<std::string>& more, const std::string& line) {
    expect_refusal(taxel(fit_arguments(more), folder), "taxel: " + line);
  };
  refused({"--free", "radios"},
          "fit: --free: \"radios\" is no parameter; there are \"radius\", \"object.radius\", \"thickness\", \"k\", "
          "\"x0\", \"y0\", \"z0\", \"gain\"");
  refused({"--fix", "radius"}, "fit: --fix: \"radius\" must be NAME=VALUE, such as \"radius=6 mm\"");
  refused({"--fix", "radius=-6 mm"}, "fit: --fix: \"radius=-6 mm\" must be greater than 0");
  refused({"--fix", "k=1"}, "fit: --fix: \"k=1\" must be at least 0 and less than 1");
  refused({"--fix", "x0=1 mm"}, "fit: --fix: x0 is free: take it out of --free");
  refused({}, "presses.csv: holds no press: the position along z is 0 m in all rows");
  EXPECT_FALSE(fs::exists(folder / "fit"));
}

// A real recording, with another of the same day that is held out. Taxels in the wrong order or a field of half the
// radius must not pass for it.
TEST(RealRecording, IsDescribedByAFittedStripAndNotByAWrongOne) {
  const fs::path real = fs::path(TAXEL_REAL_DATA) / "recordings/barometers";
  if (!fs::exists(real)) GTEST_SKIP() << real << " is absent";
  const fs::path folder = test_folder();
  write_strip(folder);
  const auto fit = [&](const std::string& columns, const std::vector<std::string>& more) {
    Json map{{"format", "column-mapping"}, {"version", 1}, {"time", "time"}, {"unit", "Pa"}, {"taxels", Json::array()}};
    for (int k = 1; k <= 3; ++k)
      map["taxels"].push_back(
          {{"taxel", k}, {"column", "Sensor_" + columns.substr(static_cast<std::size_t>(k - 1), 1)}});
    write_text(folder / "strip.recmap.json", map.dump());
    std::vector<std::string> arguments{"fit",        (real / "test_full_20230706_175400.csv").string(),
                                       "--hold-out", (real / "test_20230706_170139.csv").string(),
                                       "--layout",   "strip.taxels.json",
                                       "--case",     "ball.json",
                                       "--map",      "strip.recmap.json",
                                       "--pose",     "x=1 um,z=-(1/480) mm"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return taxel_json(arguments, folder);
  };
  const auto passes = [](const Json& run) {
    return run["r2"].get<double>() >= 0.995 && run["rms"].get<double>() <= 0.01 && run["worst"].get<double>() <= 0.08;
  };
  const Json good = fit("123", {"--free", "radius,object.radius,x0,z0,gain"});
  EXPECT_TRUE(passes(good["runs"][1])) << good["runs"][1].dump(1);
  int bells = 0;  // the presses of the other recording end before the right half of the last one
  for (const Json& taxel : good["runs"][1]["taxels"]) {
    if (taxel["width_measured"].is_null()) continue;
    EXPECT_NEAR(taxel["width_fitted"].get<double>() / taxel["width_measured"].get<double>(), 1, 0.065);
    ++bells;
  }
  EXPECT_GE(bells, 2);
  EXPECT_FALSE(passes(fit("321", {"--free", "x0,z0,gain"})["runs"][1])) << "permuted taxels";
  EXPECT_FALSE(passes(fit("123", {"--free", "x0,z0,gain", "--fix", "radius=3 mm"})["runs"][1])) << "half the field";
}

}  // namespace
}  // namespace taxel::test
