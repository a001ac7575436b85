// `taxel explain` on recordings: the recorded numbers, the diagnosis, and clear error messages.
#include <algorithm>
#include <cmath>

#include "cli/taxel_program.h"

namespace taxel::test {
namespace {
namespace fs = std::filesystem;

/// Returns a sweep with few samples, whose readings jump.
fs::path coarse_sweep() {
  return shared_box_sweep({"--density", "5e5", "--past", "0.002"});
}

Json explain(const fs::path& run, int taxel, double time) {
  return taxel_json({"explain", run.string(), "--taxel", std::to_string(taxel), "--time", std::to_string(time)});
}

TEST(Explain, ReadsTheRecordedNumbersAndFindsTheNoise) {
  const fs::path run = coarse_sweep();
  const RecordedJump jump = largest_jump(run);
  const Json found = explain(run, jump.taxel, jump.time);
  EXPECT_EQ(found["taxel"]["id"], jump.taxel);
  EXPECT_EQ(found["reading"].get<double>(), jump.after);  // to the last bit
  EXPECT_EQ(found["change"]["before"].get<double>(), jump.before);
  EXPECT_NEAR(found["time"].get<double>(), jump.time, 1e-12);
  EXPECT_EQ(found["verdict"]["cause"], "sampling_noise");
  EXPECT_GT(found["verdict"]["samples_needed"]["factor"].get<double>(), 1.0);
  const Json& v = found["verdict"];
  double sum = 0;
  for (const char* part : {"noise", "field", "cone", "edges", "contact"}) sum += v[part].get<double>();
  EXPECT_NEAR(sum, jump.after - jump.before, 1e-6);
  double share = 0, polygons = 0;
  for (const Json& s : found["samples"]) share += s["share"].get<double>();
  for (const Json& p : found["polygons"]) polygons += p["share"].get<double>();
  EXPECT_NEAR(share, 1, 1e-9);
  EXPECT_NEAR(polygons, 1, 1e-9);
  // The budget is the force of the recorded row, divided into the parts over taxels and over none.
  const Table table = read_csv(run / "readings.csv");
  const Json& budget = found["budget"];
  for (std::size_t row = 0; row < table.at("time").size(); ++row) {
    if (std::abs(table.at("time")[row] - jump.time) > 1e-9) continue;
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR(budget["net"][k].get<double>(), table.at(std::string("force_") + "xyz"[k])[row], 1e-9) << k;
  }
  EXPECT_NEAR(budget["pressed"].get<double>(), budget["covered"].get<double>() + budget["uncovered"].get<double>(),
              1e-9);
  EXPECT_GT(budget["covered"], 0);
  EXPECT_EQ(found["convergence"]["values"][1].get<double>(), jump.after);
  // The exact integral is closer to the reading with four times the samples than the reading with few samples is.
  const double exact = found["exact"]["value"], four = found["convergence"]["values"][2];
  EXPECT_LT(std::abs(four - exact), std::abs(found["convergence"]["values"][0].get<double>() - exact));
}

TEST(Explain, AdvisesOnTheLargestStepOfTheTaxelToo) {
  const fs::path run = coarse_sweep();
  const RecordedJump jump = largest_jump(run);
  const Json v = explain(run, jump.taxel, jump.time - 0.05)["verdict"];
  ASSERT_TRUE(v.contains("worst")) << v.dump();
  EXPECT_NEAR(v["worst"]["time"].get<double>(), jump.time, 1e-12);
  EXPECT_EQ(v["worst"]["change"].get<double>(), jump.after - jump.before);
  EXPECT_NE(v["text"].get<std::string>().find("The largest step of the taxel in the run"), std::string::npos);
  EXPECT_FALSE(explain(run, jump.taxel, jump.time)["verdict"].contains("worst")) << "it is the explained one";
}

// The parts add up to the whole, up to rounding: samples by weight and polygons by force to the reading, samples that
// began and ceased to hit to the change.
TEST(Explain, AddsSamplesAndPolygonsUpToTheRecordedReading) {
  const fs::path run = coarse_sweep();
  const RecordedJump jump = largest_jump(run);
  const Json found = explain(run, jump.taxel, jump.time);
  double weights = 0, sum = 0, before = 0;
  std::map<bool, int> hits;
  for (const Json& s : found["samples"]) {
    const double weight = s["weight"], pressure = s["pressure"];
    EXPECT_GT(weight, 0);
    EXPECT_EQ(s["hit"], pressure > 0);
    EXPECT_EQ(s["hit"], s["depth"] > 0);
    weights += weight, sum += weight * pressure, before += weight * s["pressure_before"].get<double>();
    ++hits[s["hit"]];
  }
  EXPECT_NEAR(sum / weights, jump.after, 1e-9 * jump.after) << "the weighted mean of the paper";
  EXPECT_NEAR(before / weights, jump.before, 1e-9 * jump.after);
  EXPECT_GT(hits[true], 0);
  EXPECT_GT(hits[false], 0);
  for (const Json& s : found["samples"])
    EXPECT_NEAR(s["share"].get<double>(), s["weight"].get<double>() * s["pressure"].get<double>() / sum, 1e-12);

  const Table table = read_csv(run / "readings.csv");
  EXPECT_EQ(found["polygons"].size(), table.at("polygons")[jump.row]);
  double area = 0, share = 0, behind = 0;
  const double pressed = found["budget"]["pressed"];
  for (const Json& p : found["polygons"]) {
    area += p["area"].get<double>(), share += p["force_share"].get<double>(), behind += p["samples"].get<double>();
    EXPECT_LE(p["lowest_pressure"], p["mean_pressure"]);
    EXPECT_LE(p["mean_pressure"], p["highest_pressure"]);
    EXPECT_NEAR(p["area"].get<double>() * p["mean_pressure"].get<double>(), p["force_share"].get<double>() * pressed,
                1e-9 * pressed);
    EXPECT_GE(p["tet"], 0) << "a pad's";
    const Json& taxels = p["taxels"];
    if (p["samples"] > 0) {
      EXPECT_NE(std::find(taxels.begin(), taxels.end(), jump.taxel), taxels.end()) << p.dump();
    }
  }
  EXPECT_NEAR(area, table.at("area")[jump.row], 1e-12 * area);
  EXPECT_NEAR(share, 1, 1e-12);
  EXPECT_EQ(behind, hits[true]);

  const Json& change = found["change"];
  double changed = 0;
  for (const char* part : {"began", "ceased", "stayed"}) changed += change[part]["change"].get<double>();
  EXPECT_NEAR(changed, jump.after - jump.before, 1e-9 * jump.after);
  EXPECT_EQ(change["began"]["count"].get<int>() + change["stayed"]["count"].get<int>(), hits[true]);
}

TEST(Explain, PrintsTheDiagnosisInTheFirstLine) {
  const fs::path run = coarse_sweep();
  const RecordedJump jump = largest_jump(run);
  const Outcome out = taxel({"explain", (run / "readings.npz").string(), "--taxel", std::to_string(jump.taxel),
                             "--time", std::to_string(jump.time)});
  EXPECT_EQ(out.status, 0);
  EXPECT_EQ(out.err, "");
  EXPECT_EQ(out.out.rfind("Sampling noise: ", 0), 0U) << out.out.substr(0, 200);
  for (const char* part : {"polygons in its field", "samples hit, now or before", "force on the sensor, world [N]"})
    EXPECT_NE(out.out.find(part), std::string::npos) << part;
  // Nothing jumps by half of the largest reading.
  const Json calm = taxel_json({"explain", run.string(), "--taxel", std::to_string(jump.taxel), "--time",
                                std::to_string(jump.time), "--jump", "0.5"});
  EXPECT_EQ(calm["verdict"]["cause"], "none");
  const Json first = explain(run, 3, 0);
  EXPECT_TRUE(first["verdict"].is_null());
}

TEST(Explain, RefusesRecordingsThatItCannotExplain) {
  const fs::path run = coarse_sweep(), npz = run / "readings.npz";
  const auto refused = [&](const fs::path& of, const std::vector<std::string>& more, const std::string& line) {
    std::vector<std::string> arguments{"explain", of.string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    expect_refusal(taxel(arguments), line);
  };
  refused(run, {"--taxel", "77", "--time", "1"},
          "taxel: " + npz.string() + ": has no taxel 77, its ids are 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11");
  refused(run, {"--taxel", "3", "--time", "1", "--sensor", "thumb"},
          "taxel: " + npz.string() + ": has no sensor \"thumb\", but finger");
  refused(run, {"--taxel", "3", "--time", "99"},
          "taxel: " + npz.string() + ": begins at 0 s and ends at 1.4 s, requested is 99 s");
  const fs::path folder = test_folder();
  refused(folder, {"--taxel", "3", "--time", "1"}, "taxel: " + (folder / "readings.npz").string() + ": no such file");
  fs::copy(npz, folder);
  refused(folder, {"--taxel", "3", "--time", "1"},
          "taxel: " + (folder / "scene.xml").string() +
              ": is missing: the contact is computed again from the scene next to the recording");
  write_text(folder / "broken.npz", file_text(npz).substr(0, 3000));
  EXPECT_EQ(taxel({"explain", (folder / "broken.npz").string(), "--taxel", "3", "--time", "1"}).status, 2);
}

/// Returns the largest jump of a recording as a fraction of its taxel's own peak, among taxels that read at least 5 %
/// of the largest reading.
RecordedJump largest_own_jump(const fs::path& run, double& fraction) {
  RecordedJump jump;
  double top = 0;
  fraction = 0;
  const Table table = read_csv(run / "readings.csv");
  const auto peak = [](const std::vector<double>& curve) { return *std::max_element(curve.begin(), curve.end()); };
  for (const auto& [head, curve] : table)
    if (head.starts_with("taxel_")) top = std::max(top, peak(curve));
  for (const auto& [head, curve] : table) {
    if (!head.starts_with("taxel_") || peak(curve) < 0.05 * top) continue;
    for (std::size_t row = 1; row < curve.size(); ++row) {
      const double part = std::abs(curve[row] - curve[row - 1]) / peak(curve);
      if (part <= fraction) continue;
      fraction = part;
      jump = {std::stoi(head.substr(6)), table.at("time")[row], row, curve[row - 1], curve[row]};
    }
  }
  return jump;
}

/// The artifact of the paper with few samples: a taxel with small readings jumps by a large fraction of its own peak,
/// which is a small fraction of the sensor's peak. The jump is found, explained as sampling noise, and cured by the
/// number of samples that the diagnosis names.
TEST(Explain, FindsAndCuresTheArtifactOfATaxelWithSmallReadings) {
  const fs::path run = shared_sweep({"--density", "5e5"});
  double fraction = 0;
  const RecordedJump jump = largest_own_jump(run, fraction);
  ASSERT_GT(fraction, 0.1);
  const Json v = explain(run, jump.taxel, jump.time)["verdict"];
  EXPECT_EQ(v["cause"], "sampling_noise") << v["text"];
  EXPECT_GT(std::abs(v["noise"].get<double>()), 0.5 * std::abs(v["change"].get<double>()));
  const double of_taxel =
      0.1 * std::abs(jump.after - jump.before) / fraction;  // a jump is a tenth of the taxel's own peak
  EXPECT_NEAR(v["limit"].get<double>(), of_taxel, 1e-9 * of_taxel);
  const Json of_sensor = taxel_json({"explain", run.string(), "--taxel", std::to_string(jump.taxel), "--time",
                                     std::to_string(jump.time), "--of-sensor"})["verdict"];
  EXPECT_GE(of_sensor["limit"].get<double>(), v["limit"].get<double>());
  ASSERT_TRUE(v["samples_needed"].is_object());
  const double enough = 5e5 * v["samples_needed"]["factor"].get<double>();
  const fs::path cured = test_folder() / "cured";
  taxel_json({"sweep", "--density", std::to_string(enough), "--out", cured.string(), "--quiet"});
  const Json after = explain(cured, jump.taxel, jump.time)["verdict"];
  EXPECT_EQ(after["cause"], "none") << after["text"];
}

}  // namespace
}  // namespace taxel::test
