// The fingertip sweep from end to end: the responding taxels, their smoothness, and reproducible numbers.
#include <algorithm>
#include <array>
#include <cmath>

#include "cli/taxel_program.h"

namespace taxel::test {
namespace {
namespace fs = std::filesystem;

std::string taxel_column(int id) {
  return "taxel_" + std::to_string(id);
}

double peak(const std::vector<double>& values) {
  return *std::max_element(values.begin(), values.end());
}

/// Returns the largest change between two rows, relative to the largest value.
double largest_step(const std::vector<double>& values) {
  double step = 0;
  for (std::size_t i = 1; i < values.size(); ++i) step = std::max(step, std::abs(values[i] - values[i - 1]));
  return step / peak(values);
}

/// The pairs of responding taxels, at +x and -x: tip and middle of the pad, for the paper's finger and its layout.
struct Pair {
  int tip, pad;
};
using Pairs = std::array<Pair, 2>;
constexpr Pairs kPairs{{{4, 3}, {10, 9}}};
constexpr Pairs kPaperPairs{{{4, 3}, {7, 8}}};  // numbers of the released file

bool in_pairs(const Pairs& pairs, int id) {
  return std::any_of(pairs.begin(), pairs.end(), [&](const Pair& p) { return id == p.tip || id == p.pad; });
}

double travel_of_peak(const Table& table, int id) {
  const std::vector<double>& values = table.at(taxel_column(id));
  return table.at("travel")[static_cast<std::size_t>(std::max_element(values.begin(), values.end()) - values.begin())];
}

/// Expects the result of the paper's Figure 4: only the taxels of `tip` and `pad mid` respond, the tip first and more.
/// `bounds` are the smallest and largest ratio of the pad's peak to the tip's peak.
void expect_the_four(const Table& table, const Pairs& pairs, std::pair<double, double> bounds) {
  std::vector<double> peaks;
  for (int id = 0; id < 12; ++id) peaks.push_back(peak(table.at(taxel_column(id))));
  const double largest = peak(peaks);
  ASSERT_GT(largest, 0);
  for (int id = 0; id < 12; ++id) {
    const double part = peaks[static_cast<std::size_t>(id)] / largest;
    if (in_pairs(pairs, id)) {
      EXPECT_GT(part, 0.05) << "taxel " << id;
    } else {
      EXPECT_LT(part, 0.02) << "taxel " << id;
    }
  }
  for (const Pair& pair : pairs) {
    const double ratio = peaks[static_cast<std::size_t>(pair.pad)] / peaks[static_cast<std::size_t>(pair.tip)];
    EXPECT_GT(ratio, bounds.first);
    EXPECT_LT(ratio, bounds.second);
    const double later = travel_of_peak(table, pair.pad) - travel_of_peak(table, pair.tip);
    EXPECT_GT(later, 0.002);
    EXPECT_LT(later, 0.006);
  }
}

/// Expects every curve to begin and end at exactly 0, with steps of at most `most` times its own peak.
void expect_smooth_bells(const Table& table, const Pairs& pairs, double most) {
  for (int id = 0; id < 12; ++id) {
    EXPECT_EQ(table.at(taxel_column(id)).front(), 0) << "taxel " << id;
    EXPECT_EQ(table.at(taxel_column(id)).back(), 0) << "taxel " << id;
    if (in_pairs(pairs, id)) {
      EXPECT_LE(largest_step(table.at(taxel_column(id))), most) << "taxel " << id;
    }
  }
  for (const char* force : {"force_x", "force_y", "force_z"}) EXPECT_EQ(table.at(force).back(), 0);
}

/// Expects `count` rows at uniform travel and time.
void expect_rows(const Table& table, std::size_t count) {
  const std::vector<double>& travel = table.at("travel");
  ASSERT_EQ(travel.size(), count);
  EXPECT_EQ(table.at("time").front(), 0);
  EXPECT_EQ(travel.front(), 0);
  for (std::size_t i = 0; i < travel.size(); ++i) {
    EXPECT_NEAR(travel[i], 1e-4 * static_cast<double>(i), 1e-15);
    EXPECT_NEAR(table.at("time")[i], 0.01 * static_cast<double>(i), 1e-12);
  }
}

/// Compares `taxel read` on the poses of a row with the row.
void expect_row_again(const fs::path& sweep, std::size_t row) {
  const auto arrays = parse_npz(file_text(sweep / "readings.npz"));
  const auto part = [&](const char* name, std::size_t width) {
    const std::vector<double> all = arrays.at(name).doubles();
    const auto begin = all.begin() + static_cast<std::ptrdiff_t>(row * width);
    return std::vector<double>(begin, begin + static_cast<std::ptrdiff_t>(width));
  };
  ASSERT_EQ(arrays.at("object_names").texts(), std::vector<std::string>{"box"});
  const Json contact_case = {
      {"format", "contact-case"},
      {"version", 1},
      {"a", {{"layout", "finger.taxels.json"}, {"pos", part("sensor_pos", 3)}, {"quat", part("sensor_quat", 4)}}},
      {"b",
       {{"shape", {{"type", "box"}, {"size", {0.025, 0.025, 0.025}}}},
        {"pos", part("object_pos", 3)},
        {"quat", part("object_quat", 4)}}}};
  const fs::path file = test_folder() / "row.json";
  write_text(file, contact_case.dump());
  const Json read = taxel_json({"read", (sweep / "finger.taxels.json").string(), file.string()});
  EXPECT_EQ(read["readings"]["weighted_mean"].get<std::vector<double>>(), part("readings", 12)) << "row " << row;
  EXPECT_EQ(read["area"].get<double>(), part("area", 1)[0]);
  EXPECT_EQ(read["polygons"].get<std::int64_t>(), arrays.at("polygons").integers()[row]);
}

/// Checks the weighted means of the taxels over their samples.
void expect_figure_4(const fs::path& sweep, const Pairs& pairs = kPairs) {
  const Table table = read_csv(sweep / "readings.csv");
  expect_rows(table, 501);
  expect_the_four(table, pairs, {0.12, 0.42});
  expect_smooth_bells(table, pairs, 0.09);
}

/// Checks the exact force on each taxel's field, which has no sampling noise. The contact area on the pad is larger.
void expect_exact_figure_4(std::vector<std::string> options, const Pairs& pairs = kPairs) {
  options.insert(options.end(), {"--aggregate", "force"});
  const Table table = read_csv(shared_sweep(options) / "readings.csv");
  expect_rows(table, 501);
  expect_the_four(table, pairs, {0.12, 1.0});
  expect_smooth_bells(table, pairs, 0.07);
}

TEST(Sweep, MakesFourTaxelsRiseAndFall) {
  expect_figure_4(shared_sweep());
}

TEST(Sweep, MakesFourTaxelsRiseAndFallByTheExactForce) {
  expect_exact_figure_4({});
}

TEST(Sweep, MakesFourTaxelsRiseAndFallOnTheRealMesh) {
  SKIP_WITHOUT_REAL_DATA();
  expect_figure_4(shared_sweep({"--layout", real_layout().string()}));
}

TEST(Sweep, MakesFourTaxelsRiseAndFallOnTheRealMeshByTheExactForce) {
  SKIP_WITHOUT_REAL_DATA();
  expect_exact_figure_4({"--layout", real_layout().string()});
}

/// Returns the options that name the paper's own files, or nothing if the files are absent.
std::vector<std::string> paper_files() {
  const fs::path folder = fs::path(TAXEL_REAL_DATA) / "paper";
  if (!fs::exists(folder / "curved_fingertip.yaml")) return {};
  return {"--layout", (folder / "curved_fingertip.yaml").string(),
          "--mesh",   (folder / "ubi_tip_collision.stl").string(),
          "--scale",  "0.001"};
}

TEST(Sweep, MakesFourTaxelsRiseAndFallOnThePapersFiles) {
  SKIP_WITHOUT_REAL_DATA();
  // The noise of the file's 1e6 samples per m^2 is as large as the steps of the contact.
  std::vector<std::string> options = paper_files();
  options.insert(options.end(), {"--density", "1e7"});
  expect_figure_4(shared_sweep(options), kPaperPairs);
  expect_exact_figure_4(options, kPaperPairs);
}

/// Expects peaks of 1.0 for the pairs `first`, `ratio` for `second` and at most 0.06 for the others. All curves begin
/// and end at 0, and no step over `kRowsApart` rows, at most 0.2 mm, exceeds 3 % of the taxel's own peak.
void expect_released_demo(const fs::path& sweep, std::pair<int, int> first, std::pair<int, int> second, double ratio,
                          double others) {
  constexpr std::size_t kRowsApart = 2;
  const Table table = read_csv(sweep / "readings.csv");
  const std::vector<double>& travel = table.at("travel");
  ASSERT_EQ(travel.size(), 1001U);
  double longest = 0;
  for (std::size_t i = kRowsApart; i < travel.size(); ++i)
    longest = std::max(longest, travel[i] - travel[i - kRowsApart]);
  EXPECT_LT(longest, 0.0002);
  double largest = 0;
  for (int id = 0; id < 12; ++id) largest = std::max(largest, peak(table.at(taxel_column(id))));
  for (int id = 0; id < 12; ++id) {
    const std::vector<double>& values = table.at(taxel_column(id));
    EXPECT_EQ(values.front(), 0) << "taxel " << id;
    EXPECT_EQ(values.back(), 0) << "taxel " << id;
    const bool is_first = id == first.first || id == first.second;
    if (is_first || id == second.first || id == second.second) {
      EXPECT_NEAR(peak(values) / largest, is_first ? 1.0 : ratio, 0.03) << "taxel " << id;
      for (std::size_t i = kRowsApart; i < values.size(); ++i)
        ASSERT_LE(std::abs(values[i] - values[i - kRowsApart]), 0.03 * peak(values)) << "taxel " << id << " row " << i;
    } else {
      EXPECT_LE(peak(values), others * largest) << "taxel " << id;
    }
  }
}

TEST(Sweep, ReproducesThePapersResultOnItsOwnFiles) {
  SKIP_WITHOUT_REAL_DATA();
  std::vector<std::string> options = paper_files();
  options.emplace_back("--as-in-the-paper");
  expect_released_demo(shared_sweep(options), {4, 7}, {3, 8}, 0.84, 0.06);
}

TEST(Sweep, RisesAndFallsOnOurFingerWithThePapersSetting) {
  // Our finger is rounder than the paper's, so the middle of the pad reads as much as the tip.
  expect_released_demo(shared_sweep({"--as-in-the-paper"}), {3, 9}, {4, 10}, 0.985, 0.12);
}

TEST(Sweep, StaysOnTheTopOfABox) {
  const Table table = read_csv(shared_box_sweep() / "readings.csv");
  expect_rows(table, 241);
  EXPECT_GT(table.at("force_z").back(), 0);
  for (const int id : {3, 4, 9, 10}) EXPECT_LE(largest_step(table.at(taxel_column(id))), 0.10) << "taxel " << id;
}

/// Writes a layout of our fingertip with geodesic fields, taxel 3 as two subtaxels and taxel 4 as one.
fs::path geodesic_layout() {
  Json layout = Json::parse(file_text(fingertip_layout()));
  layout["mesh"]["file"] = (fs::path(TAXEL_SOURCE_DIR) / "assets/meshes/fingertip.obj").string();
  layout["sampling"]["density"] = 2e6;
  layout["receptive_field"]["metric"] = "geodesic";
  const auto part = [](const Json& taxel, double dz, double radius) {
    Json center = taxel["center"];
    center[2] = center[2].get<double>() + dz;
    return Json{{"center", center}, {"normal", taxel["normal"]}, {"radius", radius}};
  };
  Json& third = layout["taxels"][3];
  third["subtaxels"] = {part(third, -0.002, 0.003), part(third, 0.002, 0.0035)};
  Json& fourth = layout["taxels"][4];
  fourth["subtaxels"] = Json::array({part(fourth, 0.0, 0.004)});
  const fs::path file = fs::path(TAXEL_BINARY_DIR) / "geodesic_fingertip.taxels.json";
  write_text(file, layout.dump());
  return file;
}

/// Writes a layout of our fingertip with few samples, with or without a calibration.
fs::path coarse_layout(const char* name, const Json& calibration) {
  Json layout = Json::parse(file_text(fingertip_layout()));
  layout["mesh"]["file"] = (fs::path(TAXEL_SOURCE_DIR) / "assets/meshes/fingertip.obj").string();
  layout["sampling"]["density"] = 1e6;
  if (!calibration.is_null()) layout["calibration"] = calibration;
  const fs::path file = fs::path(TAXEL_BINARY_DIR) / name;
  write_text(file, layout.dump());
  return file;
}

TEST(Sweep, WritesCalibratedValuesAndKeepsTheReadings) {
  const fs::path plain = shared_box_sweep({"--layout", coarse_layout("coarse.taxels.json", {}).string()});
  const Json calibration = {{"unit", "V"},     {"gain", 1e-3},
                            {"range", {0, 3}}, {"quantisation", {{"bits", 8}}},
                            {"rate", 50},      {"taxels", {{{"id", 9}, {"gain", 2e-3}}, {{"id", 10}, {"dead", -1}}}}};
  const fs::path sweep = shared_box_sweep({"--layout", coarse_layout("calibrated.taxels.json", calibration).string()});
  EXPECT_EQ(file_text(sweep / "readings.csv"), file_text(plain / "readings.csv"));  // raw readings are unchanged
  EXPECT_FALSE(fs::exists(plain / "calibrated.csv"));
  const Table raw = read_csv(sweep / "readings.csv"), table = read_csv(sweep / "calibrated.csv");
  EXPECT_EQ(table.size(), 14U);  // time, travel, 12 taxels
  EXPECT_EQ(table.at("time"), raw.at("time"));
  EXPECT_EQ(table.at("travel"), raw.at("travel"));
  const double q = 3.0 / 255;
  for (int id = 0; id < 12; ++id) {
    const std::vector<double>&p = raw.at(taxel_column(id)), &v = table.at(taxel_column(id));
    const double gain = id == 9 ? 2e-3 : 1e-3;
    for (std::size_t i = 0; i < v.size(); ++i) {
      // 50 values but 100 rows each second: every second row repeats a value
      const double expected = q * std::round(std::min(gain * p[i - i % 2], 3.0) / q);
      EXPECT_NEAR(v[i], id == 10 ? -1 : expected, 1e-12) << "taxel " << id << ", row " << i;
    }
  }
  EXPECT_GT(peak(table.at(taxel_column(9))), 0.1);
  auto arrays = parse_npz(file_text(sweep / "readings.npz"));
  EXPECT_EQ(arrays.at("calibrated").shape, arrays.at("readings").shape);
  EXPECT_EQ(arrays.at("calibrated").doubles()[12 * 120 + 9], table.at(taxel_column(9))[120]);
  EXPECT_EQ(arrays.at("calibrated_unit").texts(), std::vector<std::string>{"V"});
  EXPECT_EQ(Json::parse(arrays.at("layout").texts()[0])["calibration"]["rate"], 50);
}

TEST(Sweep, ReadsGeodesicFieldsAndSubtaxels) {
  const fs::path layout = geodesic_layout();
  const fs::path sweep = shared_box_sweep({"--layout", layout.string()});
  const Table table = read_csv(sweep / "readings.csv");
  for (const int id : {3, 4, 9, 10}) EXPECT_GT(peak(table.at(taxel_column(id))), 100) << "taxel " << id;
  for (const std::size_t row : {100U, 180U}) expect_row_again(sweep, row);

  const fs::path fields = test_folder() / "fields.csv", samples = test_folder() / "samples.csv";
  taxel_json({"samples", layout.string(), "--quiet", "--out", samples.string(), "--fields", fields.string()});
  const Table s = read_csv(samples), f = read_csv(fields);
  const Json taxels = Json::parse(file_text(layout))["taxels"];
  int of_subtaxels = 0, longer = 0;
  for (std::size_t e = 0; e < f.at("sample").size(); ++e) {
    const auto i = static_cast<std::size_t>(f.at("sample")[e]);
    const Json& taxel = taxels[static_cast<std::size_t>(f.at("taxel")[e])];
    const Json discs = taxel["subtaxels"].empty() ? Json::array({taxel}) : taxel["subtaxels"];
    const double d = f.at("distance")[e], weight = f.at("weight")[e];
    bool found = false;
    for (const Json& disc : discs) {
      const double reach = disc["radius"].get<double>() - d;
      found |= reach >= 0 && std::abs(weight - reach * reach) < 1e-18;
      double straight = 0;
      for (const auto& [axis, c] : {std::pair("x", 0U), std::pair("y", 1U), std::pair("z", 2U)})
        straight += std::pow(s.at(axis)[i] - disc["center"][c].get<double>(), 2);
      longer += d > 1.01 * std::sqrt(straight);
    }
    EXPECT_TRUE(found) << "entry " << e;
    of_subtaxels += !taxel["subtaxels"].empty();
  }
  EXPECT_GT(of_subtaxels, 100);
  EXPECT_GT(longer, 500) << "paths go around the finger";
}

TEST(Sweep, GivesARowThatReadRepeatsExactly) {
  for (const std::size_t row : {0U, 125U, 240U}) expect_row_again(shared_box_sweep(), row);
}

TEST(Sweep, GivesARowThatReadRepeatsExactlyOnTheRealMesh) {
  SKIP_WITHOUT_REAL_DATA();
  expect_row_again(shared_box_sweep({"--layout", real_layout().string()}), 150);
}

TEST(Sweep, HasSmallerStepsWithMoreSamples) {
  // The largest step of one taxel varies by a fifth by chance, so the test uses the largest and the mean of all four.
  struct Steps {
    double largest = 0, mean = 0;
  };
  const auto steps = [](const char* density) {
    const Table table = read_csv(shared_box_sweep({"--density", density}) / "readings.csv");
    Steps s;
    for (const int id : {3, 4, 9, 10}) {
      const double step = largest_step(table.at(taxel_column(id)));
      s.largest = std::max(s.largest, step);
      s.mean += step / 4;
    }
    return s;
  };
  const Steps coarse = steps("1e6"), middle = steps("4e6"), fine = steps("1.6e7");
  EXPECT_LT(middle.largest, coarse.largest);
  EXPECT_LT(fine.largest, middle.largest);
  EXPECT_LT(middle.mean, coarse.mean);
  EXPECT_LT(fine.mean, middle.mean);
}

TEST(Sweep, GivesTheSameBytesWithAnyNumberOfThreads) {
  const fs::path first = shared_sweep();
  const fs::path folder = test_folder();
  const Outcome outcome = taxel({"sweep", "--quiet", "--threads", "1", "--out", "again"}, folder);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder / "again")) names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  EXPECT_EQ(names, (std::vector<std::string>{"finger.obj", "finger.taxels.json", "object.obj", "readings.csv",
                                             "readings.npz", "scene.xml", "sweep.json"}));
  for (const std::string& name : names) {
    EXPECT_TRUE(file_text(first / name) == file_text(folder / "again" / name)) << name << " differs";
  }
}

