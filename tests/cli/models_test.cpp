// `taxel models` on recordings: curves, table and errors.
#include <algorithm>
#include <cmath>

#include "cli/taxel_program.h"

namespace taxel::test {
namespace {
namespace fs = std::filesystem;

fs::path sweep_to_compare() {
  return shared_box_sweep({"--density", "5e5", "--past", "0.002"});
}

TEST(Models, GivesCurvesAndATableOfTheRecording) {
  const fs::path run = sweep_to_compare(), out = test_folder() / "models.csv";
  const Json found = taxel_json({"models", run.string(), "--every", "8", "--out", out.string()});
  const Table recorded = read_csv(run / "readings.csv"), curves = read_csv(out);
  ASSERT_EQ(found["taxels"].size(), 12U);
  ASSERT_EQ(found["models"].size(), 6U);
  for (const Json& model : found["models"]) EXPECT_TRUE(model["missing"].is_null()) << model.dump();
  const std::vector<double>& time = curves.at("time");
  ASSERT_EQ(found["rows"], time.size());
  EXPECT_EQ(time.size(), (recorded.at("time").size() + 7) / 8);
  for (const int id : {3, 4, 10}) {
    const std::vector<double>& reading = curves.at("reading_" + std::to_string(id));
    for (std::size_t i = 0; i < time.size(); ++i)
      EXPECT_EQ(reading[i], recorded.at("taxel_" + std::to_string(id))[8 * i]) << "to the last bit";
  }
  const Json& of = found["taxels"][10]["models"];
  const std::vector<double>& exact = curves.at("exact_10");
  EXPECT_EQ(of["exact"]["peak"].get<double>(), *std::max_element(exact.begin(), exact.end()));
  EXPECT_NEAR(of["exact"]["correlation"].get<double>(), 1, 1e-12);
  EXPECT_NEAR(of["exact"]["rms"].get<double>(), 0, 1e-6);
  EXPECT_GT(of["reading"]["correlation"].get<double>(), 0.95);
  EXPECT_LT(of["reading"]["rms"].get<double>(), 0.2);
  EXPECT_GT(of["star"]["peak"].get<double>(), 0);
  EXPECT_GT(of["tactile"]["peak"].get<double>(), 1e-5);
  EXPECT_GT(of["tactile"]["correlation"].get<double>(), 0.9);
  EXPECT_LT(of["tactile"]["peak"].get<double>(), 5e-3);
  // MuJoCo's contact points carry the force of the contact, so no taxel reads more than this force.
  double force = 0;
  for (std::size_t i = 0; i < recorded.at("time").size(); i += 8)
    force =
        std::max(force, std::hypot(recorded.at("force_x")[i], recorded.at("force_y")[i], recorded.at("force_z")[i]));
  EXPECT_GT(of["touch"]["peak"].get<double>(), 0.1 * force);
  EXPECT_LT(of["touch"]["peak"].get<double>(), 1.001 * force);
}

TEST(Models, PrintsATable) {
  const Outcome out = taxel({"models", sweep_to_compare().string(), "--every", "40"});
  EXPECT_EQ(out.status, 0) << out.err;
  EXPECT_EQ(out.err, "");
  for (const char* part : {"taxel model", "weighted_sum", "tactile", "Pa m^2", "no reading at taxels 0, 1"})
    EXPECT_NE(out.out.find(part), std::string::npos) << part << "\n" << out.out;
}

TEST(Models, RefusesBadRecordingsAndOptions) {
  const fs::path run = sweep_to_compare(), folder = test_folder();
  expect_refusal(taxel({"models", run.string(), "--sensor", "thumb"}),
                 "taxel: " + (run / "readings.npz").string() + ": has no sensor \"thumb\", but finger");
  fs::copy(run / "readings.npz", folder);
  expect_refusal(taxel({"models", folder.string()}),
                 "taxel: " + (folder / "scene.xml").string() +
                     ": is missing: the contact is computed again from the scene next to the recording");
  EXPECT_EQ(taxel({"models", run.string(), "--every", "0"}).status, 2);
  expect_refusal(taxel({"models", run.string(), "--out", "/nowhere/at/all.csv"}),
                 "taxel: /nowhere/at/all.csv: cannot be written: its folder does not exist");
}

}  // namespace
}  // namespace taxel::test
