// `taxel material`: moduli from data sheets, presets, advice, and a layout that receives the modulus.
#include "cli/taxel_program.h"

namespace taxel::test {
namespace {
namespace fs = std::filesystem;

TEST(MaterialCommand, GivesTheClosedFormsOfThinLayers) {
  const std::vector<std::string> sheet{"material", "--youngs", "60e3", "--poisson", "0.49", "--thickness", "0.002"};
  const Json sliding = taxel_json(sheet);
  EXPECT_NEAR(sliding["modulus"].get<double>(), 6e4 / (1 - 0.49 * 0.49), 1e-6);
  EXPECT_EQ(sliding["bonded"], false);
  EXPECT_EQ(sliding["poisson_limit"], nullptr);
  std::vector<std::string> glued = sheet;
  glued.emplace_back("--bonded");
  const Json bonded = taxel_json(glued);
  EXPECT_NEAR(bonded["modulus"].get<double>(), 6e4 * 0.51 / (1.49 * 0.02), 1e-6);
  EXPECT_EQ(bonded["holds_from"], nullptr);
  EXPECT_NEAR(bonded["poisson_limit"].get<double>(), 0.368, 0.001);
}

TEST(MaterialCommand, SaysForWhichContactsItsModulusHolds) {
  const Outcome outcome = taxel({"material", "--youngs", "60e3", "--poisson", "0.49", "--thickness", "0.002",
                                 "--bonded", "--contact-radius", "0.003"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(
      outcome.out,
      "modulus 165420 Pa of a pad of 0.002 m\n"
      "  E 60000 Pa, nu 0.49, bonded base, contact radius 0.003 m\n"
      "force within 10 % of linear elasticity for contact radii from 0.0024 to 0.00362 m\n"
      "  a thin layer's modulus (1.027e+06 Pa) is too large by more than 10 % at a contact radius of 0.003 m from "
      "nu = 0.364 on\n"
      "  contact radius [m]  right modulus [Pa]  force by this modulus\n"
      "  0.001               1.5548e+05          +6 %\n"
      "  0.002               1.4321e+05          +16 %\n"
      "  0.004               1.9611e+05          -16 %\n"
      "  0.01                4.2166e+05          -61 %\n");
}

TEST(MaterialCommand, ListsElastomersWithTheirSources) {
  const Json presets = taxel_json({"material", "--list"})["presets"];
  ASSERT_EQ(presets.size(), 11U);
  for (const Json& preset : presets) {
    const Json one = taxel_json({"material", "--preset", preset["name"], "--thickness", "0.002"});
    EXPECT_EQ(one["youngs"], preset["youngs"]);
    EXPECT_EQ(one["poisson"], preset["poisson"]);
    EXPECT_FALSE(one["source"].get<std::string>().empty());
    EXPECT_EQ(one["unverified"], preset["unverified"]);
  }
}

TEST(MaterialCommand, TakesTheModulusFromAHardness) {
  const Json shore = taxel_json({"material", "--shore-a", "50", "--thickness", "0.002"});
  EXPECT_NEAR(shore["youngs"].get<double>(), 2.456e6, 1e3);
  EXPECT_LT(shore["youngs_low"].get<double>(), 2.1e6);
  EXPECT_GT(shore["youngs_high"].get<double>(), 2.9e6);
  const Json soft = taxel_json({"material", "--shore-00", "30", "--thickness", "0.002", "--poisson", "0.499"});
  EXPECT_NEAR(soft["youngs"].get<double>(), 1.034e5, 1e3);
  EXPECT_EQ(soft["poisson"], 0.499);
}

TEST(MaterialCommand, WritesModulusAndThicknessIntoALayout) {
  const fs::path folder = test_folder();
  taxel_json({"presets", "dense", "--out", "dense.taxels.json"}, folder);
  fs::create_directory(folder / "soft");
  const Json written =
      taxel_json({"material", "--preset", "ecoflex-00-30", "--thickness", "0.002", "--bonded", "--contact-radius",
                  "0.002", "--layout", "dense.taxels.json", "--out", "soft/dense.taxels.json"},
                 folder);
  Json layout = Json::parse(file_text(folder / "soft" / "dense.taxels.json"));
  EXPECT_EQ(layout["material"]["modulus"], written["modulus"]);
  EXPECT_EQ(layout["material"]["thickness"], 0.002);
  EXPECT_EQ(layout["mesh"]["file"], "../dense.obj");
  EXPECT_EQ(taxel({"check", "soft/dense.taxels.json"}, folder).status, 0);
  // The thickness of the written layout is the default of the next call.
  const Json again = taxel_json({"material", "--preset", "ecoflex-00-30", "--bonded", "--contact-radius", "0.002",
                                 "--layout", "soft/dense.taxels.json", "--out", "soft/again.taxels.json"},
                                folder);
  EXPECT_EQ(again["modulus"], written["modulus"]);
  EXPECT_EQ(file_text(folder / "soft" / "again.taxels.json"), file_text(folder / "soft" / "dense.taxels.json"));
}

TEST(MaterialCommand, NamesBadInput) {
  const fs::path folder = test_folder();
  const auto expect = [&](std::vector<std::string> options, const std::string& message) {
    options.insert(options.begin(), "material");
    expect_refusal(taxel(options, folder), "taxel: material: " + message);
  };
  expect({}, "--youngs: is missing: give --youngs and --poisson, --preset, --shore-a or --shore-00");
  expect({"--youngs", "6e4"}, "--poisson: is missing: it goes with --youngs (rubber: 0.49 to 0.4999)");
  expect({"--youngs", "6e4", "--poisson", "0.4"}, "--thickness: is missing: give the thickness of the layer in metres");
  expect({"--youngs", "6e4", "--poisson", "0.5", "--thickness", "0.002"},
         "--poisson: must be at least 0 and less than 0.5 (rubber: 0.49 to 0.4999), is 0.5");
  expect({"--youngs", "-1", "--poisson", "0.4", "--thickness", "0.002"}, "--youngs: must be greater than 0 Pa, is -1");
  expect({"--youngs", "1", "--poisson", "0.4", "--thickness", "0"}, "--thickness: must be greater than 0 m, is 0");
  expect({"--shore-a", "3", "--thickness", "0.002"}, "--shore-a: must be from 5 to 95, is 3");
  expect({"--youngs", "1", "--poisson", "0.4", "--thickness", "0.002", "--contact-radius", "1"},
         "--contact-radius: must be from 0.0001 to 0.04 m (0.05 to 20 thicknesses), is 1");
  expect({"--out", "f.taxels.json"}, "--out: goes with --layout, the layout that receives the modulus");
  EXPECT_TRUE(fs::is_empty(folder));
  taxel_json({"presets", "fingertip", "--out", "star.taxels.json"}, folder);
  Json star = Json::parse(file_text(folder / "star.taxels.json"));
  star["material"]["field"] = "star";
  write_text(folder / "star.taxels.json", star.dump());
  expect_refusal(
      taxel({"material", "--youngs", "1", "--poisson", "0.4", "--thickness", "0.002", "--layout", "star.taxels.json",
             "--out", "f.taxels.json"},
            folder),
      "taxel: star.taxels.json: /material/field: must be \"pad\": a thickness and this modulus are those of a "
      "pad");
}

}  // namespace
}  // namespace taxel::test