TEST(Sweep, WritesTheSameValuesToNpzAndCsv) {
  const Table table = read_csv(shared_box_sweep() / "readings.csv");
  const auto arrays = parse_npz(file_text(shared_box_sweep() / "readings.npz"));
  const std::vector<double> readings = arrays.at("readings").doubles(), force = arrays.at("force").doubles();
  ASSERT_EQ(arrays.at("readings").shape, (std::vector<std::size_t>{241, 12}));
  for (std::size_t row = 0; row < 241; ++row) {
    for (std::size_t k = 0; k < 12; ++k) {
      EXPECT_EQ(readings[12 * row + k], table.at(taxel_column(static_cast<int>(k)))[row]);
    }
    EXPECT_EQ(force[3 * row + 2], table.at("force_z")[row]);
  }
  EXPECT_EQ(arrays.at("travel").doubles(), table.at("travel"));
  const std::size_t steps = arrays.at("mocap_pos").shape.at(0);
  EXPECT_EQ(steps, 2401U);
  EXPECT_EQ(arrays.at("mocap_quat").shape, (std::vector<std::size_t>{steps, 4}));
  const std::vector<double> mocap = arrays.at("mocap_pos").doubles();
  const std::vector<std::int64_t> step = arrays.at("step").integers();
  for (std::size_t row = 0; row < 241; ++row) {  // the distance of the mocap body is the row's travel
    const auto at = 3 * static_cast<std::size_t>(step[row]);
    EXPECT_NEAR(std::hypot(mocap[at] - mocap[0], mocap[at + 1] - mocap[1], mocap[at + 2] - mocap[2]),
                table.at("travel")[row], 1e-15);
  }
  EXPECT_EQ(arrays.at("seed").integers(), std::vector<std::int64_t>{42});
  EXPECT_EQ(Json::parse(arrays.at("layout").texts()[0])["format"], "taxel-layout");
}

TEST(Sweep, GivesTheForceOfASoftlyAttachedFinger) {
  const Json sweep = Json::parse(file_text(shared_box_sweep() / "sweep.json"));
  const Table table = read_csv(shared_box_sweep() / "readings.csv");
  const Json& sensor = sweep["sensors"][0];
  double largest = 0;
  for (std::size_t i = 0; i < 241; ++i) {
    largest = std::max(largest, std::hypot(table.at("force_x")[i], table.at("force_y")[i], table.at("force_z")[i]));
  }
  EXPECT_DOUBLE_EQ(sensor["largest_force"].get<double>(), largest);
  EXPECT_GT(sensor["deflection"].get<double>(), 1e-6);    // the body is dynamic and softly attached
  EXPECT_LT(sensor["deflection"].get<double>(), 1.5e-4);  // and the body reaches nine tenths of the depth
  EXPECT_LT(sensor["deflection_deg"].get<double>(), 2);
  EXPECT_GT(table.at("force_z").back(), 0);
}

TEST(Sweep, ReadsItsScenarioFileAndOptionsOverrideIt) {
  const fs::path folder = test_folder();
  const std::vector<std::string> shorter{"--object", "box",    "--before",  "0.0005",
                                         "--past",   "0.0005", "--density", "2e5"};
  const auto sweep = [&](std::vector<std::string> options) {
    options.insert(options.begin(), "sweep");
    options.insert(options.end(), shorter.begin(), shorter.end());
    return taxel_json(options, folder);
  };
  const Json first = sweep({"--depth", "0.001", "--speed", "0.02", "--tilt", "30", "--seed", "7", "--out", "out"});
  EXPECT_EQ(first["scenario"]["depth"], 0.001);
  EXPECT_EQ(first["seed"], 7);
  EXPECT_EQ(first["rows"], 11);
  EXPECT_EQ(first["steps"], 51);
  const Json second = sweep({"--scenario", "out/sweep.json", "--depth", "0.0005"});
  EXPECT_EQ(second["scenario"]["speed"], 0.02);
  EXPECT_EQ(second["scenario"]["tilt_deg"], 30.0);
  EXPECT_EQ(second["scenario"]["depth"], 0.0005);
  EXPECT_LT(second["sensors"][0]["largest_force"].get<double>(), first["sensors"][0]["largest_force"].get<double>());
}

TEST(Sweep, WritesAFolderThatRunsElsewhere) {
  const fs::path folder = test_folder();
  fs::copy(shared_sweep({"--density", "1e6"}), folder / "moved");
  const Json run = taxel_json({"run", "moved/scene.xml", "--seconds", "0.005", "--out", "out"}, folder);
  EXPECT_EQ(run["rows"], 5);
  EXPECT_EQ(run["sensors"][0]["geom"], "finger");
  const Table table = read_csv(folder / "out" / "readings.csv");
  EXPECT_EQ(table.at("travel"), std::vector<double>(5, 0.0));  // the mocap body does not move here
  EXPECT_TRUE(fs::exists(folder / "out" / "scene.xml"));
}

TEST(Sweep, ReportsThePartsOfItsWallTime) {
  const std::vector<std::string> options{"sweep", "--quiet",  "--density", "1e6",    "--object",
                                         "box",   "--before", "0.002",     "--past", "0.002"};
  const Json sweep = taxel_json(options);
  const Json& parts = sweep["wall_parts"];
  double sum = 0;
  for (const char* part : {"surfaces", "forces", "readings", "rest"}) {
    EXPECT_GT(parts[part].get<double>(), 0) << part;
    sum += parts[part].get<double>();
  }
  EXPECT_NEAR(sum, sweep["wall_seconds"].get<double>(), 1e-12);
  EXPECT_NE(taxel(options).out.find("of it contact surfaces "), std::string::npos);
}

}  // namespace
}  // namespace taxel::test
